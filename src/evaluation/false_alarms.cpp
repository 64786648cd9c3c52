// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/false_alarms.hpp>

namespace slamicp {

std::string FalseAlarmOptions::problem() const {
  if (!(same_place > 0.0)) return "same_place must be above 0 m";
  if (confirmations < 1 || releases < 1) return "confirmations and releases must be at least 1";
  return {};
}

FalseAlarms::FalseAlarms(const FalseAlarmOptions& options) : options_(options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "FalseAlarmOptions");
}

void FalseAlarms::next_drive() noexcept {
  suspects_.clear();
  last_ = Decision::ignore;
}

void FalseAlarms::add(const Cycle& cycle) {
  stops_ += cycle.decision == Decision::stop && last_ != Decision::stop;
  slow_downs_ += cycle.decision == Decision::slow && last_ == Decision::ignore;
  last_ = cycle.decision;

  seen_ += cycle.obstacles.size();
  for (Suspect& suspect : suspects_) suspect.here = false;
  for (const EvaluatedObstacle& evaluated : cycle.obstacles) {
    const Point2& place = evaluated.obstacle.box.centre;
    const auto known = std::find_if(suspects_.begin(), suspects_.end(), [&](const Suspect& suspect) {
      return (suspect.place - place).norm() < options_.same_place;
    });
    if (known == suspects_.end())
      suspects_.push_back({place, 0, 0, true});
    else
      known->here = true;
  }
  for (Suspect& suspect : suspects_) {
    suspect.missed = suspect.here ? 0 : suspect.missed + 1;
    const bool was_confirmed = suspect.in_a_row >= options_.confirmations;
    if (suspect.here) ++suspect.in_a_row;
    if (!suspect.here && !was_confirmed) suspect.in_a_row = 0;
    if (!was_confirmed && suspect.in_a_row >= options_.confirmations) confirmed_.push_back(suspect.place);
  }
  std::erase_if(suspects_, [&](const Suspect& suspect) { return suspect.missed >= options_.releases; });
}

}  // namespace slamicp
