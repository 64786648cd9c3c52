// SPDX-License-Identifier: Apache-2.0
// the agent's whole control cycle against the bare match of the same scan, where an obstacle gives many outliers
//
// scripts/measure agent_cycle [--obstacle D3] [--least 100] [--repeats 7] [--every 15]
//
// The three take turns scan by scan: the agent's cycle; a Localizer that computes the pose and nothing else; the match
// alone, of points that are ready. Times: the median of each scan's repeats, then the median over the scans that have
// at least so many outliers, and over those that have at most two. Then the two forms of the agent take turns drive by
// drive, one scan in --every: what each subtask takes (the paper's Figure 9), medians over all scans.
#include <slamicp/evaluation/recorded_drive.hpp>
#include <slamicp/registration/icp.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// One contender's times of a scan, one a repeat [s].
using Times = std::vector<double>;

struct ScanTimes {
  std::size_t outliers = 0;
  Times cycle, localizer, match, detection, evaluation;
};

/// Goes through the drive once with all three.
void race(const ExperimentSite& site, const RecordedDrive& drive, std::vector<ScanTimes>& times) {
  Agent agent(site.map, site.path, agent_of(drive.plan), now);
  LocalizerOptions pose_only = agent_of(drive.plan).localization;
  pose_only.outputs = {};
  Localizer localizer(site.map, pose_only);
  Icp<2> icp(pose_only.icp());
  agent.set_pose(drive.samples.front().truth);
  localizer.set_pose(drive.samples.front().truth);
  for (std::size_t k = 0; k < drive.scans.size(); ++k) {
    const double start = now();
    const Cycle& cycle = agent.step(drive.scans[k]);
    const double after_cycle = now();
    localizer.update(drive.scans[k]);
    const double after_localizer = now();
    icp.align(site.map->indexed(), cycle.fix->scan.in_robot, cycle.fix->predicted, Outputs{});
    const double after_match = now();
    ScanTimes& scan = times[k];
    scan.outliers = cycle.fix->outliers().size();
    scan.cycle.push_back(after_cycle - start);
    scan.localizer.push_back(after_localizer - after_cycle);
    scan.match.push_back(after_match - after_localizer);
    scan.detection.push_back(cycle.times.obstacle_detection);
    scan.evaluation.push_back(cycle.times.obstacle_evaluation);
  }
}

struct Row {
  std::string what;
  std::size_t scans = 0;
  double outliers = 0.0;
  double cycle, localizer, match, detection, evaluation;  // [us]
};

/// Of the scans with so many outliers.
Row row_of(const std::vector<ScanTimes>& times, const std::string& what, std::size_t least, std::size_t most) {
  std::vector<double> outliers, cycle, localizer, match, detection, evaluation;
  for (std::size_t k = 1; k < times.size(); ++k) {  // at the first, memory is laid out
    const ScanTimes& scan = times[k];
    if (scan.outliers < least || scan.outliers > most) continue;
    outliers.push_back(static_cast<double>(scan.outliers));
    cycle.push_back(1e6 * quantile(scan.cycle, 0.5));
    localizer.push_back(1e6 * quantile(scan.localizer, 0.5));
    match.push_back(1e6 * quantile(scan.match, 0.5));
    detection.push_back(1e6 * quantile(scan.detection, 0.5));
    evaluation.push_back(1e6 * quantile(scan.evaluation, 0.5));
  }
  return {what,
          cycle.size(),
          mean(outliers),
          quantile(cycle, 0.5),
          quantile(localizer, 0.5),
          quantile(match, 0.5),
          quantile(detection, 0.5),
          quantile(evaluation, 0.5)};
}

// ---- the two forms of the agent, subtask by subtask

struct Subtask {
  const char* name;
  double CycleTimes::*time;
};
constexpr Subtask subtasks[] = {{"self-localization", &CycleTimes::localization},
                                {"path tracking", &CycleTimes::path_tracking},
                                {"obstacle detection", &CycleTimes::obstacle_detection},
                                {"obstacle evaluation", &CycleTimes::obstacle_evaluation}};

/// The times of one form: of each subtask, of each scan shown, one a repeat.
using FormTimes = std::vector<std::vector<Times>>;

