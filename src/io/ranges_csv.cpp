// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/ranges_csv.hpp>

#include "io/log_checks.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr std::size_t fewest_beams = 4;  // fewer is a cloud of points, not a lidar

struct Row {
  std::vector<float> ranges;
  std::string problem;  ///< what stopped the reading; empty if nothing did
};

Row read_row(std::string_view line, std::size_t beams_expected) {
  Row row;
  row.ranges.reserve(beams_expected);
  text::Tokens tokens(line);
  for (std::string_view token; tokens.next(token);) {
    const std::optional<float> range = text::to_number<float>(token);
    if (!range) {
      row.problem = "range " + std::to_string(row.ranges.size()) + " is not a number: " + text::quoted(token);
      return row;
    }
    row.ranges.push_back(*range);
  }
  return row;
}

LaserScan scan_of(std::vector<float> ranges, double fov, double stamp) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.angle_min = -0.5 * fov;
  scan.angle_increment = fov / static_cast<double>(ranges.size() - 1);
  scan.range_min = 0.02;  // what stands for no return may be a small constant, not just 0
  scan.ranges = std::move(ranges);
  return scan;
}

[[noreturn]] void fail(const text::Lines& lines, const std::string& what) {
  throw Error(what, lines.where(), "give a scan a line: ranges in metres, comma-separated, 0 for no return");
}

bool is_last(const text::Lines& lines, std::string_view text) {
  return text.find_first_not_of(" \t\r\n", lines.offset()) == std::string_view::npos;
}

}  // namespace

ScanLog parse_ranges_csv(std::string_view text, const std::string& name, const ScanLogOptions& options) {
  require_valid(options);
  ScanLog log;
  log.name = name;
  log.format = "ranges CSV";
  std::size_t beams = 0;
  text::Lines lines(text, name);
  while (lines.next()) {
    if (lines.line().find_first_not_of(" \t") == std::string_view::npos || lines.line().starts_with('#')) continue;
    Row row = read_row(lines.line(), beams);
    const std::size_t count = row.ranges.size();
    if (beams != 0 && count < beams && is_last(lines, text) && (row.problem.empty() || lines.cut())) {
      log.warnings.push_back("line " + std::to_string(lines.number()) + ", the last, is cut: " + std::to_string(count) +
                             " of " + std::to_string(beams) + " ranges: left out");
      break;
    }
    if (!row.problem.empty()) fail(lines, row.problem);
    if (beams == 0) beams = count;
    if (beams < fewest_beams) fail(lines, "only " + text::count_of(count, "value") + ": a point, not a scan");
    if (count != beams)
      fail(lines, text::count_of(count, "range") + ", but the lines before have " + std::to_string(beams));
    const double stamp = static_cast<double>(log.size()) / options.scan_rate_hz;
    log.scans.push_back(scan_of(std::move(row.ranges), options.fov_deg * rad_per_deg, stamp));
    if (options.laser_offset) log.scans.back().T_robot_laser = *options.laser_offset;
  }
  if (log.empty()) throw Error("holds no scan", name, "give a scan a line: ranges in metres, comma-separated");
  log.messages["line"] = log.size();
  drop_no_return_constant(log);
  return log;
}

std::string ranges_csv_text(std::span<const LaserScan> scans) {
  std::string out;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const LaserScan& scan = scans[i];
    if (scan.ranges.size() != scans[0].ranges.size())
      throw Error("scan " + std::to_string(i) + " has " + text::count_of(scan.ranges.size(), "beam") + ", the first " +
                      std::to_string(scans[0].ranges.size()),
                  "ranges CSV", "write a CARMEN log (.clf), where beams may differ");
    for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
      if (beam > 0) out += ',';
      text::append_exact(out, is_return(scan, scan.ranges[beam]) ? scan.ranges[beam] : 0.0F);
    }
    out += '\n';
  }
  return out;
}

}  // namespace slamicp
