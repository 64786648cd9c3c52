// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/io/scan_log.hpp>

namespace slamicp {

/// Throws Error if the options break a rule.
void require_valid(const ScanLogOptions& options);

/// Adds a warning where stamps run backwards.
void warn_of_backward_stamps(ScanLog& log);

/// Finds the constant that a lidar without `range_max` gives for "no return", sets `range_max` below it and warns.
///
/// Two rules. Sick LMS lidars, 8191 as largest value, send 81.83 .. 81.91 m as error codes: if the largest reading is
/// one of them, all are. Else a largest reading of 3.5 m or more is a constant if it is at least one reading in 1000
/// and ten times as common as any other in the upper tenth: walls jitter, constants do not.
void drop_no_return_constant(ScanLog& log);

}  // namespace slamicp
