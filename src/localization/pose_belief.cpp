// SPDX-License-Identifier: Apache-2.0
#include "localization/pose_belief.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace slamicp {
namespace {

using Eigen::Matrix3d;

/// The root of a covariance that changes smoothly with it, in the map's axes: so the unit variables mean the same from
/// scan to scan. Its columns are those variables, its rows the error as seen from the robot.
Matrix3d root_in_map(const Matrix3d& in_robot, double heading) noexcept {
  constexpr double unit = 5.0;  // [m]: what a turn moves there counts as a shift
  Matrix3d turn = Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(heading), -std::sin(heading), std::sin(heading), std::cos(heading);
  const Eigen::Vector3d scale(1.0, 1.0, unit);
  const Matrix3d in_map = scale.asDiagonal() * turn * in_robot * turn.transpose() * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(in_map);
  const Eigen::Vector3d roots = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Matrix3d root = eigen.eigenvectors() * roots.asDiagonal() * eigen.eigenvectors().transpose();
  return turn.transpose() * scale.cwiseInverse().asDiagonal() * root;
}

Matrix3d white_noise(double translation, double rotation) noexcept {
  return Eigen::Vector3d(translation * translation, translation * translation, rotation * rotation).asDiagonal();
}

}  // namespace

void PoseBelief::forget(double translation, double rotation) noexcept {
  white_ = white_noise(translation, rotation);
  by_map_.setZero();
  by_scale_.setZero();
}

void PoseBelief::move(const Pose2& motion) noexcept {
  const Matrix<3, 3> carry = motion.inverse().adjoint();
  white_ = carry * white_ * carry.transpose();
  by_map_ = carry * by_map_;
  by_scale_ = carry * by_scale_;
}

void PoseBelief::move_by_odometry(const Pose2& motion) noexcept {
  if (!motion.is_finite()) return;
  move(motion);
  white_ += noise_.odometry.covariance(motion) + white_noise(noise_.least_translation, noise_.least_rotation);
  const Pose2::Tangent twist = motion.log();
  by_scale_.col(0).head<2>() += noise_.odometry_scale * twist.head<2>();
  by_scale_(2, 1) += noise_.odometry_scale * twist[2];
}

void PoseBelief::move_by_velocity(const Pose2& motion) noexcept {
  if (!motion.is_finite()) return;
  move(motion);
  white_ += white_noise(noise_.velocity_translation, noise_.velocity_rotation);
}

PosePrior PoseBelief::prior(const Pose2& mean) const noexcept {
  const Matrix3d all = white_ + by_scale_ * by_scale_.transpose();
  return {mean, all.inverse()};
}

void PoseBelief::fuse(const Uncertainty& match, const PosePrior& prior, double heading) noexcept {
  if (!match.known) return;
  const Matrix3d information = match.information;
  const Matrix3d all = information + match.trust_in_prior() * prior.information;
  const Matrix3d gain = all.inverse() * information;
  const Matrix3d rest = Matrix3d::Identity() - gain;
  const Matrix3d systematic = match.systematic;
  // Blind directions have no gain.
  const Matrix3d held = match.covariance - match.unheld;
  const Matrix3d white = held - systematic;
  white_ = rest * white_ * rest.transpose() + gain * white * gain.transpose();
  by_map_ = rest * by_map_ + gain * root_in_map(systematic, heading);
  by_scale_ = rest * by_scale_;
}

}  // namespace slamicp
