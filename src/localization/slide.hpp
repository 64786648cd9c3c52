// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include <slamicp/map/point_map.hpp>

namespace slamicp {

/// Where a robot may be that has slid along a direction that nothing held: what its scan shows and the map does not
/// have here, an end of a corridor, may be what the map has further on.
class Slide {
 public:
  /// @param scan  in the robot's frame  @param pose  T_map_robot, sure but for one direction
  /// @param match_distance  closer to the map than this a point is matched [m]
  Slide(const PointMap2& map, PointView<2> scan, const Pose2& pose, double match_distance) noexcept;

  /// The shift along `direction` (unit vector in the map) within `reach` [m] to either side at which most of the points
  /// without a match get one; none where few do.
  std::optional<double> best_shift(const Vector<2>& direction, double reach) const noexcept;

 private:
  static constexpr std::size_t most = 64;
  static constexpr std::size_t fewest = 8;

  std::size_t matched(const Vector<2>& shift) const noexcept;

  const PointMap2& map_;
  double match_distance_;
  std::array<Point2, most> unmatched_{};  // in the map, at the pose
  std::size_t count_ = 0;
};

}  // namespace slamicp
