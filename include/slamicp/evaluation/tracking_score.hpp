// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// Somebody who really is there.
struct TrackedTruth {
  int id = 0;
  Point2 position = Point2::Zero();        ///< [m]
  Vector<2> velocity = Vector<2>::Zero();  ///< [m/s]
  /// False: hardly to be seen. Whether a tracker finds it counts neither for it nor against it.
  bool counts = true;
};

/// Somebody that a tracker says is there.
struct TrackedGuess {
  int id = 0;
  Point2 position = Point2::Zero();        ///< [m]
  Vector<2> velocity = Vector<2>::Zero();  ///< [m/s]
};

/// The CLEAR MOT score of a tracker (Bernardin, Stiefelhagen 2008, "Evaluating multiple object tracking performance"):
/// in each frame truths and guesses are paired, pairs of the frame before first as long as they are near enough, then
/// the nearest; what is left over was missed, or is false.
class TrackingScore {
 public:
  /// @param reach  a guess this far from the truth is no guess of it [m], > 0
  explicit TrackingScore(double reach = 0.5) : reach_(reach) {}

  void add(std::span<const TrackedTruth> truths, std::span<const TrackedGuess> guesses);
  /// The frames to come are of another run: who was who is forgotten.
  void next_run();

  std::size_t frames() const noexcept { return frames_; }
  std::size_t truths() const noexcept { return truths_; }  ///< that counted, over all frames
  std::size_t found() const noexcept { return found_; }    ///< of them
  std::size_t missed() const noexcept { return truths_ - found_; }
  std::size_t false_ones() const noexcept { return false_; }
  /// Times a truth was found as another one than before.
  std::size_t switches() const noexcept { return switches_; }
  /// 1 - (missed + false + switches) / truths, eq. (2) of the paper; 1 without truths and guesses.
  double mota() const noexcept;
  /// Mean distance of the pairs [m], eq. (1).
  double motp() const noexcept { return found_ > 0 ? distance_ / static_cast<double>(found_) : 0.0; }
  /// Root mean square error of the pairs' velocities [m/s].
  double velocity_rmse() const noexcept;

  /// One line.
  std::string brief() const;

 private:
  double reach_;
  std::unordered_map<int, int> guess_of_;  // the last guess of each truth
  std::size_t frames_ = 0, truths_ = 0, found_ = 0, false_ = 0, switches_ = 0;
  double distance_ = 0.0;
  double velocity2_ = 0.0;
};

}  // namespace slamicp
