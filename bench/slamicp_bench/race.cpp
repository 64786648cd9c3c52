// SPDX-License-Identifier: Apache-2.0
#include "race.hpp"

#include <algorithm>

namespace slamicp::bench {
namespace {

/// A contender on its way through the scans.
class Runner {
 public:
  Runner(const Scene& scene, const Contender& contender) : scene_(scene), contender_(contender) {
    const measure::Stopwatch watch;
    matcher_ = contender.prepare(scene.map)();
    prepare_ms_ = watch.milliseconds();
    const Trial& first = scene.trials.front();
    matcher_->localize(first.scan, first.guess, scratch_);  // what it allocates once is not a scan's time
  }

  void run(std::size_t begin, std::size_t end, double budget_s) {
    for (std::size_t k = begin; k < end && used_us_ < 1e6 * budget_s; ++k) {
      const Trial& trial = scene_.trials[k];
      const measure::Stopwatch watch;
      matcher_->localize(trial.scan, trial.guess, scratch_);
      times_us_.push_back(watch.microseconds());
      used_us_ += times_us_.back();
      if (estimates_.size() == k) estimates_.push_back(scratch_);  // the first round
    }
  }

  Row row() const {
    Row row;
    row.name = contender_.name;
    row.what = contender_.what;
    row.prepare_ms = prepare_ms_;
    row.samples = times_us_.size();
    row.median_us = measure::quantile(times_us_, 0.5);
    row.p99_us = measure::quantile(times_us_, 0.99);
    judge(scene_, estimates_, row);
    return row;
  }

 private:
  const Scene& scene_;
  const Contender& contender_;
  std::unique_ptr<Matcher> matcher_;
  double prepare_ms_ = 0.0;
  double used_us_ = 0.0;
  Estimate scratch_;
  std::vector<double> times_us_;
  std::vector<Estimate> estimates_;
};

}  // namespace

std::vector<Row> race(const Scene& scene, std::span<const Contender> contenders, const RaceOptions& options) {
  std::vector<Runner> runners;
  runners.reserve(contenders.size());
  for (const Contender& contender : contenders) runners.emplace_back(scene, contender);

  std::size_t turn = 0;
  for (int round = 0; round < options.rounds; ++round)
    for (std::size_t begin = 0; begin < scene.trials.size(); begin += options.block, ++turn) {
      const std::size_t end = std::min(begin + options.block, scene.trials.size());
      for (std::size_t k = 0; k < runners.size(); ++k)
        runners[(k + turn) % runners.size()].run(begin, end, options.budget_s);
    }

  std::vector<Row> rows;
  rows.reserve(runners.size());
  for (const Runner& runner : runners) rows.push_back(runner.row());
  return rows;
}

}  // namespace slamicp::bench
