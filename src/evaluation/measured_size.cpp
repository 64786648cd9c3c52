// SPDX-License-Identifier: Apache-2.0
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include <slamicp/evaluation/measured_size.hpp>

namespace slamicp {
namespace {

constexpr double farthest = 0.3;     // between a thing and what was made of it [m]
constexpr double on_a_line = 1e-14;  // determinant of the mean of rows of length sqrt(2): an arc of half a degree

}  // namespace

std::optional<Circle> fit_circle(PointView<2> points) {
  if (points.size() < 3) return std::nullopt;
  const auto count = static_cast<double>(points.size());
  Point2 mean = Point2::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) mean += points[i] / count;
  Circle circle{mean, 0.0};
  for (std::size_t i = 0; i < points.size(); ++i) circle.radius += (points[i] - mean).norm() / count;

  for (int iteration = 0; iteration < 100; ++iteration) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector<2> off = points[i] - circle.centre;
      const double distance = off.norm();
      if (!(distance > 0.0)) continue;
      const Eigen::Vector3d jacobian(-off.x() / distance, -off.y() / distance, -1.0);
      information += jacobian * jacobian.transpose() / count;
      gradient += (distance - circle.radius) / count * jacobian;
    }
    if (!(information.determinant() > on_a_line)) return std::nullopt;
    const Eigen::Vector3d step = -information.inverse() * gradient;
    circle.centre += step.head<2>();
    circle.radius += step[2];
    if (step.norm() < 1e-7) return circle.radius > 0.0 ? std::optional(circle) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<MeasuredThing> measured_thing(const PointCloud2& outliers, const PlacedObstacle& placed,
                                            const ReconstructionOptions& options) {
  const std::vector<Obstacle> found = reconstruct_obstacles(outliers, options);
  const auto off = [&](const Obstacle& obstacle) { return distance(placed, obstacle.box.centre); };
  const auto nearest = std::min_element(found.begin(), found.end(),
                                        [&](const Obstacle& a, const Obstacle& b) { return off(a) < off(b); });
  if (nearest == found.end() || off(*nearest) > farthest) return std::nullopt;
  MeasuredThing thing;
  thing.box = nearest->box;
  for (const int i : nearest->points) thing.points.push_back(outliers[static_cast<std::size_t>(i)]);
  thing.round = fit_circle(thing.points);
  return thing;
}

}  // namespace slamicp
