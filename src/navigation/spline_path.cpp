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

}  // namespace

/// A point of the curve, and its derivatives by the chord length.
struct SplinePath::CurvePoint {
  Point2 position;
  Point2 derivative;
  Point2 second_derivative;

  static CurvePoint of(const PointCloud2& knots, const std::vector<double>& parameters, const PointCloud2& second,
                       double parameter) noexcept;

  double curvature() const noexcept {
    const double speed = derivative.norm();
    return speed > 0.0 ? cross(derivative, second_derivative) / (speed * speed * speed) : 0.0;
  }
};

SplinePath::CurvePoint SplinePath::CurvePoint::of(const PointCloud2& knots, const std::vector<double>& parameters,
                                                  const PointCloud2& second, double parameter) noexcept {
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
    const Point2 position = CurvePoint::of(knots_, parameters_, second_derivatives_, parameter).position;
    distances_.push_back(distances_.back() + (position - previous).norm());
    previous = position;
  }
  for (std::size_t k = 0; static_cast<double>(k) * place_spacing < length(); ++k)
    places_.push_back(curve_at(static_cast<double>(k) * place_spacing).position);
  places_.push_back(knots_.back());
}

SplinePath::CurvePoint SplinePath::curve_at(double distance) const noexcept {
  const double wanted = std::clamp(distance, 0.0, length());
  const auto beyond = std::upper_bound(distances_.begin() + 1, distances_.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(beyond - distances_.begin());
  const double gap = distances_[i] - distances_[i - 1];
  const double share = gap > 0.0 ? (wanted - distances_[i - 1]) / gap : 0.0;
  const double parameter = (static_cast<double>(i - 1) + share) * table_step_;
  return CurvePoint::of(knots_, parameters_, second_derivatives_, parameter);
}

Pose2 SplinePath::at(double distance) const noexcept {
  const CurvePoint here = curve_at(distance);
  return {here.position.x(), here.position.y(), wrap_angle(std::atan2(here.derivative.y(), here.derivative.x()))};
}

double SplinePath::curvature(double distance) const noexcept { return curve_at(distance).curvature(); }

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
  const double lower = std::clamp(from, 0.0, length());
  const double upper = std::clamp(to, lower, length());
  // Coarse, by the places; then Newton's steps around the best.
  const auto last = std::min(static_cast<std::size_t>(std::ceil(upper / place_spacing)), places_.size() - 1);
  auto best = std::min(static_cast<std::size_t>(lower / place_spacing), last);
  for (std::size_t k = best + 1; k <= last; ++k)
    if ((places_[k] - point).squaredNorm() < (places_[best] - point).squaredNorm()) best = k;
  constexpr int most_steps = 12;
  constexpr double finest = 1e-7;          // [m]
  constexpr double least_curvature = 0.5;  // of the squared distance, halved: near a curve's centre steps stay short
  const double coarse = static_cast<double>(best) * place_spacing;
  const double first = std::max(lower, coarse - place_spacing);
  const double end = std::max(first, std::min(upper, coarse + place_spacing));
  double distance = std::clamp(coarse, first, end);
  CurvePoint here = curve_at(distance);
  for (int step = 0; step < most_steps; ++step) {
    const Point2 along = here.derivative.normalized();
    const Point2 off = point - here.position;
    const double curvature = std::max(1.0 - here.curvature() * cross(along, off), least_curvature);
    const double next = std::clamp(distance + along.dot(off) / curvature, first, end);
    const bool there = std::abs(next - distance) < finest;
    distance = next;
    here = curve_at(distance);
    if (there) break;
  }
  return {distance, cross(here.derivative.normalized(), point - here.position)};
}

}  // namespace slamicp
