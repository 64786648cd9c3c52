// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <slamicp/evaluation/error_statistics.hpp>
#include <slamicp/geometry/trajectory.hpp>

namespace slamicp {

/// How the estimate is laid over the truth before absolute errors are taken.
enum class Alignment {
  none,   ///< as it is: both in the same map frame
  first,  ///< so that the first matched poses agree: an odometry that started anywhere
  se2     ///< the rigid motion with the least squares over positions (Horn 1987, Umeyama 1991): two different maps
};

/// An estimated and a true pose belong together if their stamps are the nearest within the tolerance; poses with the
/// very same stamp pair off in log order. Stamps need not rise: the order of poses is the estimate's, as logged.
struct TrajectoryErrorOptions {
  Alignment alignment = Alignment::none;  ///< of absolute errors; relative ones need none
  /// [s], >= 0. Too small: stamps rounded in a file are not found. Too big: poses of other moments count as errors.
  double stamp_tolerance = 1e-3;

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// How far an estimated trajectory is from the true one.
struct TrajectoryError {
  ErrorStatistics translation;  ///< [m]
  ErrorStatistics rotation;     ///< absolute angle [rad]
  std::size_t unmatched = 0;    ///< estimated poses with no true pose near their stamp
  Pose2 T_truth_estimate = {};  ///< the alignment that was applied; the identity for `none` and relative errors

  /// "translation mean 1.2 mm, rmse ... ; rotation ...; 300 poses"
  std::string brief() const;
};

/// Absolute error of every matched pose (ATE): inverse(truth) * T_truth_estimate * estimate. O(N log N).
///
/// With `se2` and a robot that hardly moved the rotation of the alignment is arbitrary: use `first` there.
/// Throws Error for an empty trajectory, values that are not finite, and no common stamp.
TrajectoryError absolute_error(const Trajectory& estimate, const Trajectory& truth,
                               const TrajectoryErrorOptions& options = {});

/// Error of the motion over each stretch of the given length (RPE): from every matched pose to the first one at least
/// `distance` metres further along the true path, inverse(true motion) * estimated motion. Stretches overlap. O(N log
/// N).
/// @param distance  [m], > 0
/// Throws Error as absolute_error does, and where the true path is shorter than the distance.
TrajectoryError relative_error(const Trajectory& estimate, const Trajectory& truth, double distance = 1.0,
                               const TrajectoryErrorOptions& options = {});

}  // namespace slamicp
