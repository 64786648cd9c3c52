// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/agent_replay.hpp>

namespace slamicp {
namespace {

/// The median of each scan's times over the replays of a drive.
std::vector<double> medians(std::vector<std::vector<double>>& replays) {
  std::vector<double> middle(replays.front().size());
  std::vector<double> times(replays.size());
  for (std::size_t k = 0; k < middle.size(); ++k) {
    for (std::size_t r = 0; r < replays.size(); ++r) times[r] = replays[r][k];
    const auto at = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), at, times.end());
    middle[k] = *at;
  }
  return middle;
}

/// The sample that stands nearest to a place on the path. Samples advance along it.
std::size_t sample_at(const RecordedDrive& drive, double travelled) {
  const auto after = std::lower_bound(drive.samples.begin(), drive.samples.end(), travelled,
                                      [](const DriveSample& sample, double place) { return sample.travelled < place; });
  const auto index = static_cast<std::size_t>(after - drive.samples.begin());
  return std::min(index, drive.samples.size() - 1);
}

}  // namespace

double AgentReplay::mean_seconds() const noexcept {
  return seconds.empty() ? 0.0
                         : std::accumulate(seconds.begin(), seconds.end(), 0.0) / static_cast<double>(seconds.size());
}

double AgentReplay::mean_outliers() const noexcept {
  const std::size_t sum = std::accumulate(outliers.begin(), outliers.end(), std::size_t{0});
  return outliers.empty() ? 0.0 : static_cast<double>(sum) / static_cast<double>(outliers.size());
}

AgentReplay replay_agent(const ExperimentSite& site, const RecordedDrive& drive, const ReplayOptions& options,
                         const Clock& clock) {
  if (options.every < 1) throw Error("every must be at least 1", "ReplayOptions", "1 shows every scan");
  if (drive.scans.empty()) throw Error("the drive kept no scans", "replay_agent", "record it with keeps_scans");
  AgentOptions agent_options = agent_of(drive.plan);
  agent_options.form = options.form;
  agent_options.rebuild_index = options.rebuild_index;
  Agent agent(site.map, site.path, agent_options, clock);
  agent.set_pose(drive.samples.front().truth);
  AgentReplay replay;
  for (std::size_t k = 0; k < drive.scans.size(); k += options.every) {
    const Cycle& cycle = agent.step(drive.scans[k]);
    if (k == 0) continue;
    replay.seconds.push_back(cycle.times.total());
    replay.outliers.push_back(cycle.fix->outliers().size());
    replay.poses.push_back(cycle.fix->pose);
  }
  return replay;
}

double improvement_percent(double original_seconds, double improved_seconds) noexcept {
  return original_seconds > 0.0 ? 100.0 - 100.0 * improved_seconds / original_seconds : 0.0;  // eq. (8)
}

OutlierCost outlier_cost(const ExperimentSite& site, const RecordedDrive& with, const RecordedDrive& without,
                         int repeats, const Clock& clock) {
  std::vector<std::vector<double>> times_with;
  std::vector<std::vector<double>> times_without;
  for (int repeat = 0; repeat < std::max(1, repeats); ++repeat) {
    times_with.push_back(replay_agent(site, with, {}, clock).seconds);
    times_without.push_back(replay_agent(site, without, {}, clock).seconds);
  }
  const std::vector<double> median_with = medians(times_with);
  const std::vector<double> median_without = medians(times_without);
  const std::size_t many = (with.most_outliers() + 1) / 2;
  OutlierCost cost;
  for (std::size_t k = 1; k < with.samples.size(); ++k) {
    if (with.samples[k].outliers < many) continue;
    const std::size_t other = std::max<std::size_t>(1, sample_at(without, with.samples[k].travelled));
    ++cost.scans;
    cost.outliers_with += static_cast<double>(with.samples[k].outliers);
    cost.outliers_without += static_cast<double>(without.samples[other].outliers);
    cost.seconds_with += median_with[k - 1];
    cost.seconds_without += median_without[other - 1];
  }
  const double count = std::max(1.0, static_cast<double>(cost.scans));
  for (double* sum : {&cost.outliers_with, &cost.outliers_without, &cost.seconds_with, &cost.seconds_without})
    *sum /= count;
  return cost;
}

}  // namespace slamicp
