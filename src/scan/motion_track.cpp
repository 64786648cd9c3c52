// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <slamicp/scan/laser_scan.hpp>
#include <slamicp/scan/motion_track.hpp>

namespace slamicp {
namespace {

bool is_earlier(const MotionTrack::Sample& a, const MotionTrack::Sample& b) noexcept { return a.stamp < b.stamp; }

bool is_sound(const MotionTrack::Sample& sample) noexcept {
  return std::isfinite(sample.stamp) && sample.T_odom_robot.is_finite();
}

}  // namespace

MotionTrack::MotionTrack(std::vector<Sample> samples) : samples_(std::move(samples)) {
  std::erase_if(samples_, [](const Sample& sample) { return !is_sound(sample); });
  std::stable_sort(samples_.begin(), samples_.end(), is_earlier);
  const auto same_stamp = [](const Sample& a, const Sample& b) { return a.stamp == b.stamp; };
  samples_.erase(std::unique(samples_.begin(), samples_.end(), same_stamp), samples_.end());
}

bool MotionTrack::add(const Sample& sample) {
  if (!is_sound(sample)) return false;
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), sample, is_earlier);
  if (after != samples_.end() && after->stamp == sample.stamp) return false;
  samples_.insert(after, sample);
  return true;
}

void MotionTrack::forget_before(double stamp) noexcept {
  const auto after =
      std::upper_bound(samples_.begin(), samples_.end(), Sample{stamp, {}}, is_earlier);  // the first one that is later
  if (after - samples_.begin() > 1) samples_.erase(samples_.begin(), after - 1);
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
  // At a sample it is that sample, to the last bit, whether others have followed or not.
  if (stamp == from.stamp) return from.T_odom_robot;
  if (stamp == after->stamp) return after->T_odom_robot;
  const double share = (stamp - from.stamp) / interval;
  if (share < 0.0 && interval < shortest_told) return from.T_odom_robot;
  if (share > 1.0 && interval < shortest_told) return after->T_odom_robot;
  return from.T_odom_robot * interpolate(from.T_odom_robot.inverse() * after->T_odom_robot, share);
}

bool set_odometry(const MotionTrack& odometry, LaserScan& scan) noexcept {
  scan.T_odom_robot = odometry.at(scan.stamp);
  scan.sweep_motion.reset();
  if (!scan.T_odom_robot) return false;
  if (sweep_time(scan) == 0.0) return true;
  if (const std::optional<Pose2> last = odometry.at(scan.stamp + sweep_time(scan)))
    scan.sweep_motion = scan.T_odom_robot->inverse() * *last;
  return true;
}

}  // namespace slamicp
