// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/io/carmen_log.hpp>
#include <slamicp/io/output_file.hpp>
#include <slamicp/io/ranges_csv.hpp>
#include <slamicp/io/scan_log.hpp>

#include "io/text.hpp"

namespace slamicp {
namespace {

enum class Format { carmen, ranges_csv };

Format format_of(const std::filesystem::path& path) {
  const std::string ending = text::ending_of(path);
  if (ending == ".clf" || ending == ".log") return Format::carmen;
  if (ending == ".csv") return Format::ranges_csv;
  throw Error("ending " + text::quoted(ending) + " is of no log that slamicp knows", text::name_of(path),
              "name it .clf or .log (CARMEN) or .csv (ranges, a scan a line)");
}

}  // namespace

std::string ScanLogOptions::problem() const {
  if (!(fov_deg > 0.0 && fov_deg <= 360.0)) return "fov_deg is not in (0, 360]";
  if (!(scan_rate_hz > 0.0 && std::isfinite(scan_rate_hz))) return "scan_rate_hz is not above 0";
  if (laser_offset && !laser_offset->is_finite()) return "laser_offset is not finite";
  return {};
}

ScanLog open_scan_log(const std::filesystem::path& path, const ScanLogOptions& options) {
  const Format format = format_of(path);
  const std::string content = text::read_file(path);
  const std::string name = text::name_of(path);
  return format == Format::carmen ? parse_carmen_log(content, name, options) : parse_ranges_csv(content, name, options);
}

void save_scan_log(const std::filesystem::path& path, std::span<const LaserScan> scans) {
  write_file(path, format_of(path) == Format::carmen ? carmen_log_text(scans) : ranges_csv_text(scans));
}

}  // namespace slamicp
