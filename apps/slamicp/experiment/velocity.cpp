// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/evaluation/along_path.hpp>

#include "experiment.hpp"

namespace slamicp::command {
namespace {

constexpr double step = 0.05;  // of the curves along the path [m]

// As in the paper: no obstacle thick and magenta, speeds thin. Dark is slow.
constexpr Colour none_colour{214, 39, 160};
Colour colour_of(std::size_t speed, std::size_t speeds) {
  constexpr Colour scale[] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 180, 80}, {226, 170, 20}};
  const std::size_t at = speeds > 1 ? (4 * speed + (speeds - 1) / 2) / (speeds - 1) : 2;
  return scale[std::min<std::size_t>(at, 4)];
}

using Curves = std::vector<std::vector<std::vector<double>>>;  // of each speed, of each run, along the path

/// The drives with one obstacle at all speeds.
struct Series {
  std::string obstacle;
  Curves outliers;
  Curves distances;                   // mean inlier distance [m]
  double mean_inlier_distance = 0.0;  // over all drives [m]
};

Series drive(const ExperimentSite& site, const std::string& obstacle, const ExperimentWords& words,
             Progress& progress) {
  Series series{obstacle, {}, {}, 0.0};
  double drives = 0.0;
  for (const double speed : words.speeds) {
    series.outliers.emplace_back();
    series.distances.emplace_back();
    for (int run = 0; run < words.runs; ++run) {
      DrivePlan plan;
      plan.obstacle = obstacle;
      plan.speed = speed;
      plan.seed = words.seed + static_cast<std::uint64_t>(run);
      plan.keeps_scans = false;
      const RecordedDrive drive = record_drive(site, plan);
      const double length = site.path->length();
      series.outliers.back().push_back(along_path(
          drive, [](const DriveSample& sample) { return static_cast<double>(sample.outliers); }, length, step));
      series.distances.back().push_back(along_path(
          drive, [](const DriveSample& sample) { return sample.mean_inlier_distance; }, length, step));
      series.mean_inlier_distance += drive.mean_inlier_distance();
      ++drives;
      progress.step();
    }
  }
  series.mean_inlier_distance /= drives;
  return series;
}

PointCloud2 line_of(const std::vector<double>& curve, double unit) {
  PointCloud2 line;
  for (std::size_t k = 0; k < curve.size(); ++k) line.emplace_back(static_cast<double>(k) * step, curve[k] * unit);
  return line;
}

/// Every speed's first run with the obstacle, and the first speed's without it.
Chart draw(const Series& with, const Series& none, Curves Series::*which, double unit, const std::string& title,
           const std::string& label, const ExperimentWords& words) {
  ChartOptions options;
  options.title = title;
  options.x_label = "distance travelled [m]";
  options.y_label = label;
  Chart chart(options);
  const std::size_t middle = words.speeds.size() / 2;
  chart.line(line_of((none.*which)[middle].front(), unit), none_colour, 3.0,
             format("none, %.2f m/s", words.speeds[middle]));
  for (std::size_t v = 0; v < words.speeds.size(); ++v)
    chart.line(line_of((with.*which)[v].front(), unit), colour_of(v, words.speeds.size()), 1.1,
               with.obstacle + format(", %.2f m/s", words.speeds[v]));
  const std::vector<double> places = places_of(with.obstacle);
  for (std::size_t k = 0; k < places.size(); ++k) chart.mark(places[k], std::string(1, static_cast<char>('a' + k)));
  return chart;
}

double difference_percent(double a, double b) { return b > 0.0 ? 100.0 * (a - b) / b : 0.0; }

/// Of the mean curves over all speeds and runs, place by place, the median difference [%].
double median_difference_percent(const Series& with, const Series& none) {
  const auto mean_of_all = [](const Curves& curves) {
    std::vector<std::vector<double>> all;
    for (const auto& runs : curves) all.insert(all.end(), runs.begin(), runs.end());
    return mean_curve(all);
  };
  const std::vector<double> a = mean_of_all(with.distances);
  const std::vector<double> b = mean_of_all(none.distances);
  std::vector<double> differences;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    differences.push_back(std::abs(difference_percent(a[k], b[k])));
  return median(std::move(differences));
}

std::string csv_of(const std::vector<Series>& all, const ExperimentWords& words) {
  std::string csv = "obstacle,speed_m_per_s,run,travelled_m,outliers,mean_inlier_distance_mm\n";
  for (const Series& series : all)
    for (std::size_t v = 0; v < series.outliers.size(); ++v)
      for (std::size_t run = 0; run < series.outliers[v].size(); ++run)
        for (std::size_t k = 0; k < series.outliers[v][run].size(); ++k)
          csv += format("%s,%.3f,%zu,%.2f,%.0f,%.4f\n", name_of_obstacle(series.obstacle).c_str(), words.speeds[v], run,
                        static_cast<double>(k) * step, series.outliers[v][run][k], 1e3 * series.distances[v][run][k]);
  return csv;
}

struct Finding {
  CurveSpread outliers;
  CurveSpread distances;
  double distance_change = 0.0;         // with the obstacle, of the mean [%]
  double median_distance_change = 0.0;  // at the median place [%]
};

Finding finding_of(const Series& series, const Series& none) {
  return {spread_of(series.outliers), spread_of(series.distances),
          difference_percent(series.mean_inlier_distance, none.mean_inlier_distance),
          median_difference_percent(series, none)};
}

