// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/jump_trial.hpp>
#include <slamicp/evaluation/stretch_trials.hpp>

namespace slamicp {
namespace {

constexpr std::size_t scans_of_a_stretch = 80;

}  // namespace

StretchTrials::StretchTrials(const ReferenceRun& run, std::uint64_t seed, const LocalizerOptions& options)
    : run_(run), random_(seed), options_(options) {
  if (run.scans.size() < 100 || run.scans.size() != run.reference.size())
    throw Error("a run needs at least 100 scans, and a reference pose for each", "StretchTrials");
}

/// At another place of the run with any heading, or here with another one.
Pose2 StretchTrials::elsewhere(const Pose2& truth) {
  constexpr int tries = 1000;
  const bool turned_only = random_.uniform() < 0.3;
  for (int k = 0; !turned_only && k < tries; ++k) {
    const double which = random_.uniform() * static_cast<double>(run_.reference.size());
    const double heading = random_.uniform(-std::numbers::pi, std::numbers::pi);
    const Point2 there = run_.reference[static_cast<std::size_t>(which)].translation();
    const double shift = (there - truth.translation()).norm();
    if (shift >= 2.0 && shift <= 6.0) return {there.x(), there.y(), heading};
  }
  return turned_on_the_spot(truth, random_);
}

StretchOutcome StretchTrials::draw(bool put_elsewhere) {
  const std::size_t last_start = run_.scans.size() - scans_of_a_stretch;
  const auto first = static_cast<std::size_t>(random_.uniform() * static_cast<double>(last_start));
  Localizer localizer(run_.map, options_);
  localizer.set_pose(put_elsewhere ? elsewhere(run_.reference[first]) : run_.reference[first]);
  StretchOutcome outcome;
  double sure_since = run_.scans[first].stamp;
  bool was_alarm = false;
  for (std::size_t k = 0; k < scans_of_a_stretch; ++k) {
    const LaserScan& scan = run_.scans[first + k];
    const Pose2& truth = run_.reference[first + k];
    const Fix& fix = localizer.update(scan);
    const bool right = is_right(fix.pose, truth);
    const bool doubted = fix.quality.doubted();
    if (watcher_) watcher_(fix, truth);
    if (right || doubted) sure_since = scan.stamp;
    outcome.longest_confident = std::max(outcome.longest_confident, scan.stamp - sure_since);
    if (!outcome.noticed && k < static_cast<std::size_t>(scans_to_notice) && (right || doubted)) {
      outcome.noticed = true;
      outcome.right_again = right;
    }
    outcome.right_scans += right;
    const bool alarm = right && doubted;
    outcome.alarms += alarm && !was_alarm && k >= static_cast<std::size_t>(scans_to_notice);
    was_alarm = alarm;
  }
  return outcome;
}

}  // namespace slamicp
