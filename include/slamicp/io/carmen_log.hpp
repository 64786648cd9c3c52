// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <slamicp/io/scan_log.hpp>

namespace slamicp {

/// Reads a CARMEN log from memory: its FLASER and ROBOTLASER1 messages, in the order of the file, stamped by their
/// ipc_timestamp. ODOM and other messages are counted only.
///
/// FLASER names neither angles nor limits. Beams start at -90 deg; n = 180 and 181 mean 1 deg, 360 and 361 half a
/// degree, any other n spreads 180 deg evenly. No returns are a large constant (81.83, 81.91): it is found from the
/// readings, and `range_max` set below it.
///
/// The laser's place on the robot is the median over the log of inverse(robot pose) * laser pose, rounded to 0.1 mm and
/// 0.01 deg: single messages carry the rounding of their decimals. The same for all scans.
///
/// @param name  the file's name, for messages
/// Throws Error with file and line; a cut last line is a warning.
ScanLog parse_carmen_log(std::string_view text, const std::string& name, const ScanLogOptions& options = {});

/// The scans as a CARMEN log of ROBOTLASER1 messages. Scans without odometry get the robot pose 0 0 0; where all have
/// it, the reader takes odometry as not known.
std::string carmen_log_text(std::span<const LaserScan> scans);

}  // namespace slamicp
