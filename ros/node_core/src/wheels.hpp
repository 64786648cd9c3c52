// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <slamicp/scan/motion_track.hpp>

namespace slamicp::node {

/// Odometry as it comes, and what goes wrong with it.
class Wheels {
 public:
  /// One sample. Its history begins anew where stamps jump back by more than a second, or where the robot would have
  /// gone at more than 20 m/s or turned at more than 20 rad/s: somebody has set odometry to zero.
  void add(const MotionTrack::Sample& sample);
  /// Forgets what is later than `stamp` by more than a second: it is of a recording that begins again.
  void begin_again(double stamp);

  bool ever() const noexcept { return ever_; }
  /// True where samples reach so far.
  bool reach(double stamp) const noexcept { return !track_.empty() && track_.samples().back().stamp >= stamp; }
  double last_stamp() const noexcept { return track_.empty() ? 0.0 : track_.samples().back().stamp; }
  const MotionTrack& track() const noexcept { return track_; }
  /// Counts the jumps: poses before and after one have nothing to do with each other.
  std::uint64_t jumps() const noexcept { return jumps_; }

 private:
  MotionTrack track_;
  bool ever_ = false;
  std::uint64_t jumps_ = 0;
};

/// Notices wheels that stand while scans say that the robot goes.
class FrozenWheels {
 public:
  /// The pose by scans and the one by wheels, at a scan's stamp [s].
  void add(double stamp, const Pose2& by_scans, const Pose2& by_wheels);
  void clear() noexcept { begun_ = frozen_ = false; }
  bool frozen() const noexcept { return frozen_; }

 private:
  bool begun_ = false;
  bool frozen_ = false;
  double stamp_ = 0.0;
  Pose2 by_scans_, by_wheels_;
};

}  // namespace slamicp::node
