// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// How far each wheel has turned [rad].
template <int wheels>
using WheelTurns = std::array<double, wheels>;

/// Two driven wheels on one axle. The robot's frame has its origin midway between them, x ahead.
struct DifferentialDrive {
  static constexpr int wheels = 2;  ///< left, right

  double left_radius = 0.1;     ///< [m], > 0
  double right_radius = 0.1;    ///< [m], > 0
  double wheel_distance = 0.4;  ///< between the points where the wheels touch the ground [m], > 0

  /// T_before_after: an arc, exact where the wheels turned evenly.
  Pose2 motion(const WheelTurns<2>& turns) const noexcept;
  /// What the wheels turn for a motion along an arc; what goes sideways is lost.
  WheelTurns<2> turns(const Pose2& T_before_after) const noexcept;
  /// The first rule broken, in words; empty if none is.
  std::string problem() const;
};

/// Three omnidirectional wheels at equal angles around the robot's centre, as the paper's APR-02 has them. Wheel k
/// stands `base_radius` from the centre at the angle `first_wheel_angle + k * 120 deg`, and turning forward pushes the
/// robot counter-clockwise around its centre.
struct OmniDrive {
  static constexpr int wheels = 3;

  std::array<double, 3> radii = {0.1, 0.1, 0.1};  ///< [m], > 0
  double base_radius = 0.2;                       ///< from the centre to each wheel [m], > 0
  double first_wheel_angle = 0.0;                 ///< where the first wheel stands [rad]

  /// T_before_after: exact where the wheels turned evenly.
  Pose2 motion(const WheelTurns<3>& turns) const noexcept;
  /// What the wheels turn for a motion with constant velocity.
  WheelTurns<3> turns(const Pose2& T_before_after) const noexcept;
  std::string problem() const;
};

/// What odometry reports and what it should: for a robot whose wheels are not known one by one.
struct OdometryScale {
  double translation = 1.0;  ///< true metres in a metre reported
  double rotation = 1.0;     ///< true radians in a radian reported
  double drift_per_metre =
      0.0;  ///< how much the robot really veers to the left while it reports going straight [rad/m]

  /// The true motion where odometry reports this one.
  Pose2 motion(const Pose2& reported) const noexcept;
  std::string problem() const;
};

/// How unsure a motion by odometry is. Variances grow with the way: the same whether a metre comes in one step or in a
/// hundred.
struct MotionNoise {
  double translation_per_metre = 0.03;   ///< after one metre, ahead and sideways, 1 sigma [m]
  double translation_per_radian = 0.01;  ///< after turning one radian [m]
  double rotation_per_metre = 0.015;     ///< after one metre [rad]
  double rotation_per_radian = 0.05;     ///< after turning one radian [rad]

  /// Of the error (x, y, theta) as seen from the robot after the motion.
  Matrix<3, 3> covariance(const Pose2& T_before_after) const noexcept;
  std::string problem() const;
};

}  // namespace slamicp
