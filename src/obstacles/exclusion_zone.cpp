// SPDX-License-Identifier: Apache-2.0
#include <slamicp/obstacles/exclusion_zone.hpp>

namespace slamicp {

std::string ExclusionZone::problem() const {
  if (corners.size() < 3) return "an exclusion zone needs at least three corners";
  for (const Point2& corner : corners)
    if (!is_finite<2>(corner)) return "the corners of an exclusion zone must be finite";
  return {};
}

bool ExclusionZone::contains(const Point2& in_map, const Pose2& T_map_robot) const noexcept {
  const Point2 point =
      in_robot ? Point2(T_map_robot.rotation().transpose() * (in_map - T_map_robot.translation())) : in_map;
  bool inside = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    // Sides that a line from the point to the right crosses: an odd number from inside.
    const Point2& a = corners[k];
    const Point2& b = corners[(k + 1) % corners.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

}  // namespace slamicp
