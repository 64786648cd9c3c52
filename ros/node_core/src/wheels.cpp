// SPDX-License-Identifier: Apache-2.0
#include "wheels.hpp"

namespace slamicp::node {
namespace {

constexpr double kept_seconds = 10.0;

bool is_jump(const MotionTrack::Sample& from, const MotionTrack::Sample& to) noexcept {
  constexpr double fastest = 20.0;        // [m/s], [rad/s]
  constexpr double least_distance = 0.5;  // [m]: stamps of one moment may differ by rounding
  constexpr double least_rotation = 1.0;  // [rad]
  const double seconds = to.stamp - from.stamp;
  if (seconds < -1.0) return true;
  if (seconds <= 0.0) return false;  // late, not wrong
  const PoseDistance way = distance(from.T_odom_robot, to.T_odom_robot);
  return (way.translation > least_distance && way.translation > fastest * seconds) ||
         (way.rotation > least_rotation && way.rotation > fastest * seconds);
}

}  // namespace

void Wheels::add(const MotionTrack::Sample& sample) {
  if (!track_.empty() && is_jump(track_.samples().back(), sample)) {
    track_ = {};
    ++jumps_;
  }
  if (!track_.add(sample)) return;
  ever_ = true;
  track_.forget_before(last_stamp() - kept_seconds);
}

void Wheels::begin_again(double stamp) {
  if (!reach(stamp + 1.0)) return;
  track_ = {};
  ++jumps_;
}

void FrozenWheels::add(double stamp, const Pose2& by_scans, const Pose2& by_wheels) {
  constexpr double look_every = 2.0;  // [s]
  constexpr double goes = 0.3;        // [m]
  constexpr double stands = 0.01;     // [m]
  if (!begun_ || stamp < stamp_) {
    begun_ = true;
  } else {
    const double by_wheels_way = distance(by_wheels_, by_wheels).translation;
    if (by_wheels_way > stands) frozen_ = false;
    if (stamp - stamp_ < look_every) return;
    frozen_ = by_wheels_way <= stands && distance(by_scans_, by_scans).translation > goes;
  }
  stamp_ = stamp;
  by_scans_ = by_scans;
  by_wheels_ = by_wheels;
}

}  // namespace slamicp::node
