// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <slamicp/scan/odometry_model.hpp>

namespace slamicp {
namespace {

bool is_length(double metres) noexcept { return metres > 0.0 && std::isfinite(metres); }

}  // namespace

Pose2 DifferentialDrive::motion(const WheelTurns<2>& turns) const noexcept {
  const double left = left_radius * turns[0];
  const double right = right_radius * turns[1];
  return Pose2::exp({0.5 * (left + right), 0.0, (right - left) / wheel_distance});
}

WheelTurns<2> DifferentialDrive::turns(const Pose2& T_before_after) const noexcept {
  const Pose2::Tangent twist = T_before_after.log();
  const double around = 0.5 * wheel_distance * twist[2];
  return {(twist[0] - around) / left_radius, (twist[0] + around) / right_radius};
}

std::string DifferentialDrive::problem() const {
  if (!is_length(left_radius) || !is_length(right_radius)) return "a wheel's radius must be above 0 m";
  if (!is_length(wheel_distance)) return "wheel_distance must be above 0 m";
  return {};
}

namespace {

/// The direction in which wheel k pushes.
Vector<2> push_of(const OmniDrive& drive, int k) noexcept {
  const double angle = drive.first_wheel_angle + k * 2.0 * std::numbers::pi / 3.0;
  return {-std::sin(angle), std::cos(angle)};
}

}  // namespace

Pose2 OmniDrive::motion(const WheelTurns<3>& turns) const noexcept {
  // Wheel k rolls push_k . (x, y) + base_radius * theta; the pushes of the three sum to zero, their outer products to
  // 3/2 of the identity.
  Pose2::Tangent twist = Pose2::Tangent::Zero();
  for (int k = 0; k < wheels; ++k) {
    const double rolled = radii[static_cast<std::size_t>(k)] * turns[static_cast<std::size_t>(k)];
    twist.head<2>() += 2.0 / 3.0 * rolled * push_of(*this, k);
    twist[2] += rolled / (3.0 * base_radius);
  }
  return Pose2::exp(twist);
}

WheelTurns<3> OmniDrive::turns(const Pose2& T_before_after) const noexcept {
  const Pose2::Tangent twist = T_before_after.log();
  WheelTurns<3> turns{};
  for (int k = 0; k < wheels; ++k)
    turns[static_cast<std::size_t>(k)] =
        (push_of(*this, k).dot(twist.head<2>()) + base_radius * twist[2]) / radii[static_cast<std::size_t>(k)];
  return turns;
}

std::string OmniDrive::problem() const {
  if (!std::all_of(radii.begin(), radii.end(), is_length)) return "a wheel's radius must be above 0 m";
  if (!is_length(base_radius)) return "base_radius must be above 0 m";
  if (!std::isfinite(first_wheel_angle)) return "first_wheel_angle must be finite: give radians";
  return {};
}

Pose2 OdometryScale::motion(const Pose2& reported) const noexcept {
  Pose2::Tangent twist = reported.log();
  const double metres = twist.head<2>().norm();
  twist.head<2>() *= translation;
  twist[2] = rotation * twist[2] + drift_per_metre * metres;
  return Pose2::exp(twist);
}

std::string OdometryScale::problem() const {
  if (!is_length(translation) || !is_length(rotation)) return "scales must be above 0";
  if (!std::isfinite(drift_per_metre)) return "drift_per_metre must be finite";
  return {};
}

Matrix<3, 3> MotionNoise::covariance(const Pose2& T_before_after) const noexcept {
  const Pose2::Tangent twist = T_before_after.log();
  const double metres = twist.head<2>().norm();
  const double radians = std::abs(twist[2]);
  const auto variance = [&](double per_metre, double per_radian) {
    return per_metre * per_metre * metres + per_radian * per_radian * radians;
  };
  Matrix<3, 3> covariance = Matrix<3, 3>::Zero();
  covariance(0, 0) = covariance(1, 1) = variance(translation_per_metre, translation_per_radian);
  covariance(2, 2) = variance(rotation_per_metre, rotation_per_radian);
  return covariance;
}

std::string MotionNoise::problem() const {
  for (const double sigma : {translation_per_metre, translation_per_radian, rotation_per_metre, rotation_per_radian})
    if (!(sigma >= 0.0 && std::isfinite(sigma))) return "standard deviations must be 0 or more";
  return {};
}

}  // namespace slamicp
