// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <slamicp/io/scan_log.hpp>
#include <slamicp/scan/motion_track.hpp>

#include "io/ros_recording.hpp"

namespace slamicp {

/// The robot of a recording.
struct RosRobot {
  std::string base;      ///< the frame that its poses are of
  MotionTrack odometry;  ///< of `base`; empty where there is none
};

/// @param laser  the first laser's frame: the robot's where there is no other
RosRobot find_robot(RosRecording& recording, const ScanLogOptions& options, const std::string& laser,
                    std::vector<std::string>& warnings);

}  // namespace slamicp
