// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include <algorithm>
#include <cmath>

#include <slamicp/io/output_file.hpp>
#include <slamicp/version.hpp>

#include "output.hpp"
#include "report_states.hpp"

namespace slamicp::command {
namespace {

std::string row(const std::string& name, const std::string& value) {
  return "<tr><th>" + escaped(name) + "</th><td>" + escaped(value) + "</td></tr>\n";
}

/// One value a scan as a line, with the largest value on its axis.
std::string chart(const RunRecord& record, double ScanRecord::*field, const std::string& title, double unit,
                  const char* colour) {
  constexpr double width = 860.0;
  constexpr double height = 130.0;
  constexpr double left = 60.0;
  constexpr double top = 24.0;
  const double largest = std::max(record.largest(field) * unit, 1e-12);
  const std::size_t count = record.scans.size();
  // More scans than pixels: each pixel shows the largest of its scans, so that no spike is lost.
  const std::size_t columns = std::min<std::size_t>(count, 800);
  std::string line;
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t first = count * column / columns;
    const std::size_t last = std::max(first + 1, count * (column + 1) / columns);
    double value = 0.0;
    for (std::size_t k = first; k < last; ++k) value = std::max(value, record.scans[k].*field);
    const double share = columns > 1 ? static_cast<double>(column) / static_cast<double>(columns - 1) : 0.0;
    line += format("%.1f,%.1f ", left + share * (width - left - 10.0),
                   top + (1.0 - value * unit / largest) * (height - top - 20.0));
  }
  const double floor = height - 20.0;
  return format("<svg viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" role=\"img\">", width, height, width) +
         "<text x=\"0\" y=\"14\" class=\"t\">" + escaped(title) + "</text>" +
         format("<line x1=\"%.0f\" y1=\"%.0f\" x2=\"%.0f\" y2=\"%.0f\" class=\"a\"/>", left, floor, width - 10.0,
                floor) +
         format("<text x=\"%.0f\" y=\"%.0f\" class=\"n\">%.3g</text><text x=\"%.0f\" y=\"%.0f\" class=\"n\">0</text>",
                left - 6.0, top + 8.0, largest, left - 6.0, floor + 4.0) +
         format("<text x=\"%.0f\" y=\"%.0f\" class=\"n\">scan %zu</text>", width - 10.0, height - 4.0,
                count > 0 ? count - 1 : 0) +
         "<polyline fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.3\" points=\"" + line + "\"/></svg>\n";
}

/// An SVG file as a part of a page: without its XML header.
std::string inline_svg(const std::string& svg) { return svg.substr(std::min(svg.find("<svg"), svg.size())); }

constexpr const char* report_style =
    "body{font:15px/1.5 system-ui,sans-serif;color:#222;max-width:940px;margin:2em auto;padding:0 1em}"
    "h1{font-size:1.5em}h2{font-size:1.15em;margin-top:2em}table{border-collapse:collapse}"
    "th{text-align:left;font-weight:500;color:#555;padding:.15em 1.5em .15em 0}td{font-variant-numeric:tabular-nums}"
    "svg{max-width:100%;height:auto;display:block}.t{font:600 13px sans-serif}.n{font:11px "
    "sans-serif;text-anchor:end;fill:#666}"
    ".a{stroke:#bbb}.states td,.states th{padding-right:1.5em;text-align:right}"
    ".states td:first-child,.states th:first-child{text-align:left}";

}  // namespace

void RunRecord::add(const Fix& fix, double time_us) {
  trajectory.push_back({fix.stamp, fix.pose});
  ++stops[fix.stop()];
  ++states[fix.quality.state];
  scans.push_back({static_cast<double>(fix.match.iterations), static_cast<double>(fix.scan.in_robot.size()),
                   static_cast<double>(fix.match.inliers), static_cast<double>(fix.outliers().size()),
                   fix.match.mean_inlier_distance, time_us, fix.quality.state, fix.quality.probability,
                   fix.covariance_in_map(), fix.blind_direction});
  outliers.insert(outliers.end(), fix.outliers_in_map().begin(), fix.outliers_in_map().end());
  if (scans.size() == 1 || fix.outliers().size() > shown.outliers.size()) show(fix);
}

void RunRecord::show(const Fix& fix) {
  shown = {scans.size() - 1, fix.pose, {}, fix.outliers_in_map()};
  auto outlier = fix.outliers().begin();
  for (std::size_t i = 0; i < fix.scan.in_robot.size(); ++i) {
    if (outlier != fix.outliers().end() && static_cast<std::size_t>(*outlier) == i)
      ++outlier;
    else
      shown.inliers.push_back(fix.pose * fix.scan.in_robot[i]);
  }
}

double RunRecord::mean(double ScanRecord::*field) const {
  double sum = 0.0;
  for (const ScanRecord& scan : scans) sum += scan.*field;
  return scans.empty() ? 0.0 : sum / static_cast<double>(scans.size());
}

