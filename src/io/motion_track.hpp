// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <slamicp/geometry/pose.hpp>

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

  /// Between two samples on the way with constant velocity (Sola, Deray, Atchuthan 2018, section II: exp and log).
  /// Before the first and after the last the motion goes on as it was, for 0.1 s at most; beyond, nothing.
  std::optional<Pose2> at(double stamp) const noexcept;

 private:
  std::vector<Sample> samples_;  ///< by stamp, each later than the one before
};

}  // namespace slamicp
