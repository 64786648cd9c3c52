// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// Where the robot was, by its wheels, at some moments; and in between.
class MotionTrack {
 public:
  struct Sample {
    double stamp = 0.0;  ///< [s]
    Pose2 T_odom_robot;
  };

  MotionTrack() = default;
  /// @param samples  in any order; of several with one stamp the first counts
  explicit MotionTrack(std::vector<Sample> samples);

  bool empty() const noexcept { return samples_.empty(); }
  std::size_t size() const noexcept { return samples_.size(); }
  /// By stamp, each later than the one before.
  const std::vector<Sample>& samples() const noexcept { return samples_; }

  /// One sample more, which may come late. False, and nothing added, where it is not finite or there is one with its
  /// stamp. O(1) where it is the latest.
  bool add(const Sample& sample);
  /// Forgets all samples before the last one that is not later than `stamp`.
  void forget_before(double stamp) noexcept;

  /// Between two samples on the way with constant velocity (Sola, Deray, Atchuthan 2018, section II: exp and log).
  /// Before the first and after the last the motion goes on as it was, for 0.1 s at most; beyond, nothing.
  std::optional<Pose2> at(double stamp) const noexcept;

 private:
  std::vector<Sample> samples_;
};

/// Where the wheels saw the robot at the scan's first beam, and how far it moved until the last. False where they do
/// not tell where it was.
bool set_odometry(const MotionTrack& odometry, LaserScan& scan) noexcept;

}  // namespace slamicp