double RunRecord::largest(double ScanRecord::*field) const {
  double most = 0.0;
  for (const ScanRecord& scan : scans) most = std::max(most, scan.*field);
  return most;
}

double RunRecord::quantile(double ScanRecord::*field, double share) const {
  if (scans.empty()) return 0.0;
  std::vector<double> values;
  values.reserve(scans.size());
  for (const ScanRecord& scan : scans) values.push_back(scan.*field);
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

bool RunRecord::has_times() const {
  return trajectory.size() > 1 && trajectory.back().stamp > trajectory.front().stamp &&
         std::is_sorted(trajectory.begin(), trajectory.end(),
                        [](const StampedPose& a, const StampedPose& b) { return a.stamp < b.stamp; });
}

std::vector<double> RunRecord::times() const {
  std::vector<double> times;
  times.reserve(trajectory.size());
  const bool rise = has_times();
  for (const StampedPose& stamped : trajectory)
    times.push_back(rise ? stamped.stamp - trajectory.front().stamp : static_cast<double>(times.size()));
  return times;
}

std::string RunRecord::brief() const {
  std::string line = format("%zu scans:", trajectory.size());
  for (const auto& [stop, count] : stops) line += format(" %zu %s,", count, to_string(stop));
  return line + format(" %.0f inliers and %.1f outliers a scan, mean inlier distance %.1f mm, %.0f us a scan (median)",
                       mean(&ScanRecord::inliers), mean(&ScanRecord::outliers),
                       1e3 * mean(&ScanRecord::mean_inlier_distance), quantile(&ScanRecord::time_us, 0.5));
}

Picture draw_run(const RunRecord& record, const std::string& title, std::optional<Bounds<2>> bounds) {
  const std::string scan = "scan " + std::to_string(record.shown.scan);
  Picture picture({.title = title, .bounds = bounds});
  picture.points(record.map->points(), colours::map, 0.9, "map");
  picture.points(record.outliers, Colour{214, 39, 40, 0.4}, 0.9, "outliers of the run");
  draw_states(picture, record);
  picture.points(record.shown.inliers, colours::inlier, 1.4, scan + ": inliers");
  picture.points(record.shown.outliers, colours::outlier, 2.0, scan + ": outliers");
  picture.robot(record.shown.pose, 0.25, colours::robot, "robot");
  return picture;
}

void write_report(const std::string& file, const RunRecord& record) {
  std::string stops;
  for (const auto& [stop, count] : record.stops)
    stops += format("%s%zu %s", stops.empty() ? "" : ", ", count, to_string(stop));
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>slamicp: " + escaped(record.log) +
      "</title><style>" + report_style + "</style></head><body>\n<h1>" + escaped(record.log) + " in " +
      escaped(record.map_file) + "</h1>\n<table>\n";
  page += row("scans", format("%zu: ", record.scans.size()) + stops);
  page += row("map", format("%zu points", record.map->size()));
  page += row("inliers, outliers a scan",
              format("%.0f, %.1f (most outliers %.0f)", record.mean(&ScanRecord::inliers),
                     record.mean(&ScanRecord::outliers), record.largest(&ScanRecord::outliers)));
  page += row("mean inlier distance", format("%.2f mm", 1e3 * record.mean(&ScanRecord::mean_inlier_distance)));
  page += row("iterations a scan", format("%.1f", record.mean(&ScanRecord::iterations)));
  page += row("time a scan", format("median %.0f us, 99 %% below %.0f us", record.quantile(&ScanRecord::time_us, 0.5),
                                    record.quantile(&ScanRecord::time_us, 0.99)));
  page += row("starts at", to_string(record.initial_pose));
  page += row("ends at", to_string(record.trajectory.back().pose));
  page += "</table>\n<h2>Where it went, and what the map did not know</h2>\n";
  page += inline_svg(draw_run(record, "").svg());
  page += "<h2>How sure it was</h2>\n";
  if (const auto closer = worth_a_closer_look(record)) page += inline_svg(draw_run(record, "", closer).svg());
  page += table_of_states(record) + charts_of_states(record);
  page += "<h2>Scan by scan</h2>\n";
  page += chart(record, &ScanRecord::outliers, "outliers", 1.0, "#d62728");
  page += chart(record, &ScanRecord::mean_inlier_distance, "mean inlier distance [mm]", 1e3, "#22a054");
  page += chart(record, &ScanRecord::iterations, "iterations", 1.0, "#3a6ea5");
  page += chart(record, &ScanRecord::time_us, "time [us]", 1.0, "#464e5a");
  page += std::string("<p>Written by slamicp ") + version + ".</p></body></html>\n";
  write_file(file_named(file), page);
}

}  // namespace slamicp::command
