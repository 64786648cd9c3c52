// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/io/carmen_log.hpp>
#include <slamicp/io/output_file.hpp>
#include <slamicp/io/ranges_csv.hpp>
#include <slamicp/io/scan_log.hpp>

#include "io/file_bytes.hpp"
#include "io/log_checks.hpp"
#include "io/log_format.hpp"
#include "io/recording.hpp"
#include "io/ros_log.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

LogFormat format_of(const std::filesystem::path& path) {
  if (const std::optional<LogFormat> format = log_format(path)) return *format;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw Error("is a folder without metadata.yaml, so no rosbag2", text::name_of(path), "name a log in it");
  throw Error("ending " + text::quoted(text::ending_of(path)) + " is of no log that slamicp knows", text::name_of(path),
              std::string("give one of ") + log_endings);
}

ScanLog open_text(const std::filesystem::path& path, LogFormat format, const ScanLogOptions& options) {
  constexpr std::size_t most = std::size_t{4} << 30U;  // no log of text is larger; what is, was made to fill memory
  const std::string name = text::name_of(path);
  std::string content = text::read_file(path);
  if (format.compression != Compression::none) content = unpack(format.compression, content, most, name);
  return format.kind == LogFormat::Kind::carmen ? parse_carmen_log(content, name, options)
                                                : parse_ranges_csv(content, name, options);
}

/// A recording that is one file.
ScanLog open_recording(const std::filesystem::path& path, LogFormat format, const ScanLogOptions& options) {
  const std::string name = text::name_of(path);
  const FileBytes file(path);
  const bool is_bag = format.kind == LogFormat::Kind::ros1_bag;
  const auto read = [&](RecordingVisitor& visitor) {
    is_bag ? read_ros1_bag(file.bytes(), name, visitor) : read_mcap(file.bytes(), name, visitor);
  };
  return make_ros_log(name, is_bag ? "ROS 1 bag" : "MCAP", read, options);
}

}  // namespace

std::string ScanLogOptions::problem() const {
  if (!(fov_deg > 0.0 && fov_deg <= 360.0)) return "fov_deg is not in (0, 360]";
  if (!(scan_rate_hz > 0.0 && std::isfinite(scan_rate_hz))) return "scan_rate_hz is not above 0";
  if (laser_offset && !laser_offset->is_finite()) return "laser_offset is not finite";
  return {};
}

ScanLog open_scan_log(const std::filesystem::path& path, const ScanLogOptions& options) {
  require_valid(options);
  const LogFormat format = format_of(path);
  if (format.is_text()) return open_text(path, format, options);
  if (format.kind != LogFormat::Kind::rosbag2) return open_recording(path, format, options);
  const auto read = [&](RecordingVisitor& visitor) { read_rosbag2(path, visitor); };
  return make_ros_log(text::name_of(path), "rosbag2", read, options);
}

void save_scan_log(const std::filesystem::path& path, std::span<const LaserScan> scans) {
  const LogFormat format = format_of(path);
  if (!format.is_text() || format.compression != Compression::none)
    throw Error("ending " + text::quoted(text::ending_of(path)) + " is of no log that slamicp writes",
                text::name_of(path), "name it .clf or .log (CARMEN) or .csv (ranges, a scan a line)");
  write_file(path, format.kind == LogFormat::Kind::carmen ? carmen_log_text(scans) : ranges_csv_text(scans));
}

}  // namespace slamicp
