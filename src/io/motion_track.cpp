// SPDX-License-Identifier: Apache-2.0
#include "io/motion_track.hpp"

#include <algorithm>
#include <cmath>

namespace slamicp {

MotionTrack::MotionTrack(std::vector<Sample> samples) : samples_(std::move(samples)) {
  std::erase_if(samples_,
                [](const Sample& sample) { return !std::isfinite(sample.stamp) || !sample.T_odom_robot.is_finite(); });
  std::stable_sort(samples_.begin(), samples_.end(),
                   [](const Sample& a, const Sample& b) { return a.stamp < b.stamp; });
  const auto same_stamp = [](const Sample& a, const Sample& b) { return a.stamp == b.stamp; };
  samples_.erase(std::unique(samples_.begin(), samples_.end(), same_stamp), samples_.end());
}

std::optional<Pose2> MotionTrack::at(double stamp) const noexcept {
  constexpr double longest_beyond = 0.1;   // [s]
  constexpr double shortest_told = 0.005;  // [s]; a shorter interval at an end tells no velocity
  if (samples_.empty()) return std::nullopt;
  if (!(stamp >= samples_.front().stamp - longest_beyond && stamp <= samples_.back().stamp + longest_beyond))
    return std::nullopt;
  if (samples_.size() == 1) return samples_.front().T_odom_robot;
  const auto after = std::upper_bound(samples_.begin() + 1, samples_.end() - 1, stamp,
                                      [](double moment, const Sample& sample) { return moment < sample.stamp; });
  const Sample& from = *(after - 1);
  const double interval = after->stamp - from.stamp;
  const double share = (stamp - from.stamp) / interval;
  if (share < 0.0 && interval < shortest_told) return from.T_odom_robot;
  if (share > 1.0 && interval < shortest_told) return after->T_odom_robot;
  return from.T_odom_robot * interpolate(from.T_odom_robot.inverse() * after->T_odom_robot, share);
}

}  // namespace slamicp
