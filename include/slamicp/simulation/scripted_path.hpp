// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// A smooth curve through waypoints, read by the distance travelled: the natural cubic spline over the chord length.
/// The heading is the curve's direction. Only a script for simulated drives; a robot's path tracking is elsewhere.
class ScriptedPath {
 public:
  /// Throws Error for fewer than two waypoints, coordinates that are not finite, and the same waypoint twice in a row.
  explicit ScriptedPath(std::span<const Point2> waypoints);

  /// From the first waypoint to the last, along the curve [m].
  double length() const noexcept { return distances_.back(); }

  /// Where a robot is after `distance` metres, clamped to the curve's ends. O(log length).
  Pose2 at(double distance) const noexcept;

 private:
  PointCloud2 knots_;
  std::vector<double> parameters_;  // chord length at each knot
  PointCloud2 second_derivatives_;  // at each knot, by chord length
  std::vector<double> distances_;   // arc length, tabled at equal steps of the chord length
  double table_step_ = 0.0;
};

}  // namespace slamicp
