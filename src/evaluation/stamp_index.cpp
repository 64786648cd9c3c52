// SPDX-License-Identifier: Apache-2.0
#include "evaluation/stamp_index.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <slamicp/error.hpp>

namespace slamicp {

StampIndex::StampIndex(const Trajectory& trajectory) {
  entries_.reserve(trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) entries_.push_back({trajectory[i].stamp, i});
  std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.stamp < b.stamp; });
}

std::optional<std::size_t> StampIndex::find(double stamp, double tolerance, std::size_t occurrence) const noexcept {
  const auto before = [](const Entry& entry, double wanted) { return entry.stamp < wanted; };
  const auto later = std::lower_bound(entries_.begin(), entries_.end(), stamp, before);
  auto nearest = later;
  if (later != entries_.begin()) {
    const auto earlier = std::prev(later);
    if (later == entries_.end() || stamp - earlier->stamp <= later->stamp - stamp) nearest = earlier;
  }
  if (nearest == entries_.end() || !(std::abs(nearest->stamp - stamp) <= tolerance)) return std::nullopt;

  // Of the stamps equal to the nearest, the first, then as many further as asked for.
  nearest = std::lower_bound(entries_.begin(), entries_.end(), nearest->stamp, before);
  for (; occurrence > 0; --occurrence) {
    const auto next = std::next(nearest);
    if (next == entries_.end() || next->stamp != nearest->stamp) break;
    nearest = next;
  }
  return nearest->position;
}

std::vector<std::size_t> StampIndex::occurrences() const {
  std::vector<std::size_t> result(entries_.size(), 0);
  for (std::size_t i = 1; i < entries_.size(); ++i)
    if (entries_[i].stamp == entries_[i - 1].stamp) result[entries_[i].position] = result[entries_[i - 1].position] + 1;
  return result;
}

void check_trajectory(const Trajectory& trajectory, const char* name) {
  if (trajectory.empty()) throw Error("there is no pose", name, "give a trajectory with at least one pose");
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    if (!std::isfinite(trajectory[i].stamp) || !trajectory[i].pose.is_finite())
      throw Error("a stamp or pose is not a finite number",
                  std::string(name) + ", pose " + std::to_string(i) + " counted from 0",
                  "leave the pose out, or give the predicted pose");
}

}  // namespace slamicp
