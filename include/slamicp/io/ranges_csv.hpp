// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <slamicp/io/scan_log.hpp>

namespace slamicp {

/// Reads a scan a line, comma-separated ranges [m], from memory. Angles run evenly from -fov/2 to +fov/2; 0 (and all
/// below 2 cm), `inf` and `nan` are no returns. The first line decides the number of beams; another number further on
/// throws Error, but a short last line is a warning: such logs are often cut.
ScanLog parse_ranges_csv(std::string_view text, const std::string& name, const ScanLogOptions& options = {});

/// The scans' ranges, a scan a line, 0 = no return. Throws Error if scans differ in their number of beams.
std::string ranges_csv_text(std::span<const LaserScan> scans);

}  // namespace slamicp
