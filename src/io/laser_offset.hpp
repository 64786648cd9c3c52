// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/carmen_messages.hpp"

namespace slamicp {

/// T_robot_laser, the median over the log, rounded to 0.1 mm and 0.01 deg. The identity, with a warning, if the laser's
/// poses do not follow the robot's: then they come from elsewhere (a log corrected by SLAM).
Pose2 laser_offset(const std::vector<CarmenScan>& scans, std::vector<std::string>& warnings);

}  // namespace slamicp
