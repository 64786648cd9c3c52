// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/table1.hpp>

namespace slamicp {
namespace {

constexpr PaperTable1Row paper_rows[] = {{"A1", 82, 71.06, 45.33}, {"A2", 45, 69.29, 43.71}, {"A3", 24, 70.48, 44.43},
                                         {"B1", 41, 70.52, 44.58}, {"B2", 29, 68.78, 43.39}, {"B3", 43, 70.49, 44.64},
                                         {"C1", 23, 71.36, 44.66}, {"C2", 12, 70.56, 44.41}, {"C3", 44, 70.52, 44.45},
                                         {"D1", 63, 70.33, 45.01}, {"D2", 44, 70.51, 44.74}, {"D3", 123, 70.35, 44.61}};

/// Adds up replays of one agent.
struct Sum {
  double seconds = 0.0;
  double outliers = 0.0;
  double scans = 0.0;

  void add(const AgentReplay& replay) {
    const auto count = static_cast<double>(replay.seconds.size());
    seconds += replay.mean_seconds() * count;
    outliers += replay.mean_outliers() * count;
    scans += count;
  }
  double mean_seconds() const { return scans > 0.0 ? seconds / scans : 0.0; }
  double mean_outliers() const { return scans > 0.0 ? outliers / scans : 0.0; }
};

struct Sums {
  Sum original, original_rebuilt, improved, improved_rebuilt;

  void add(const ExperimentSite& site, const RecordedDrive& drive, std::size_t every, const Clock& clock) {
    original.add(replay_agent(site, drive, {AgentForm::original, false, every}, clock));
    improved.add(replay_agent(site, drive, {AgentForm::improved, false, every}, clock));
    original_rebuilt.add(replay_agent(site, drive, {AgentForm::original, true, every}, clock));
    improved_rebuilt.add(replay_agent(site, drive, {AgentForm::improved, true, every}, clock));
  }
};

void add(Table1Row& row, const RecordedDrive& drive) {
  row.most_outliers = std::max(row.most_outliers, drive.most_outliers());
  row.scans += drive.scans.size();
  row.runs_finished += drive.finished ? 1 : 0;
  for (const DriveSample& sample : drive.samples) row.cycles_held_back += sample.decision != Decision::ignore;
  row.sightings.push_back(sighting_of(drive));
}

}  // namespace

std::span<const PaperTable1Row> paper_table1() noexcept { return paper_rows; }

std::string Table1Options::problem() const {
  if (runs < 1) return "runs must be at least 1";
  if (every < 1) return "every must be at least 1: it shows every scan";
  return {};
}

bool Table1Row::found_within(double seconds) const noexcept {
  return std::all_of(sightings.begin(), sightings.end(), [&](const Sighting& sighting) {
    return sighting.was_found() && (!sighting.was_due() || sighting.delay() <= seconds);
  });
}

Table1Row table1_row(const ExperimentSite& site, const std::string& obstacle, const Table1Options& options,
                     const Clock& clock) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "Table1Options");
  Table1Row row;
  row.obstacle = obstacle;
  Sums sums;
  for (int run = 0; run < options.runs; ++run) {
    DrivePlan plan;
    plan.obstacle = obstacle;
    plan.seed = options.seed + static_cast<std::uint64_t>(run);
    const RecordedDrive drive = record_drive(site, plan);
    add(row, drive);
    sums.add(site, drive, options.every, clock);
  }
  row.replayed = static_cast<std::size_t>(sums.improved.scans);
  row.original = {sums.original.mean_seconds(), sums.original_rebuilt.mean_seconds()};
  row.improved = {sums.improved.mean_seconds(), sums.improved_rebuilt.mean_seconds()};
  row.original_outliers = sums.original.mean_outliers();
  row.improved_outliers = sums.improved.mean_outliers();
  return row;
}

}  // namespace slamicp
