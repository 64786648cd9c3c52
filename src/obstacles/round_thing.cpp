// SPDX-License-Identifier: Apache-2.0
#include "obstacles/round_thing.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace slamicp {
namespace {

constexpr double least_radius = 0.015;  // [m]
constexpr double most_radius = 1.0;     // beyond, it is a bent wall [m]

/// The algebraic circle (Kasa 1976), to begin with: too small on a short arc.
std::optional<RoundThing> algebraic_circle(PointView<2> points, const Point2& mean, std::size_t stride) noexcept {
  Matrix<3, 3> normal = Matrix<3, 3>::Zero();
  Vector<3> right = Vector<3>::Zero();
  for (std::size_t i = stride / 2; i < points.size(); i += stride) {
    const Point2 off = points[i] - mean;
    const Vector<3> row(off.x(), off.y(), 1.0);
    normal += row * row.transpose();
    right += off.squaredNorm() * row;
  }
  const Eigen::Matrix3d square = normal;
  const double determinant = square.determinant();
  if (!(std::abs(determinant) > 1e-18)) return std::nullopt;
  const Vector<3> found = square.inverse() * right;
  const Vector<2> centre = 0.5 * found.head<2>();
  const double radius2 = found[2] + centre.squaredNorm();
  if (!(radius2 > 0.0) || !std::isfinite(radius2)) return std::nullopt;
  return RoundThing{mean + centre, std::sqrt(radius2), Matrix<3, 3>::Zero()};
}

}  // namespace

std::optional<RoundThing> fit_round(PointView<2> points, PointView<2> lasers, double range_noise,
                                    const RoundSearch& search) noexcept {
  const std::size_t stride = search.stride;
  if (points.size() < 3 * stride || lasers.empty()) return std::nullopt;
  constexpr double flat2 = RoundThing::flattest * RoundThing::flattest;
  constexpr int most_steps = 20;
  constexpr int trials = 2;        // steps before it is worse than can be
  constexpr double enough = 1e-4;  // to move [m]
  Point2 mean = Point2::Zero();
  for (const Point2& point : points) mean += point / static_cast<double>(points.size());
  const auto laser = [&](std::size_t i) -> const Point2& { return lasers[lasers.size() > 1 ? i : 0]; };
  std::optional<RoundThing> circle = search.start ? *search.start : algebraic_circle(points, mean, stride);
  if (!circle) return std::nullopt;
  for (int step = 0; step < most_steps; ++step) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    double misfit = 0.0;
    for (std::size_t i = stride / 2; i < points.size(); i += stride) {
      const Vector<2> off = points[i] - circle->centre;
      const double distance = off.norm();
      if (!(distance > 0.0)) continue;
      const Vector<2> ray = points[i] - laser(i);
      const double head_on = ray.dot(off);
      const double cosine2 = std::max(head_on * head_on / (ray.squaredNorm() * distance * distance), flat2);
      const double weight = 1.0 / (cosine2 * range_noise * range_noise);
      const Eigen::Vector3d jacobian(-off.x() / distance, -off.y() / distance, -1.0);
      information += weight * jacobian * jacobian.transpose();
      const double error = distance - circle->radius;
      gradient += weight * error * jacobian;
      misfit += weight * error * error;
    }
    if (step >= trials && misfit * static_cast<double>(stride) > search.most) return std::nullopt;
    const Eigen::Matrix3d inverse = information.inverse();
    if (!inverse.allFinite()) return std::nullopt;
    const Eigen::Vector3d move = -inverse * gradient;
    circle->centre += move.head<2>();
    circle->radius += move[2];
    circle->covariance = inverse;
    if (!(circle->radius > 0.0 && circle->radius < 2.0 * most_radius)) return std::nullopt;
    if (move.norm() < enough) break;
  }
  const bool bends_away = (circle->centre - mean).dot(mean - laser(points.size() / 2)) > 0.0;
  if (!bends_away || circle->radius < least_radius || circle->radius > most_radius) return std::nullopt;
  return circle;
}

}  // namespace slamicp
