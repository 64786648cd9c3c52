// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <slamicp/io/scan_log.hpp>

#include "io/ros_recording.hpp"

namespace slamicp {

/// "/scan (sensor_msgs/LaserScan)"
std::string told(const RosTopic& topic);

/// The topics that `ScanLogOptions::scan_topics` names or means, each with a scan. Error, with the names to choose
/// from, where it means none or several.
std::vector<RosTopic*> choose_scan_topics(RosRecording& recording, const std::vector<std::string>& names);

/// The topic that `ScanLogOptions::odometry_topic` names or means; null where the recording has none, or several and
/// none of them is `odom`: then with a warning. Error where the name is of no odometry.
RosTopic* choose_odometry_topic(RosRecording& recording, const std::string& name, std::vector<std::string>& warnings);

}  // namespace slamicp
