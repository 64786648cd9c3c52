// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/obstacles/ray_class.hpp>

namespace slamicp {
namespace {

constexpr double farthest_wall = 30.0;  // from a thing to the wall behind it [m]

}  // namespace

const char* to_string(RayClass ray_class) noexcept {
  switch (ray_class) {
    case RayClass::obstacle:
      return "obstacle";
    case RayClass::gone:
      return "gone";
    case RayClass::unmapped:
      return "unmapped";
    case RayClass::unknown:
      return "unknown";
  }
  return "?";
}

RayClassifier::RayClassifier(const IndexedPoints<2>& map, double tolerance) noexcept
    : checker_(map, RayChecker::usual_distance, tolerance), tolerance_(tolerance) {}

RayClass RayClassifier::operator()(const Point2& from, const Point2& to) const noexcept {
  const double length = (to - from).norm();
  if (!(length > 0.0) || !std::isfinite(length)) return RayClass::unknown;
  const Vector<2> direction = (to - from) / length;
  bool is_doubtful = false;
  for (double start = 0.0;;) {
    const WallMet wall = checker_.first_wall(from, direction, start, length + farthest_wall);
    if (!wall.met) break;
    const double behind = (length - wall.distance) * (wall.steepness > 0.0 ? wall.steepness : 1.0);
    if (behind < -tolerance_) return RayClass::obstacle;
    if (behind > tolerance_ && wall.sure()) return RayClass::gone;
    is_doubtful = true;
    start = std::max(wall.distance, start) + RayChecker::usual_distance;
  }
  if (is_doubtful) return RayClass::unknown;
  return has_walls_beside(to, direction) ? RayClass::obstacle : RayClass::unmapped;
}

/// True for a place inside what was mapped, as seen from a ray that leaves it.
bool RayClassifier::has_walls_beside(const Point2& place, const Vector<2>& direction) const noexcept {
  const Vector<2> left(-direction.y(), direction.x());
  return checker_.first_wall(place, left, 0.0, farthest_wall).met &&
         checker_.first_wall(place, -left, 0.0, farthest_wall).met;
}

Point2 ray_origin(const Fix& fix, const LaserScan& scan, std::size_t point) noexcept {
  const std::size_t laser = fix.scan.scans.empty() ? 0 : static_cast<std::size_t>(fix.scan.scans[point]);
  return laser < fix.ray_origins.size() ? fix.ray_origins[laser] : scan.T_robot_laser.translation();
}

std::vector<RayClass> classify_outliers(const Fix& fix, const LaserScan& scan) {
  std::vector<RayClass> classes(fix.outliers().size(), RayClass::unknown);
  if (!fix.map) return classes;
  constexpr double tolerance = 0.03;  // [m], far below an outlier's distance
  const RayClassifier classify(fix.map->indexed(), tolerance);
  for (std::size_t k = 0; k < classes.size(); ++k) {
    const auto point = static_cast<std::size_t>(fix.outliers()[k]);
    classes[k] = classify(fix.pose * ray_origin(fix, scan, point), fix.pose * fix.scan.in_robot[point]);
  }
  return classes;
}

}  // namespace slamicp
