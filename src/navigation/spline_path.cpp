// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include <slamicp/error.hpp>
#include <slamicp/navigation/spline_path.hpp>

namespace slamicp {
namespace {

constexpr double finest_table_step = 0.002;  // [m]: chord and arc then differ by less than a micrometre

void check(std::span<const Point2> waypoints) {
  if (waypoints.size() < 2) throw Error("a path needs two waypoints or more", "waypoints", "add the point to drive to");
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::string where = "waypoint " + std::to_string(i) + ", counted from 0";
    if (!is_finite<2>(waypoints[i])) throw Error("a coordinate is not a finite number", where, "give metres");
    if (i > 0 && (waypoints[i] - waypoints[i - 1]).norm() < 1e-6)
      throw Error("the same waypoint twice in a row", where, "leave one out");
  }
}

// Second derivatives of the natural spline: the tridiagonal system of the textbooks, by elimination and back
// substitution.
PointCloud2 natural_second_derivatives(const PointCloud2& knots, const std::vector<double>& parameters) {
  const std::size_t count = knots.size();
  PointCloud2 second(count, Point2::Zero());
  std::vector<double> pivot(count, 1.0);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double before = parameters[i] - parameters[i - 1];
    const double after = parameters[i + 1] - parameters[i];
    const double factor = i > 1 ? before / pivot[i - 1] : 0.0;
    pivot[i] = 2.0 * (before + after) - factor * before;
    second[i] = 6.0 * ((knots[i + 1] - knots[i]) / after - (knots[i] - knots[i - 1]) / before) - factor * second[i - 1];
  }
  for (std::size_t i = count - 1; i-- > 1;) {
    const double after = parameters[i + 1] - parameters[i];
    second[i] = (second[i] - after * second[i + 1]) / pivot[i];
  }
  return second;
}

struct CurvePoint {
  Point2 position;
  Point2 derivative;
  Point2 second_derivative;
};

CurvePoint evaluate(const PointCloud2& knots, const std::vector<double>& parameters, const PointCloud2& second,
                    double parameter) noexcept {
  const auto beyond = std::upper_bound(parameters.begin() + 1, parameters.end() - 1, parameter);
  const auto i = static_cast<std::size_t>(beyond - parameters.begin());
  const double width = parameters[i] - parameters[i - 1];
  const double b = (parameter - parameters[i - 1]) / width;
  const double a = 1.0 - b;
  const Point2 position = a * knots[i - 1] + b * knots[i] +
                          ((a * a * a - a) * second[i - 1] + (b * b * b - b) * second[i]) * (width * width / 6.0);
  const Point2 derivative = (knots[i] - knots[i - 1]) / width +
                            ((1.0 - 3.0 * a * a) * second[i - 1] + (3.0 * b * b - 1.0) * second[i]) * (width / 6.0);
  return {position, derivative, a * second[i - 1] + b * second[i]};
}

}  // namespace

SplinePath::SplinePath(std::span<const Point2> waypoints) {
  check(waypoints);
  knots_.assign(waypoints.begin(), waypoints.end());
  parameters_ = {0.0};
  for (std::size_t i = 1; i < knots_.size(); ++i)
    parameters_.push_back(parameters_.back() + (knots_[i] - knots_[i - 1]).norm());
  second_derivatives_ = natural_second_derivatives(knots_, parameters_);

  const auto steps = static_cast<std::size_t>(std::ceil(parameters_.back() / finest_table_step));
  table_step_ = parameters_.back() / static_cast<double>(steps);
  distances_ = {0.0};
  Point2 previous = knots_.front();
  for (std::size_t i = 1; i <= steps; ++i) {
    const double parameter = static_cast<double>(i) * table_step_;
    const Point2 position = evaluate(knots_, parameters_, second_derivatives_, parameter).position;
    distances_.push_back(distances_.back() + (position - previous).norm());
    previous = position;
  }
}

double SplinePath::parameter_at(double distance) const noexcept {
  const double wanted = std::clamp(distance, 0.0, length());
  const auto beyond = std::upper_bound(distances_.begin() + 1, distances_.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(beyond - distances_.begin());
  const double gap = distances_[i] - distances_[i - 1];
  const double share = gap > 0.0 ? (wanted - distances_[i - 1]) / gap : 0.0;
  return (static_cast<double>(i - 1) + share) * table_step_;
}

Pose2 SplinePath::at(double distance) const noexcept {
  const CurvePoint here = evaluate(knots_, parameters_, second_derivatives_, parameter_at(distance));
  return {here.position.x(), here.position.y(), wrap_angle(std::atan2(here.derivative.y(), here.derivative.x()))};
}

double SplinePath::curvature(double distance) const noexcept {
  const CurvePoint here = evaluate(knots_, parameters_, second_derivatives_, parameter_at(distance));
  const double speed = here.derivative.norm();
  const double cross =
      here.derivative.x() * here.second_derivative.y() - here.derivative.y() * here.second_derivative.x();
  return speed > 0.0 ? cross / (speed * speed * speed) : 0.0;
}

std::vector<Pose2> SplinePath::sampled(double spacing) const {
  if (!(spacing > 0.0)) throw Error("the spacing must be above 0 m", "SplinePath::sampled", "0.02 m is fine");
  std::vector<Pose2> poses;
  const auto steps = static_cast<std::size_t>(std::ceil(length() / spacing - 1e-9));
  poses.reserve(steps + 1);
  for (std::size_t i = 0; i < steps; ++i) poses.push_back(at(static_cast<double>(i) * spacing));
  poses.push_back(at(length()));
  return poses;
}

PathPlace SplinePath::nearest(const Point2& point, double from, double to) const noexcept {
  // Coarse, then fine around the best: between neighbours of the coarse steps a path has one nearest place.
  constexpr double coarse = 0.05;
  constexpr double finest = 1e-5;
  const double lower = std::clamp(from, 0.0, length());
  const double upper = std::clamp(to, lower, length());
  const auto squared_distance = [&](double distance) { return (at(distance).translation() - point).squaredNorm(); };
  double best = lower;
  double least = squared_distance(lower);
  for (double distance = lower; distance < upper + coarse; distance += coarse)
    if (const double here = squared_distance(std::min(distance, upper)); here < least) {
      best = std::min(distance, upper);
      least = here;
    }
  for (double step = 0.5 * coarse; step > finest; step *= 0.5)
    for (const double beside : {std::max(lower, best - step), std::min(upper, best + step)})
      if (const double here = squared_distance(beside); here < least) {
        best = beside;
        least = here;
      }
  return {best, (at(best).inverse() * point).y()};
}

}  // namespace slamicp
