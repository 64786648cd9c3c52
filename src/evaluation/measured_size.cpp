// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include <slamicp/evaluation/measured_size.hpp>

namespace slamicp {
namespace {

constexpr double farthest = 0.3;  // between a thing and what was made of it [m]

}  // namespace

std::optional<Circle> fit_circle(PointView<2> points) {
  if (points.size() < 3) return std::nullopt;
  const auto count = static_cast<double>(points.size());
  Point2 mean = Point2::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) mean += points[i] / count;
  Circle circle{mean, 0.0};
  for (std::size_t i = 0; i < points.size(); ++i) circle.radius += (points[i] - mean).norm() / count;

  for (int iteration = 0; iteration < 100; ++iteration) {
    Matrix<3, 3> information = Matrix<3, 3>::Zero();
    Vector<3> gradient = Vector<3>::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector<2> off = points[i] - circle.centre;
      const double distance = off.norm();
      if (!(distance > 0.0)) continue;
      const Vector<3> jacobian(-off.x() / distance, -off.y() / distance, -1.0);
      information += jacobian * jacobian.transpose();
      gradient += (distance - circle.radius) * jacobian;
    }
    const auto solver = information.ldlt();
    if (!(solver.vectorD().minCoeff() > 1e-9 * count)) return std::nullopt;  // on a line
    const Vector<3> step = -solver.solve(gradient);
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
