// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// A motion and the time it took: the robot goes on like that.
struct Velocity {
  Pose2 motion;
  double seconds = 0.0;  ///< 0: not known

  /// How far it gets in `time` [s], which may be negative. A long time is no reason to fly far.
  Pose2 over(double time) const noexcept {
    return seconds > 0.0 ? interpolate(motion, std::clamp(time / seconds, -3.0, 3.0)) : Pose2{};
  }
};

/// Where the robot has got to since its last pose: by odometry, else with the velocity of its last two poses.
class Prediction {
 public:
  explicit Prediction(bool use_odometry) noexcept : use_odometry_(use_odometry) {}

  void forget() noexcept { has_last_ = has_velocity_ = false; }

  /// T_last_now, from the last pose to the scan's stamp.
  Pose2 motion_until(const LaserScan& scan) const noexcept {
    if (!has_last_) return {};
    if (is_by_odometry(scan)) return last_odometry_->inverse() * *scan.T_odom_robot;
    return has_velocity_ ? interpolate(velocity_, share_of_last_interval(scan.stamp)) : Pose2{};
  }

  bool has_last() const noexcept { return has_last_; }
  /// Whether motion_until() is what the wheels say.
  bool is_by_odometry(const LaserScan& scan) const noexcept {
    return has_last_ && last_odometry_ && has_odometry(scan);
  }

  /// How fast it goes at the scan's stamp.
  /// @param motion  since the last scan, predicted or, once the scan is matched, measured
  Velocity velocity_at(const LaserScan& scan, const Pose2& motion) const noexcept {
    const double seconds = scan.stamp - last_stamp_;
    return has_last_ && seconds > 0.0 && seconds < longest ? Velocity{motion, seconds} : Velocity{};
  }

  /// How far it got since the last scan, where it is found to be at `middle` now. Both are the poses half way through
  /// the sweep: a match with a wrong velocity is least wrong there, and what is fed back from it dies away.
  Pose2 motion_to(const Pose2& middle) const noexcept { return last_middle_.inverse() * middle; }

  /// @param middle  T_map_robot half way through the sweep
  void remember(const LaserScan& scan, const Pose2& middle) noexcept {
    if (has_last_) {
      velocity_ = motion_to(middle);
      interval_ = scan.stamp - last_stamp_;
    }
    has_velocity_ = has_last_;
    has_last_ = true;
    last_middle_ = middle;
    last_stamp_ = scan.stamp;
    last_odometry_ = has_odometry(scan) ? scan.T_odom_robot : std::nullopt;
  }

  /// How far the robot moved during the sweep by its wheels, where that is known and is to be used.
  const Pose2* sweep_motion(const LaserScan& scan) const noexcept {
    return use_odometry_ && scan.sweep_motion && scan.sweep_motion->is_finite() ? &*scan.sweep_motion : nullptr;
  }

  /// Whether the robot's pose by its wheels is known at the scan's stamp, and is to be used.
  bool has_odometry(const LaserScan& scan) const noexcept {
    return use_odometry_ && scan.T_odom_robot && scan.T_odom_robot->is_finite();
  }

 private:
  static constexpr double longest = 1.0;  // [s]: after a longer gap the mean velocity tells nothing

  // How the time since the last scan compares to the interval before it. Stamps that stand still or run backwards
  // (the Intel log's do) tell nothing: then scans count as evenly spaced. A long gap is no reason to fly far.
  double share_of_last_interval(double stamp) const noexcept {
    const double now = stamp - last_stamp_;
    if (!(now > 0.0) || !(interval_ > 0.0)) return 1.0;
    return std::min(now / interval_, 3.0);
  }

  bool use_odometry_;
  bool has_last_ = false;
  bool has_velocity_ = false;
  Pose2 last_middle_;
  double last_stamp_ = 0.0;
  std::optional<Pose2> last_odometry_;
  Pose2 velocity_;  // motion from the last scan but one to the last
  double interval_ = 0.0;
};

}  // namespace slamicp
