// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <string>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// The angle in (-pi, pi] [rad].
double wrap_angle(double angle) noexcept;

/// A rigid motion of the plane or of space, an element of SE(D).
///
/// `T_map_robot` maps robot coordinates into the map: `point_in_map = T_map_robot * point_in_robot`; products
/// chain like fractions: `T_map_laser = T_map_robot * T_robot_laser`.
///
/// Tangent vectors have the translation first: (x, y, theta) [m, m, rad] in the plane,
/// (x, y, z, rx, ry, rz) [m, rad] in space (Sola, Deray, Atchuthan 2018, "A micro Lie theory").
template <int D>
struct Pose;

/// A pose in the plane, (x, y, theta): the paper's P.
template <>
struct Pose<2> {
  static constexpr int degrees_of_freedom = 3;
  using Tangent = Vector<3>;

  double x = 0.0;      ///< [m]
  double y = 0.0;      ///< [m]
  double theta = 0.0;  ///< heading [rad], counter-clockwise; (-pi, pi] in every pose that the library returns

  static Pose exp(const Tangent& tangent) noexcept;
  Tangent log() const noexcept;
  /// Adjoint: `T * exp(v) == exp(T.adjoint() * v) * T`.
  Matrix<3, 3> adjoint() const noexcept;

  Pose inverse() const noexcept;
  Pose operator*(const Pose& other) const noexcept;
  Point2 operator*(const Point2& point) const noexcept;

  Matrix<2, 2> rotation() const noexcept;
  Point2 translation() const noexcept { return {x, y}; }
  static Pose from(const Matrix<2, 2>& rotation, const Point2& translation) noexcept;

  bool is_finite() const noexcept;
};

/// A pose in space.
template <>
struct Pose<3> {
  static constexpr int degrees_of_freedom = 6;
  using Tangent = Vector<6>;
  using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

  Point3 position = Point3::Zero();                 ///< [m]
  Quaternion orientation = Quaternion::Identity();  ///< unit length

  static Pose exp(const Tangent& tangent) noexcept;
  Tangent log() const noexcept;
  /// Adjoint: `T * exp(v) == exp(T.adjoint() * v) * T`.
  Matrix<6, 6> adjoint() const noexcept;

  Pose inverse() const noexcept;
  Pose operator*(const Pose& other) const noexcept;
  Point3 operator*(const Point3& point) const noexcept;

  Matrix<3, 3> rotation() const noexcept { return orientation.toRotationMatrix(); }
  Point3 translation() const noexcept { return position; }
  static Pose from(const Matrix<3, 3>& rotation, const Point3& translation) noexcept;

  bool is_finite() const noexcept;
};

using Pose2 = Pose<2>;
using Pose3 = Pose<3>;

/// A pose at hand for many points: `transform * point` is `pose * point`, with sine and cosine taken once.
template <int D>
struct RigidTransform {
  Matrix<D, D> rotation;
  Point<D> translation;

  explicit RigidTransform(const Pose<D>& pose = {}) noexcept
      : rotation(pose.rotation()), translation(pose.translation()) {}

  /// In the plane it is spelled out: to the last bit what the pose says, where Eigen would multiply and add in one step
  /// on those processors that can.
  Point<D> operator*(const Point<D>& point) const noexcept {
    if constexpr (D == 2)
      return {rotation(0, 0) * point.x() + rotation(0, 1) * point.y() + translation.x(),
              rotation(1, 0) * point.x() + rotation(1, 1) * point.y() + translation.y()};
    else
      return rotation * point + translation;
  }
};

/// How far apart two poses are: metres and radians, both >= 0.
struct PoseDistance {
  double translation = 0.0;  ///< [m]
  double rotation = 0.0;     ///< [rad]
};
template <int D>
PoseDistance distance(const Pose<D>& a, const Pose<D>& b) noexcept;

/// Part of the way from the identity to `motion`: exp(share * log(motion)).
template <int D>
Pose<D> interpolate(const Pose<D>& motion, double share) noexcept {
  return Pose<D>::exp(share * motion.log());
}

/// "1.200 m, 0.400 m, 15.00 deg"
std::string to_string(const Pose2& pose);
std::string to_string(const Pose3& pose);

}  // namespace slamicp
