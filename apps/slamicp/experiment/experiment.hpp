// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <slamicp/evaluation/experiment_site.hpp>
#include <slamicp/io/chart.hpp>
#include <slamicp/io/picture.hpp>

#include "../output.hpp"

namespace slamicp::command {

/// What the words on the command line ask of an experiment.
struct ExperimentWords {
  std::string name, out, json;
  std::uint64_t seed = 1;
  int runs = 3;
  std::size_t every = 75;
  std::vector<double> speeds = {0.15, 0.25, 0.35, 0.45, 0.55};
  std::vector<int> people = {0, 5, 10, 20, 40, 60};
  std::vector<std::string> obstacles;  // empty: those of the paper's experiment
  bool times = true;

  /// The obstacles asked for, or these.
  std::vector<std::string> obstacles_or(const std::vector<std::string>& of_the_paper) const {
    return obstacles.empty() ? of_the_paper : obstacles;
  }
};

/// Where an experiment's files go.
class Folder {
 public:
  /// Makes it. Throws Error.
  explicit Folder(const std::string& path);

  /// As name.svg and name.png.
  void save(const std::string& name, const Picture& picture) const;
  void save(const std::string& name, const Chart& chart) const;
  /// As it is named.
  void save_text(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// A self-contained page of HTML.
class Page {
 public:
  explicit Page(const std::string& title);

  Page& heading(const std::string& text);
  Page& paragraph(const std::string& text);
  /// The first row is the header; a first column of names, then numbers.
  Page& table(const std::vector<std::vector<std::string>>& rows);
  Page& figure(const std::string& svg, const std::string& caption);

  std::string html() const;

 private:
  std::string body_;
  std::string title_;
};

/// "none" for no obstacle.
inline std::string name_of_obstacle(const std::string& obstacle) { return obstacle.empty() ? "none" : obstacle; }

/// Says on a page what is simulated, and of which map the robot has.
void tell_what_is_simulated(Page& page, const ExperimentSite& site);

/// The reference path, as a line to draw.
PointCloud2 path_of(const ExperimentSite& site);

/// The map as dots, all of it or a part.
Picture draw_map(const ExperimentSite& site, const std::string& title,
                 const std::optional<Bounds<2>>& bounds = std::nullopt);

/// The places of the robot that the paper's Figures 10 and 13 show, labelled a, b and c: where our lidar sees of that
/// obstacle what theirs saw [m along the path].
std::vector<double> places_of(const std::string& obstacle);

// The experiments, one file each; what each returns is its part of the summary.
Json run_table1(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk);
Json run_velocity(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk);
Json run_snapshots(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk);
Json run_maps(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk);
Json run_crowd(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk);
Json run_reconstruction(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder,
                        const Talk& talk);

}  // namespace slamicp::command
