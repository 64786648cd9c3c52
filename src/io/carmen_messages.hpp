// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/scan/laser_scan.hpp>

#include "io/text.hpp"

namespace slamicp {

/// One scan message of a CARMEN log.
struct CarmenScan {
  LaserScan scan;  ///< all but `T_robot_laser`
  Pose2 T_odom_laser;
  bool is_flaser = false;
};

/// `FLASER n r_0..r_(n-1) lx ly lth ox oy oth ipc_timestamp ipc_hostname logger_timestamp`
/// @param tokens  what follows the message's name
CarmenScan parse_flaser(text::Tokens& tokens, const text::Lines& lines);

/// `ROBOTLASER1 type start_angle fov angular_resolution max_range accuracy remission_mode n r_0.. m rem_0.. lx ly lth
/// ox oy oth tv rv forward_safety side_safety turn_axis ipc_timestamp ipc_hostname logger_timestamp`
CarmenScan parse_robotlaser(text::Tokens& tokens, const text::Lines& lines);

}  // namespace slamicp
