// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/localization/prediction_noise.hpp>
#include <slamicp/registration/uncertainty.hpp>

namespace slamicp {

/// How sure the pose is, from scan to scan: a Kalman filter for the error that considers what it cannot estimate
/// (Schmidt 1966, "Application of state-space methods to navigation problems").
///
/// The error as seen from the robot is a sum of three: a white part W, that averages out over scans; a part M u by the
/// map's error, u the same three unit normal variables for all scans, that does not; and a part C s by odometry's two
/// scale errors s, that grows with the way. A fix is K of the match and I - K of the prediction, so each part of the
/// error is, whatever K is:
///   W+ = (I - K) W (I - K)^T + K R K^T,  M+ = (I - K) M + K N,  C+ = (I - K) C,
/// R the match's covariance by ranges and N N^T that by the map. A robot at rest thus comes to W of little and M = N:
/// no surer than one scan's systematic part.
class PoseBelief {
 public:
  explicit PoseBelief(const PredictionNoise& noise) noexcept : noise_(noise) {}

  /// @param translation  how well a pose that was set is known, 1 sigma [m]  @param rotation  [rad]
  void forget(double translation, double rotation) noexcept;

  /// The robot moved, T_before_after.
  void move_by_odometry(const Pose2& motion) noexcept;
  void move_by_velocity(const Pose2& motion) noexcept;

  /// The prediction as a prior. @param mean  T_map_robot, predicted
  PosePrior prior(const Pose2& mean) const noexcept;

  /// The pose was found from a match and this prior. @param heading  of the robot in the map [rad]
  void fuse(const Uncertainty& match, const PosePrior& prior, double heading) noexcept;

  /// Of the pose's error as seen from the robot.
  Matrix<3, 3> covariance() const noexcept {
    return white_ + by_map_ * by_map_.transpose() + by_scale_ * by_scale_.transpose();
  }

 private:
  void move(const Pose2& motion) noexcept;

  PredictionNoise noise_;
  Matrix<3, 3> white_ = Matrix<3, 3>::Zero();
  Matrix<3, 3> by_map_ = Matrix<3, 3>::Zero();    // M
  Matrix<3, 2> by_scale_ = Matrix<3, 2>::Zero();  // C, in standard deviations
};

}  // namespace slamicp