void tell(Page& page, const std::vector<Series>& all, const std::vector<Finding>& findings) {
  std::vector<std::vector<std::string>> table{{"obstacle", "outliers, between speeds", "outliers, run to run",
                                               "inlier distance mm, between speeds", "inlier distance mm, run to run",
                                               "mean inlier distance mm", "against none", "at the median place"}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Finding& found = findings[k];
    table.push_back({name_of_obstacle(all[k].obstacle), format("%.2f", found.outliers.between_groups),
                     format("%.2f", found.outliers.within_groups), format("%.3f", 1e3 * found.distances.between_groups),
                     format("%.3f", 1e3 * found.distances.within_groups),
                     format("%.2f", 1e3 * all[k].mean_inlier_distance),
                     k == 0 ? std::string("-") : format("%+.1f %%", found.distance_change),
                     k == 0 ? std::string("-") : format("%.1f %%", found.median_distance_change)});
  }
  page.heading("In numbers");
  page.table(table);
  page.paragraph(
      "Between speeds: the standard deviation of the speeds' mean curves around the mean of all. Run to run: that of "
      "the "
      "runs around the mean of their speed. Both root mean square over the path. Speeds that make no difference still "
      "differ by the run-to-run spread over the root of the number of runs.");
  page.paragraph(
      "An obstacle that touches a wall, such as A2, has points that are nearer than 0.3 m to the map: they are "
      "inliers, "
      "and their distances make the mean larger while the robot sees them. Where none of it is so near, as with B2, "
      "the "
      "mean stays what it is.");
}

Json series_json(const Series& series, const Finding& found) {
  return {{"obstacle", name_of_obstacle(series.obstacle)},
          {"outliers_between_speeds", found.outliers.between_groups},
          {"outliers_run_to_run", found.outliers.within_groups},
          {"inlier_distance_between_speeds", found.distances.between_groups},
          {"inlier_distance_run_to_run", found.distances.within_groups},
          {"mean_inlier_distance", series.mean_inlier_distance},
          {"change_percent", found.distance_change},
          {"median_change_percent", found.median_distance_change}};
}

/// The paper's numbers of the two figures of an obstacle.
std::pair<std::string, std::string> figures_of(const std::string& obstacle) {
  if (obstacle == "A2") return {"Figure 11: ", "Figure 12: "};
  if (obstacle == "B2") return {"Figure 14: ", "Figure 15: "};
  return {"", ""};
}

void add_figures(const Series& series, const Series& none, const ExperimentWords& words, const Folder& folder,
                 Page& page) {
  const auto [first, second] = figures_of(series.obstacle);
  page.heading("Obstacle " + series.obstacle);
  const Chart outliers =
      draw(series, none, &Series::outliers, 1.0, first + "outliers, obstacle " + series.obstacle, "outliers", words);
  folder.save("velocity_" + series.obstacle + "_outliers", outliers);
  page.figure(outliers.svg(), first + "the number of outliers along the path.");
  const Chart distances =
      draw(series, none, &Series::distances, 1e3, second + "mean inlier distance, obstacle " + series.obstacle,
           "mean inlier distance [mm]", words);
  folder.save("velocity_" + series.obstacle + "_inlier_distance", distances);
  page.figure(distances.svg(), second + "the mean inlier distance along the path.");
}

void introduce_velocity(Page& page, const ExperimentSite& site, const ExperimentWords& words) {
  tell_what_is_simulated(page, site);
  page.paragraph(format(
      "The robot follows the reference path at %zu speeds, %d times each, without an obstacle and with each one. (a), "
      "(b), (c) are the places of the snapshots (Figures 10 and 13). The curves are of single scans of the first run; "
      "the thick magenta one is without an obstacle. The paper's finding, from its figures: speed has no remarkable "
      "effect, and the mean inlier distance is virtually the same with and without obstacles.",
      words.speeds.size(), words.runs));
}

}  // namespace

Json run_velocity(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk) {
  std::vector<std::string> obstacles = words.obstacles_or({"A2", "B2"});
  obstacles.insert(obstacles.begin(), "");
  std::vector<Series> all;
  {
    Progress progress("driving", obstacles.size() * words.speeds.size() * static_cast<std::size_t>(words.runs));
    for (const std::string& obstacle : obstacles) all.push_back(drive(site, obstacle, words, progress));
  }
  Page page("Figures 11, 12, 14, 15: what speed changes");
  introduce_velocity(page, site, words);
  std::vector<Finding> findings;
  Json list = Json::array();
  for (const Series& series : all) {
    findings.push_back(finding_of(series, all.front()));
    const Finding& found = findings.back();
    list.push_back(series_json(series, found));
    talk(format(
        "%-9s outliers differ by %.2f between speeds, %.2f from run to run; mean inlier distance %.2f mm (%+.1f %%)",
        name_of_obstacle(series.obstacle).c_str(), found.outliers.between_groups, found.outliers.within_groups,
        1e3 * series.mean_inlier_distance, found.distance_change));
    if (!series.obstacle.empty()) add_figures(series, all.front(), words, folder, page);
  }
  tell(page, all, findings);
  folder.save_text("velocity.csv", csv_of(all, words));
  folder.save_text("velocity.html", page.html());
  return {{"runs", words.runs}, {"series", list}};
}

}  // namespace slamicp::command
