// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/geometry/pose.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// How a planar laser sits on the robot, seen from above.
struct LaserMount {
  Pose2 T_robot_laser;
  bool upside_down = false;  ///< its beams turn the other way
  double tilt = 0.0;         ///< between its axis and the vertical [rad]; it is taken as level
};

LaserMount laser_mount(const Pose3& T_robot_laser) noexcept;

/// Puts the laser of a scan in its place.
void apply(const LaserMount& mount, LaserScan& scan) noexcept;

}  // namespace slamicp
