// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/LU>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// Alike in all directions. @param sigma  [m] or [m/s]
inline Matrix<2, 2> round_noise(double sigma) noexcept { return sigma * sigma * Matrix<2, 2>::Identity(); }

/// A place that is measured and a velocity that follows: a Kalman filter whose acceleration is white noise (Bar-Shalom,
/// Li, Kirubarajan 2001, section 6.2.2).
struct ConstantVelocity {
  Point2 position = Point2::Zero();
  Vector<2> velocity = Vector<2>::Zero();
  Matrix<2, 2> of_position = Matrix<2, 2>::Zero();  // covariances
  Matrix<2, 2> of_both = Matrix<2, 2>::Zero();      // rows of the position, columns of the velocity
  Matrix<2, 2> of_velocity = Matrix<2, 2>::Zero();

  /// @param seconds  ahead, >= 0
  /// @param agility  spectral density of the acceleration [m^2/s^3]
  void predict(double seconds, double agility) noexcept {
    const Matrix<2, 2> one = Matrix<2, 2>::Identity();
    position += seconds * velocity;
    const Matrix<2, 2> cross_terms = of_both + of_both.transpose();
    of_position +=
        seconds * cross_terms + seconds * seconds * of_velocity + agility * seconds * seconds * seconds / 3.0 * one;
    of_both += seconds * of_velocity + 0.5 * agility * seconds * seconds * one;
    of_velocity += agility * seconds * one;
  }

  void correct(const Point2& place, const Matrix<2, 2>& noise) noexcept {
    const Matrix<2, 2> weight = Matrix<2, 2>(of_position + noise).inverse();
    const Matrix<2, 2> gain = of_position * weight;
    const Matrix<2, 2> velocity_gain = of_both.transpose() * weight;
    const Vector<2> off = place - position;
    position += gain * off;
    velocity += velocity_gain * off;
    const Matrix<2, 2> both = of_both;
    of_both -= gain * both;
    of_velocity -= velocity_gain * both;
    const Matrix<2, 2> left = of_position - gain * of_position;
    of_position = 0.5 * (left + left.transpose());
  }

  /// It stands: the velocity is as good as known.
  void halt() noexcept {
    velocity.setZero();
    of_both.setZero();
    of_velocity = round_noise(0.1);
  }
};

}  // namespace slamicp
