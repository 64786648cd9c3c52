// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// A part of the plane where nothing counts as an obstacle: the robot's own parts, the dock that it drives into.
struct ExclusionZone {
  std::vector<Point2> corners;  ///< of a polygon, in order round it, three at least [m]
  bool in_robot = true;         ///< it moves with the robot; else it lies in the map

  /// True where the point is in it. O(corners).
  bool contains(const Point2& in_map, const Pose2& T_map_robot) const noexcept;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

}  // namespace slamicp