void replay(const ExperimentSite& site, const RecordedDrive& drive, AgentForm form, std::size_t every,
            FormTimes& times) {
  AgentOptions options = agent_of(drive.plan);
  options.form = form;
  Agent agent(site.map, site.path, options, now);
  agent.set_pose(drive.samples.front().truth);
  for (std::size_t k = 0; k < drive.scans.size(); k += every) {
    const Cycle& cycle = agent.step(drive.scans[k]);
    for (std::size_t s = 0; s < std::size(subtasks); ++s) times[s][k / every].push_back(cycle.times.*subtasks[s].time);
  }
}

/// The median over the scans but the first [us].
double median_of_scans(const std::vector<Times>& scans) {
  std::vector<double> medians;
  for (std::size_t k = 1; k < scans.size(); ++k) medians.push_back(1e6 * quantile(scans[k], 0.5));
  return quantile(medians, 0.5);
}

void two_forms(const ExperimentSite& site, const RecordedDrive& drive, std::size_t every, int repeats, Json& results) {
  const std::size_t shown = (drive.scans.size() + every - 1) / every;
  FormTimes original(std::size(subtasks), std::vector<Times>(shown));
  FormTimes improved = original;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    replay(site, drive, AgentForm::original, every, original);
    replay(site, drive, AgentForm::improved, every, improved);
  }
  Table table({"subtask", "original agent us", "improved agent us"});
  double sums[2] = {0.0, 0.0};
  const auto add = [&](const char* name, double theirs, double ours) {
    table.add({name, text("%.1f", theirs), text("%.1f", ours)});
    results.push_back({{"subtask", name}, {"original_us", theirs}, {"improved_us", ours}});
  };
  for (std::size_t s = 0; s < std::size(subtasks); ++s) {
    const double theirs = median_of_scans(original[s]);
    const double ours = median_of_scans(improved[s]);
    add(subtasks[s].name, theirs, ours);
    sums[0] += theirs;
    sums[1] += ours;
  }
  add("sum", sums[0], sums[1]);
  std::printf("The two forms of the agent (the paper's Figure 9), index built once, one scan in %zu.\n\n", every);
  table.print();
}

void agent_cycle(const Words& words) {
  const ExperimentSite site = explore_site(1);
  DrivePlan plan;
  plan.obstacle = words["--obstacle"];
  const RecordedDrive drive = record_drive(site, plan);
  std::vector<ScanTimes> times(drive.scans.size());
  for (int repeat = 0; repeat < static_cast<int>(words.number("--repeats")); ++repeat) race(site, drive, times);

  const auto least = static_cast<std::size_t>(words.number("--least"));
  Table table({"scans", "number", "outliers", "whole cycle us", "of it detection", "of it evaluation",
               "localizer, pose only us", "bare match us", "cycle / localizer", "cycle / bare match"});
  Json results = Json::array();
  for (const Row& row : {row_of(times, text("at least %zu outliers", least), least, drive.most_outliers()),
                         row_of(times, "at most 2 outliers", 0, 2)}) {
    table.add({row.what, text("%zu", row.scans), text("%.1f", row.outliers), text("%.1f", row.cycle),
               text("%.1f", row.detection), text("%.1f", row.evaluation), text("%.1f", row.localizer),
               text("%.1f", row.match), text("%.2f", row.cycle / std::max(1e-9, row.localizer)),
               text("%.2f", row.cycle / std::max(1e-9, row.match))});
    results.push_back({{"scans", row.what},
                       {"number", row.scans},
                       {"outliers", row.outliers},
                       {"cycle_us", row.cycle},
                       {"localizer_us", row.localizer},
                       {"match_us", row.match}});
  }
  std::printf("Obstacle %s on the reference path, %zu scans, most outliers %zu.\n\n", plan.obstacle.c_str(),
              drive.scans.size(), drive.most_outliers());
  table.print();
  two_forms(site, drive, static_cast<std::size_t>(words.number("--every")), static_cast<int>(words.number("--repeats")),
            results);
  save_results("agent_cycle", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] {
    agent_cycle(Words(argc, argv, {{"--obstacle", "D3"}, {"--least", "100"}, {"--repeats", "7"}, {"--every", "15"}}));
  });
}
