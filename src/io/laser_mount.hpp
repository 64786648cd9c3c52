// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <slamicp/scan/laser_scan.hpp>

#include "io/frame_tree.hpp"

namespace slamicp {

/// How a planar laser sits on the robot.
struct LaserMount {
  Pose2 T_robot_laser;
  bool upside_down = false;  ///< its beams turn the other way
};

/// By tf; the identity, with a warning, where tf does not say. Warns where the laser moves on the robot, or is tilted.
LaserMount laser_mount(const FrameTree& frames, const std::string& base, const std::string& laser,
                       std::vector<std::string>& warnings);

/// Puts the laser of a scan in its place.
void apply(const LaserMount& mount, LaserScan& scan) noexcept;

}  // namespace slamicp
