// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <numbers>

#include <slamicp/geometry/angle.hpp>
#include <slamicp/geometry/pose.hpp>

namespace slamicp {
namespace {

constexpr double pi = std::numbers::pi;
/// sin(a)/a and (1 - cos(a))/a, by their series where a is small.
struct SincPair {
  double sinc;
  double cosc;
};
SincPair sinc_pair(double a) noexcept {
  if (std::abs(a) < 1e-4) return {1.0 - a * a / 6.0, a / 2.0 - a * a * a / 24.0};
  return {std::sin(a) / a, (1.0 - std::cos(a)) / a};
}

Matrix<3, 3> skew(const Vector<3>& v) noexcept {
  Matrix<3, 3> s;
  s << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return s;
}

/// V of SE(3): the translation of exp(v) is V(rotation vector) * translation part of v.
Matrix<3, 3> left_jacobian(const Vector<3>& omega) noexcept {
  const double angle = omega.norm();
  const Matrix<3, 3> w = skew(omega);
  if (angle < 1e-4) return Matrix<3, 3>::Identity() + 0.5 * w + w * w / 6.0;
  const double a2 = angle * angle;
  return Matrix<3, 3>::Identity() + (1.0 - std::cos(angle)) / a2 * w + (angle - std::sin(angle)) / (a2 * angle) * w * w;
}

Vector<3> rotation_vector(Pose3::Quaternion q) noexcept {
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  const double scale = sine < 1e-10 ? 2.0 / q.w() : 2.0 * std::atan2(sine, q.w()) / sine;
  return scale * q.vec();
}

}  // namespace

double wrap_angle(double angle) noexcept {
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? wrapped + 2.0 * pi : wrapped;
}

// ---------------------------------------------------------------------------------------------- SE(2)

Pose2 Pose2::exp(const Tangent& v) noexcept {
  const auto [sinc, cosc] = sinc_pair(v[2]);
  return {sinc * v[0] - cosc * v[1], cosc * v[0] + sinc * v[1], wrap_angle(v[2])};
}

Pose2::Tangent Pose2::log() const noexcept {
  const double angle = wrap_angle(theta);
  const auto [sinc, cosc] = sinc_pair(angle);
  const double scale = 1.0 / (sinc * sinc + cosc * cosc);
  return {scale * (sinc * x + cosc * y), scale * (sinc * y - cosc * x), angle};
}

Matrix<3, 3> Pose2::adjoint() const noexcept {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  Matrix<3, 3> adjoint;
  adjoint << c, -s, y, s, c, -x, 0.0, 0.0, 1.0;
  return adjoint;
}

Pose2 Pose2::inverse() const noexcept {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  return {-c * x - s * y, s * x - c * y, wrap_angle(-theta)};
}

Pose2 Pose2::operator*(const Pose2& other) const noexcept {
  const Point2 position = *this * other.translation();
  return {position.x(), position.y(), wrap_angle(theta + other.theta)};
}

Point2 Pose2::operator*(const Point2& point) const noexcept {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  return {c * point.x() - s * point.y() + x, s * point.x() + c * point.y() + y};
}

Matrix<2, 2> Pose2::rotation() const noexcept {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  Matrix<2, 2> rotation;
  rotation << c, -s, s, c;
  return rotation;
}

Pose2 Pose2::from(const Matrix<2, 2>& rotation, const Point2& translation) noexcept {
  return {translation.x(), translation.y(), wrap_angle(std::atan2(rotation(1, 0), rotation(0, 0)))};
}

bool Pose2::is_finite() const noexcept { return std::isfinite(x) && std::isfinite(y) && std::isfinite(theta); }

// ---------------------------------------------------------------------------------------------- SE(3)

Pose3 Pose3::exp(const Tangent& v) noexcept {
  const Vector<3> omega = v.tail<3>();
  const double angle = omega.norm();
  const double half_sinc = angle < 1e-10 ? 0.5 : std::sin(0.5 * angle) / angle;
  Quaternion q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = half_sinc * omega;
  return {left_jacobian(omega) * v.head<3>(), q.normalized()};
}

Pose3::Tangent Pose3::log() const noexcept {
  const Vector<3> omega = rotation_vector(orientation);
  Tangent v;
  v.head<3>() = left_jacobian(omega).inverse() * position;
  v.tail<3>() = omega;
  return v;
}

Matrix<6, 6> Pose3::adjoint() const noexcept {
  const Matrix<3, 3> r = rotation();
  Matrix<6, 6> adjoint = Matrix<6, 6>::Zero();
  adjoint.topLeftCorner<3, 3>() = r;
  adjoint.topRightCorner<3, 3>() = skew(position) * r;
  adjoint.bottomRightCorner<3, 3>() = r;
  return adjoint;
}

Pose3 Pose3::inverse() const noexcept {
  const Quaternion back = orientation.conjugate();
  return {-(back * position), back};
}

Pose3 Pose3::operator*(const Pose3& other) const noexcept {
  return {*this * other.position, (orientation * other.orientation).normalized()};
}

Point3 Pose3::operator*(const Point3& point) const noexcept { return orientation * point + position; }

Pose3 Pose3::from(const Matrix<3, 3>& rotation, const Point3& translation) noexcept {
  return {translation, Quaternion(rotation).normalized()};
}

bool Pose3::is_finite() const noexcept { return position.allFinite() && orientation.coeffs().allFinite(); }

// ---------------------------------------------------------------------------------------------- both

template <>
PoseDistance distance<2>(const Pose2& a, const Pose2& b) noexcept {
  return {std::hypot(a.x - b.x, a.y - b.y), std::abs(wrap_angle(a.theta - b.theta))};
}

template <>
PoseDistance distance<3>(const Pose3& a, const Pose3& b) noexcept {
  return {(a.position - b.position).norm(), rotation_vector(a.orientation.conjugate() * b.orientation).norm()};
}

std::string to_string(const Pose2& pose) {
  char text[96];
  std::snprintf(text, sizeof text, "%.3f m, %.3f m, %.2f deg", pose.x, pose.y, pose.theta * deg_per_rad);
  return text;
}

std::string to_string(const Pose3& pose) {
  const Vector<3> v = rotation_vector(pose.orientation) * deg_per_rad;
  char text[192];
  std::snprintf(text, sizeof text, "%.3f m, %.3f m, %.3f m, turned by (%.2f, %.2f, %.2f) deg", pose.position.x(),
                pose.position.y(), pose.position.z(), v.x(), v.y(), v.z());
  return text;
}

}  // namespace slamicp
