// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include <slamicp/io/scan_log.hpp>

#include "io/recording.hpp"

namespace slamicp {

/// Makes a log of a recording of ROS: chooses its topics, finds out where the lasers sit on the robot, and how the
/// wheels saw each scan's robot. `ScanLogOptions` says how it chooses.
///
/// Where a laser sits comes from tf, over any number of frames. A laser that hangs upside down becomes one that turns
/// the other way; a tilted one is taken as level, with a warning. Odometry at a scan's stamp lies between the messages
/// before and after it. Messages that are broken, scans without directions among them, are left out, with a warning.
/// @param name  the file
/// @param read  hands the recording over
ScanLog make_ros_log(const std::string& name, const std::string& format,
                     const std::function<void(RecordingVisitor&)>& read, const ScanLogOptions& options);

}  // namespace slamicp
