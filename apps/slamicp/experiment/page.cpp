// SPDX-License-Identifier: Apache-2.0
#include <slamicp/error.hpp>
#include <slamicp/io/output_file.hpp>
#include <slamicp/version.hpp>

#include "experiment.hpp"

namespace slamicp::command {
namespace {

constexpr const char* page_style =
    "body{font:15px/1.5 system-ui,sans-serif;color:#222;max-width:960px;margin:2em auto;padding:0 1em}"
    "h1{font-size:1.5em}h2{font-size:1.15em;margin-top:2em}table{border-collapse:collapse;margin:1em 0}"
    "th,td{padding:.2em .9em .2em 0;text-align:right;font-variant-numeric:tabular-nums}"
    "th{font-weight:500;color:#555;border-bottom:1px solid #bbb;vertical-align:bottom}"
    "th:first-child,td:first-child{text-align:left}"
    "figure{margin:1.5em 0}figcaption{color:#555}svg{max-width:100%;height:auto;display:block}";

}  // namespace

Folder::Folder(const std::string& path) : path_(file_named(path)) {
  std::error_code problem;
  std::filesystem::create_directories(path_, problem);
  if (problem) throw Error("the folder cannot be made: " + problem.message(), path, "give another one with --out");
}

void Folder::save(const std::string& name, const Picture& picture) const {
  for (const char* ending : picture_endings()) picture.save(path_ / (name + ending));
}

void Folder::save(const std::string& name, const Chart& chart) const {
  for (const char* ending : picture_endings()) chart.save(path_ / (name + ending));
}

void Folder::save_text(const std::string& name, const std::string& text) const { write_file(path_ / name, text); }

Page::Page(const std::string& title) : title_(escaped(title)) {}

Page& Page::heading(const std::string& text) {
  body_ += "<h2>" + escaped(text) + "</h2>\n";
  return *this;
}

Page& Page::paragraph(const std::string& text) {
  body_ += "<p>" + escaped(text) + "</p>\n";
  return *this;
}

Page& Page::table(const std::vector<std::vector<std::string>>& rows) {
  body_ += "<table>\n";
  const char* cell = "th";
  for (const std::vector<std::string>& row : rows) {
    body_ += "<tr>";
    for (const std::string& text : row) body_ += std::string("<") + cell + ">" + escaped(text) + "</" + cell + ">";
    body_ += "</tr>\n";
    cell = "td";
  }
  body_ += "</table>\n";
  return *this;
}

Page& Page::figure(const std::string& svg, const std::string& caption) {
  // Without the XML header of a file.
  body_ += "<figure>" + svg.substr(std::min(svg.find("<svg"), svg.size())) + "<figcaption>" + escaped(caption) +
           "</figcaption></figure>\n";
  return *this;
}

std::string Page::html() const {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title_ + "</title><style>" +
         page_style + "</style></head><body>\n<h1>" + title_ + "</h1>\n" + body_ + "<p>Written by slamicp " + version +
         ". The paper: Clotet, Palacín, SLAMICP Library, Sensors 2023, 23(15), 6841.</p>\n</body></html>\n";
}

void tell_what_is_simulated(Page& page, const ExperimentSite& site) {
  page.paragraph(
      "Simulated: the place (a corridor of 25.2 m x 2.5 m with a side corridor, in the likeness of the paper's "
      "figures, "
      "not measured from it), the Hokuyo UTM-30LX (1081 beams, 270 deg, 40 Hz, a sweep of 25 ms; 10 mm of noise that "
      "grows with the range, 10 mm of systematic error, lost and mixed readings), and the robot APR-02 (three omni "
      "wheels, 2 % slip, 50 ms delay). Real: localization, path tracking, obstacle detection and evaluation, the code "
      "that a robot runs.");
  page.paragraph(
      format("The map comes from an exploration of the same place by our own mapper: %zu points from %zu scans "
             "(the paper: 10402 points); the mapping robot's path error was %.0f mm mean, %.0f mm at most. "
             "It does not change during the experiment.",
             site.map->size(), site.survey_scans, 1e3 * site.survey_error.mean, 1e3 * site.survey_error.max));
}

PointCloud2 path_of(const ExperimentSite& site) {
  PointCloud2 path;
  for (const Pose2& pose : site.path->sampled(0.05)) path.push_back(pose.translation());
  return path;
}

Picture draw_map(const ExperimentSite& site, const std::string& title, const std::optional<Bounds<2>>& bounds) {
  PictureOptions options;
  options.title = title;
  options.bounds = bounds;
  Picture picture(options);
  picture.points(to_cloud<2>(site.map->points()), colours::map, 0.9, format("map, %zu points", site.map->size()));
  return picture;
}

std::vector<double> places_of(const std::string& obstacle) {
  if (obstacle == "B2") return {3.2, 5.5, 7.0};
  return {4.2, 7.0, 13.2};
}

}  // namespace slamicp::command
