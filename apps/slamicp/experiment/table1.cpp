// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>

#include <slamicp/evaluation/table1.hpp>
#include <slamicp/simulation/corridor_world.hpp>

#include "experiment.hpp"

namespace slamicp::command {
namespace {

constexpr double in_time = 0.5;  // from when an obstacle is due until it must be found [s]

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

const PaperTable1Row* paper_row(const std::string& obstacle) {
  for (const PaperTable1Row& row : paper_table1())
    if (row.obstacle == obstacle) return &row;
  return nullptr;
}

double improvement(double AgentTimes::*how, const Table1Row& row) {
  return improvement_percent(row.original.*how, row.improved.*how);
}

/// The latest of the runs, or why there is none.
std::string found_text(const Table1Row& row) {
  if (row.obstacle.empty()) return "-";
  double latest = -1e9;
  double range = 0.0;
  bool due = true;
  for (const Sighting& sighting : row.sightings) {
    if (!sighting.was_found()) return "not found";
    due = due && sighting.was_due();
    if (sighting.was_due()) latest = std::max(latest, sighting.delay());
    range = std::max(range, sighting.found_at_range);
  }
  if (!due) return format("at %.1f m; never nearer than 4 m", range);
  if (std::abs(latest) < 0.005) return "as it was due";
  return latest < 0.0 ? format("%.2f s before due, at %.1f m", -latest, range) : format("%.2f s after due", latest);
}

// ---- what does not depend on the clock ------------------------------------------------------------------------------

std::vector<std::string> counts_cells(const Table1Row& row) {
  const PaperTable1Row* paper = paper_row(row.obstacle);
  return {name_of_obstacle(row.obstacle),
          format("%zu", row.sightings.size()),
          paper != nullptr ? std::to_string(paper->most_outliers) : "-",
          format("%zu", row.most_outliers),
          format("%.1f", row.original_outliers),
          format("%.1f", row.improved_outliers),
          found_text(row),
          format("%zu of %zu", row.runs_finished, row.sightings.size()),
          format("%zu", row.cycles_held_back)};
}

std::string counts_csv(const std::vector<Table1Row>& rows) {
  std::string csv =
      "obstacle,run,most_outliers_paper,most_outliers,scans,replayed,outliers_mean_original,outliers_mean_improved,due_"
      "s,"
      "found_s,found_at_range_m,runs_finished,cycles_held_back\n";
  for (const Table1Row& row : rows)
    for (std::size_t run = 0; run < row.sightings.size(); ++run) {
      const PaperTable1Row* paper = paper_row(row.obstacle);
      const Sighting& sighting = row.sightings[run];
      csv += format("%s,%zu,%d,%zu,%zu,%zu,%.2f,%.2f,%.3f,%.3f,%.2f,%zu,%zu\n", name_of_obstacle(row.obstacle).c_str(),
                    run, paper != nullptr ? paper->most_outliers : 0, row.most_outliers, row.scans, row.replayed,
                    row.original_outliers, row.improved_outliers, sighting.due, sighting.found, sighting.found_at_range,
                    row.runs_finished, row.cycles_held_back);
    }
  return csv;
}

ChartOptions chart_options(const std::vector<Table1Row>& rows, const std::string& title, const std::string& label) {
  ChartOptions options;
  options.title = title;
  options.x_label = "obstacle";
  options.y_label = label;
  for (const Table1Row& row : rows) options.x_names.push_back(name_of_obstacle(row.obstacle));
  return options;
}

/// A value of each row that has one, at its place on the chart.
template <typename Value>
PointCloud2 points_of(const std::vector<Table1Row>& rows, double shift, const Value& value) {
  PointCloud2 points;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (const std::optional<double> here = value(rows[k])) points.emplace_back(static_cast<double>(k) + shift, *here);
  return points;
}

template <typename Value>
PointCloud2 paper_points(const std::vector<Table1Row>& rows, const Value& value) {
  return points_of(rows, -0.12, [&](const Table1Row& row) -> std::optional<double> {
    const PaperTable1Row* paper = paper_row(row.obstacle);
    return paper != nullptr ? std::optional(value(*paper)) : std::nullopt;
  });
}

Chart draw_outliers(const std::vector<Table1Row>& rows) {
  Chart chart(chart_options(rows, "Table 1: the most outliers in a scan", "outliers"));
  chart.dots(paper_points(rows, [](const PaperTable1Row& row) { return row.most_outliers; }), colours::truth, 5.0,
             "the paper");
  chart.dots(
      points_of(rows, 0.12, [](const Table1Row& row) { return std::optional(static_cast<double>(row.most_outliers)); }),
      colours::outlier, 5.0, "slamicp, simulated");
  return chart;
}

void tell_counts(Page& page, const std::vector<Table1Row>& rows, const Table1Options& options) {
  std::vector<std::vector<std::string>> table{{"obstacle", "runs", "most outliers, paper", "most outliers, ours",
                                               "a scan, original agent", "a scan, improved agent",
                                               "found (slowest run)", "runs to the end", "cycles held back"}};
  for (const Table1Row& row : rows) table.push_back(counts_cells(row));
  page.heading("Outliers and obstacles");
  page.table(table);
  page.paragraph(
      format("Found: the agent has an obstacle where the true one stands. It is due once %d of the laser's "
             "beams meet it within %.0f m, by the truth; then there is %.1f s. Both agents are shown one "
             "scan in %zu; outliers a scan are of those. Held back: cycles in which the agent slowed down or "
             "stopped, though no obstacle blocks the path.",
             beams_to_find, near_range, in_time, options.every));
}

// ---- what does ------------------------------------------------------------------------------------------------------

std::string times_csv(const std::vector<Table1Row>& rows) {
  std::string csv =
      "obstacle,original_ms,improved_ms,improvement_percent,original_rebuilt_ms,improved_rebuilt_ms,"
      "improvement_rebuilt_percent,paper_original_ms,paper_improved_ms,paper_improvement_percent\n";
  for (const Table1Row& row : rows) {
    csv += format("%s,%.4f,%.4f,%.2f,%.4f,%.4f,%.2f", name_of_obstacle(row.obstacle).c_str(), 1e3 * row.original.once,
                  1e3 * row.improved.once, improvement(&AgentTimes::once, row), 1e3 * row.original.rebuilt,
                  1e3 * row.improved.rebuilt, improvement(&AgentTimes::rebuilt, row));
    if (const PaperTable1Row* paper = paper_row(row.obstacle))
      csv += format(",%.2f,%.2f,%.2f", paper->original_ms, paper->improved_ms,
                    improvement_percent(paper->original_ms, paper->improved_ms));
    else
      csv += ",,,";
    csv += '\n';
  }
  return csv;
}

Chart draw_times(const std::vector<Table1Row>& rows) {
  ChartOptions options = chart_options(rows, "Table 1: mean time of a control cycle", "time a cycle [ms]");
  options.logarithmic = true;
  Chart chart(options);
  const auto ours = [&](AgentTimes Table1Row::*agent, double AgentTimes::*how, double shift) {
    return points_of(rows, shift, [&](const Table1Row& row) { return std::optional(1e3 * (row.*agent).*how); });
  };
  chart.dots(paper_points(rows, [](const PaperTable1Row& row) { return row.original_ms; }), {90, 96, 106}, 4.0,
             "paper: LIBICP agent");
  chart.dots(paper_points(rows, [](const PaperTable1Row& row) { return row.improved_ms; }), {170, 176, 186}, 4.0,
             "paper: SLAMICP agent");
  chart.dots(ours(&Table1Row::original, &AgentTimes::rebuilt, 0.08), {126, 47, 142}, 4.0, "original, index rebuilt");
  chart.dots(ours(&Table1Row::original, &AgentTimes::once, 0.08), {196, 140, 206}, 4.0, "original");
  chart.dots(ours(&Table1Row::improved, &AgentTimes::rebuilt, 0.08), {0, 110, 60}, 4.0, "improved, index rebuilt");
  chart.dots(ours(&Table1Row::improved, &AgentTimes::once, 0.08), {90, 190, 110}, 4.0, "improved");
  return chart;
}

/// The largest of the rows' times over the smallest.
double spread_of_rows(const std::vector<Table1Row>& rows, AgentTimes Table1Row::*agent) {
  double least = 1e9;
  double most = 0.0;
  for (const Table1Row& row : rows) {
    least = std::min(least, (row.*agent).once);
    most = std::max(most, (row.*agent).once);
  }
  return least > 0.0 ? most / least : 0.0;
}

/// Mean over the rows with an obstacle, as the paper has it.
double mean_improvement(const std::vector<Table1Row>& rows, double AgentTimes::*how) {
  double sum = 0.0;
  double count = 0.0;
  for (const Table1Row& row : rows) {
    if (row.obstacle.empty()) continue;
    sum += improvement(how, row);
    ++count;
  }
  return count > 0.0 ? sum / count : 0.0;
}

void tell_times(Page& page, const std::vector<Table1Row>& rows, const OutlierCost& cost, const Folder& folder) {
  std::vector<std::vector<std::string>> table{{"obstacle", "LIBICP agent, paper ms", "SLAMICP agent, paper ms",
                                               "improvement, paper", "original ms", "improved ms", "improvement",
                                               "original rebuilt ms", "improved rebuilt ms", "improvement rebuilt"}};
  for (const Table1Row& row : rows) {
    const PaperTable1Row* paper = paper_row(row.obstacle);
    const auto of_paper = [&](double value, const char* unit) {
      return paper != nullptr ? format("%.2f%s", value, unit) : std::string("-");
    };
    const double percent = paper != nullptr ? improvement_percent(paper->original_ms, paper->improved_ms) : 0.0;
    table.push_back({name_of_obstacle(row.obstacle), of_paper(paper != nullptr ? paper->original_ms : 0.0, ""),
                     of_paper(paper != nullptr ? paper->improved_ms : 0.0, ""), of_paper(percent, " %"),
                     format("%.2f", 1e3 * row.original.once), format("%.3f", 1e3 * row.improved.once),
                     format("%.1f %%", improvement(&AgentTimes::once, row)), format("%.2f", 1e3 * row.original.rebuilt),
                     format("%.2f", 1e3 * row.improved.rebuilt),
                     format("%.1f %%", improvement(&AgentTimes::rebuilt, row))});
  }
  page.heading("Times, on the machine that wrote this page");
  page.table(table);
  page.paragraph(
      format("A whole control cycle: self-localization, path tracking, obstacle detection, obstacle evaluation. "
             "Improvement by the paper's eq. (8), 100 - 100 t_improved / t_original: mean %.1f %% with the index built "
             "once, %.1f %% with the index built anew for each scan, as the paper's MATLAB wrappers do (the paper: "
             "36.75 %%). ",
             mean_improvement(rows, &AgentTimes::once), mean_improvement(rows, &AgentTimes::rebuilt)) +
      "The original agent here is ours after the paper's section 2.4 and Figure 9a, not LIBICP; the paper's machine is "
      "another one.");
  page.paragraph(format("From obstacle to obstacle the mean time of a cycle differs by a factor of %.2f at most "
                        "(original agent), %.2f (improved agent). ",
                        spread_of_rows(rows, &Table1Row::original), spread_of_rows(rows, &Table1Row::improved)) +
                 (cost.scans == 0 ? std::string()
                                  : format("At the same places, %zu scans with %.0f outliers on average take the "
                                           "improved agent %.2f times as long as without (%.0f us and %.0f us).",
                                           cost.scans, cost.outliers_with, cost.ratio(), 1e6 * cost.seconds_with,
                                           1e6 * cost.seconds_without)));
  const Chart chart = draw_times(rows);
  folder.save("table1_times", chart);
  page.figure(chart.svg(), "Mean time of a control cycle, in powers of ten.");
}

/// Of the obstacle that shows the most outliers.
OutlierCost cost_of(const ExperimentSite& site, const std::vector<Table1Row>& rows, std::uint64_t seed) {
  const auto most = std::max_element(rows.begin(), rows.end(), [](const Table1Row& a, const Table1Row& b) {
    return a.most_outliers < b.most_outliers;
  });
  if (most->obstacle.empty()) return {};
  DrivePlan plan;
  plan.seed = seed;
  const RecordedDrive without = record_drive(site, plan);
  plan.obstacle = most->obstacle;
  return outlier_cost(site, record_drive(site, plan), without, 5, now);
}

Json row_json(const Table1Row& row, bool times) {
  Json json{{"obstacle", name_of_obstacle(row.obstacle)},
            {"most_outliers", row.most_outliers},
            {"scans", row.scans},
            {"replayed", row.replayed},
            {"outliers_mean_original", row.original_outliers},
            {"outliers_mean_improved", row.improved_outliers},
            {"found", row.obstacle.empty() || row.found_within(in_time)},
            {"runs_finished", row.runs_finished},
            {"cycles_held_back", row.cycles_held_back}};
  if (const PaperTable1Row* paper = paper_row(row.obstacle)) json["paper_most_outliers"] = paper->most_outliers;
  if (!times) return json;
  json["original_ms"] = 1e3 * row.original.once;
  json["improved_ms"] = 1e3 * row.improved.once;
  json["original_rebuilt_ms"] = 1e3 * row.original.rebuilt;
  json["improved_rebuilt_ms"] = 1e3 * row.improved.rebuilt;
  return json;
}

std::vector<std::string> all_obstacles() {
  std::vector<std::string> names;
  for (const PlacedObstacle& obstacle : corridor_obstacles()) names.push_back(obstacle.name);
  return names;
}

/// One line for people.
std::string brief(const Table1Row& row, bool times) {
  std::string line =
      format("%-9s most outliers %3zu, found: ", name_of_obstacle(row.obstacle).c_str(), row.most_outliers) +
      found_text(row);
  if (times)
    line += format("; original %.1f ms, improved %.3f ms, %.1f %% less (index rebuilt: %.1f ms, %.1f ms)",
                   1e3 * row.original.once, 1e3 * row.improved.once, improvement(&AgentTimes::once, row),
                   1e3 * row.original.rebuilt, 1e3 * row.improved.rebuilt);
  return line;
}

std::vector<Table1Row> measure(const ExperimentWords& words, const ExperimentSite& site, const Table1Options& options,
                               const Talk& talk) {
  std::vector<std::string> obstacles = words.obstacles_or(all_obstacles());
  obstacles.insert(obstacles.begin(), "");
  std::vector<Table1Row> rows;
  Progress progress("driving", obstacles.size());
  for (const std::string& obstacle : obstacles) {
    rows.push_back(table1_row(site, obstacle, options, words.times ? Clock(now) : Clock()));
    talk(brief(rows.back(), words.times));
    progress.step();
  }
  return rows;
}

/// The part of page, folder and summary that differs from machine to machine.
void add_times(const std::vector<Table1Row>& rows, const OutlierCost& cost, Page& page, const Folder& folder,
               Json& summary, const Talk& talk) {
  tell_times(page, rows, cost, folder);
  folder.save_text("table1_times.csv", times_csv(rows));
  const double once = mean_improvement(rows, &AgentTimes::once);
  const double rebuilt = mean_improvement(rows, &AgentTimes::rebuilt);
  const double between = spread_of_rows(rows, &Table1Row::improved);
  summary["mean_improvement_percent"] = once;
  summary["mean_improvement_rebuilt_percent"] = rebuilt;
  summary["time_ratio_between_obstacles"] = between;
  summary["time_ratio_of_many_outliers"] = cost.ratio();
  talk(
      format("times     %.1f %% less, index rebuilt %.1f %% (the paper: 36.75 %%); between obstacles a factor of %.2f; "
             "%.0f outliers a factor of %.2f at the same places",
             once, rebuilt, between, cost.outliers_with, cost.ratio()));
}

}  // namespace

Json run_table1(const ExperimentWords& words, const ExperimentSite& site, const Folder& folder, const Talk& talk) {
  const Table1Options options{words.seed, words.runs, words.every};
  const std::vector<Table1Row> rows = measure(words, site, options, talk);
  Page page("Table 1: both agents, twelve obstacles");
  tell_what_is_simulated(page, site);
  page.paragraph(
      format("The improved agent drives the reference path at 0.35 m/s, %d times with each obstacle, with noise of its "
             "own each "
             "time; then both agents are shown the same scans. The robot takes what lies %.1f m beside its path as in "
             "its way.",
             words.runs, DrivePlan{}.corridor_half_width));
  tell_counts(page, rows, options);
  const Chart outliers = draw_outliers(rows);
  folder.save("table1", outliers);
  page.figure(outliers.svg(),
              "The most outliers in a scan, at least 0.3 m from every map point. Where the paper's "
              "obstacles stood is known from a figure only.");
  folder.save_text("table1.csv", counts_csv(rows));

  Json list = Json::array();
  for (const Table1Row& row : rows) list.push_back(row_json(row, words.times));
  Json summary{{"every", words.every}, {"runs", words.runs}, {"rows", list}};
  if (words.times) add_times(rows, cost_of(site, rows, words.seed), page, folder, summary, talk);
  folder.save_text("table1.html", page.html());
  return summary;
}

}  // namespace slamicp::command
