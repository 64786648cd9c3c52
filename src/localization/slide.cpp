// SPDX-License-Identifier: Apache-2.0
#include "localization/slide.hpp"

#include <algorithm>
#include <cmath>

namespace slamicp {

Slide::Slide(const PointMap2& map, PointView<2> scan, const Pose2& pose, double match_distance) noexcept
    : map_(map), match_distance_(match_distance) {
  const RigidTransform<2> T_map_robot(pose);
  std::size_t seen = 0;
  for (const Point2& point : scan) {
    const Point2 in_map = T_map_robot * point;
    if (!is_finite<2>(in_map) || map_.indexed().nearest(in_map, match_distance_).found()) continue;
    // Some of all where they are many: the later ones take the places of earlier ones in turn.
    unmatched_[count_ < most ? count_++ : (7 * seen) % most] = in_map;
    ++seen;
  }
}

std::size_t Slide::matched(const Vector<2>& shift) const noexcept {
  const auto is_matched = [&](const Point2& point) {
    return map_.indexed().nearest(point + shift, 0.5 * match_distance_).found();
  };
  return static_cast<std::size_t>(
      std::count_if(unmatched_.begin(), unmatched_.begin() + static_cast<std::ptrdiff_t>(count_), is_matched));
}

std::optional<double> Slide::best_shift(const Vector<2>& direction, double reach) const noexcept {
  if (count_ < fewest) return {};
  const double step = 0.5 * match_distance_;
  const int steps = static_cast<int>(std::ceil(std::min(reach, 100.0 * step) / step));
  std::size_t best = 0;
  double best_shift = 0.0;
  // From near to far: of equals the nearest.
  for (int k = 1; k <= steps; ++k)
    for (const double shift : {k * step, -k * step})
      if (const std::size_t count = matched(shift * direction); count > best) {
        best = count;
        best_shift = shift;
      }
  if (best < std::max(fewest, count_ / 2)) return {};
  return best_shift;
}

}  // namespace slamicp
