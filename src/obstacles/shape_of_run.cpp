// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <slamicp/geometry/angle.hpp>
#include <slamicp/obstacles/shape.hpp>

#include "obstacles/round_thing.hpp"

namespace slamicp {
namespace {

constexpr double right_angle = std::numbers::pi / 2.0;
constexpr double trimmed_share = 0.01;  // share of a side's points beyond each of its ends
constexpr double flattest_look = 0.15;  // cosine: what is seen flatter shows no side
constexpr std::size_t enough_points = 3000;

/// Points in the axes of a box, and the directions they were seen along.
struct InBox {
  PointCloud2 points;
  PointCloud2 rays;  // unit length, from the laser
};

InBox turned(PointView<2> points, PointView<2> lasers, double heading) {
  Matrix<2, 2> turn;
  turn << std::cos(heading), std::sin(heading), -std::sin(heading), std::cos(heading);
  InBox in;
  in.points.reserve(points.size());
  in.rays.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    in.points.push_back(turn * points[i]);
    in.rays.push_back(turn * (points[i] - lasers[i]).normalized());
  }
  return in;
}

/// The values between which all lie but `trimmed_share` at either end, widened as if they were spread evenly.
std::array<double, 2> reach_of(std::vector<double>& values) {
  if (values.empty()) return {0.0, 0.0};
  std::sort(values.begin(), values.end());
  const auto outside = static_cast<std::size_t>(trimmed_share * static_cast<double>(values.size()));
  const double low = values[outside], high = values[values.size() - 1 - outside];
  const double more = trimmed_share * (high - low);
  return {low - more, high + more};
}

/// A box along the axes: left, right, bottom, top.
struct Sides {
  std::array<double, 4> at{};
  std::array<std::size_t, 4> points{};  // on each

  static int axis_of(std::size_t side) noexcept { return side < 2 ? 0 : 1; }
  static double outward(std::size_t side) noexcept { return side % 2 == 0 ? -1.0 : 1.0; }

  /// The side that a point seen along a ray is of: the nearest of those that face the laser. 4: none does.
  std::size_t side_of(const Point2& point, const Vector<2>& ray) const noexcept {
    std::size_t best = 4;
    double least = 1e300;
    for (std::size_t side = 0; side < 4; ++side) {
      if (ray[axis_of(side)] * outward(side) >= -flattest_look) continue;
      const double off = std::abs(point[axis_of(side)] - at[side]);
      if (off >= least) continue;
      least = off;
      best = side;
    }
    return best;
  }
  double off(const Point2& point, std::size_t side) const noexcept { return point[axis_of(side)] - at[side]; }
};

Sides sides_around(const InBox& in) {
  Sides sides;
  std::vector<double> values(in.points.size());
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = in.points[i][static_cast<Eigen::Index>(axis)];
    const auto [low, high] = reach_of(values);
    sides.at[2 * axis] = low;
    sides.at[2 * axis + 1] = high;
  }
  return sides;
}

/// How badly a heading fits: squared distances from the sides, none more than three sigma.
double cost_of(const InBox& in, double noise) {
  const Sides sides = sides_around(in);
  double cost = 0.0;
  for (std::size_t i = 0; i < in.points.size(); ++i) {
    const std::size_t side = sides.side_of(in.points[i], in.rays[i]);
    const double off = side < 4 ? sides.off(in.points[i], side) : 3.0 * noise;
    cost += std::min(off * off, 9.0 * noise * noise);
  }
  return cost;
}

double best_heading(PointView<2> points, PointView<2> lasers, double noise) {
  double best = 0.0;
  double least = 1e300;
  const auto look = [&](double heading) {
    const double cost = cost_of(turned(points, lasers, heading), noise);
    if (cost >= least) return;
    least = cost;
    best = heading;
  };
  constexpr int coarse = 45;
  for (int k = 0; k < coarse; ++k) look(right_angle * k / coarse);
  for (double step = 0.5 * right_angle / coarse; step > 1e-3; step *= 0.5) {
    const double middle = best;
    look(middle - step);
    look(middle + step);
  }
  return best;
}

/// Sides where their points are in the middle; where a side was not seen, at the ends of those beside it.
Sides fitted_sides(const InBox& in, double noise) {
  Sides sides = sides_around(in);
  std::array<std::vector<double>, 4> across, along;
  for (int round = 0; round < 6; ++round) {
    for (std::size_t side = 0; side < 4; ++side) {
      across[side].clear();
      along[side].clear();
    }
    for (std::size_t i = 0; i < in.points.size(); ++i) {
      const std::size_t side = sides.side_of(in.points[i], in.rays[i]);
      if (side == 4 || std::abs(sides.off(in.points[i], side)) > 5.0 * noise) continue;
      across[side].push_back(in.points[i][Sides::axis_of(side)]);
      along[side].push_back(in.points[i][1 - Sides::axis_of(side)]);
    }
    for (std::size_t side = 0; side < 4; ++side) {
      sides.points[side] = across[side].size();
      const std::size_t least = std::max<std::size_t>(10, in.points.size() / 50);
      if (across[side].size() >= least) {
        auto middle = across[side].begin() + static_cast<std::ptrdiff_t>(across[side].size() / 2);
        std::nth_element(across[side].begin(), middle, across[side].end());
        sides.at[side] = *middle;
        continue;
      }
      // Both sides beside it end where it would be.
      const std::size_t beside = side < 2 ? 2 : 0;
      std::vector<double> ends = along[beside];
      ends.insert(ends.end(), along[beside + 1].begin(), along[beside + 1].end());
      if (ends.size() >= least) sides.at[side] = reach_of(ends)[side % 2];
      sides.points[side] = 0;
    }
  }
  return sides;
}

/// Root mean square of errors along the rays, none more than four sigma.
class MeanMisfit {
 public:
  explicit MeanMisfit(double noise) noexcept : most_(4.0 * noise) {}
  void add(double error, double cosine) noexcept {
    const double along = std::min(std::abs(error) / std::max(std::abs(cosine), RoundThing::flattest), most_);
    sum_ += along * along;
    ++count_;
  }
  double value() const noexcept { return count_ > 0 ? std::sqrt(sum_ / count_) : most_; }

 private:
  double most_;
  double sum_ = 0.0;
  int count_ = 0;
};

Shape box_of(PointView<2> points, PointView<2> lasers, double noise) {
  const double heading = best_heading(points, lasers, noise);
  const InBox in = turned(points, lasers, heading);
  const Sides sides = fitted_sides(in, noise);
  MeanMisfit misfit(noise);
  for (std::size_t i = 0; i < in.points.size(); ++i) {
    const std::size_t side = sides.side_of(in.points[i], in.rays[i]);
    if (side == 4) continue;
    misfit.add(sides.off(in.points[i], side), in.rays[i][Sides::axis_of(side)]);
  }
  const auto seen = [&](std::size_t side) { return sides.points[side] > 0; };
  Shape shape;
  shape.noise = misfit.value();
  shape.kind = (seen(0) || seen(1)) && (seen(2) || seen(3)) ? ShapeKind::box : ShapeKind::line;
  Point2 middle(0.5 * (sides.at[0] + sides.at[1]), 0.5 * (sides.at[2] + sides.at[3]));
  // Of a line only the side that was seen.
  for (std::size_t side = 0; side < 4 && shape.kind == ShapeKind::line; ++side)
    if (seen(side)) middle[Sides::axis_of(side)] = sides.at[side];
  const Vector<2> along(std::cos(heading), std::sin(heading));
  const Vector<2> aside(-along.y(), along.x());
  shape.centre = middle.x() * along + middle.y() * aside;
  shape.width = std::abs(sides.at[1] - sides.at[0]);
  shape.depth = std::abs(sides.at[3] - sides.at[2]);
  // A side's length was seen where points lie on the side, or on both ends of it.
  shape.width_seen = seen(2) || seen(3) || (seen(0) && seen(1));
  shape.depth_seen = seen(0) || seen(1) || (seen(2) && seen(3));
  shape.heading = heading;
  if (shape.depth > shape.width) {
    std::swap(shape.width, shape.depth);
    std::swap(shape.width_seen, shape.depth_seen);
    shape.heading += right_angle;
  }
  shape.heading = wrap_half_turn(shape.heading);
  if (shape.kind == ShapeKind::line) shape.depth = 0.0;
  const double ends = 0.5 * noise;  // what the trimmed ends of sides are unsure by
  shape.width_sigma = shape.depth_sigma = ends;
  shape.heading_sigma = noise / std::max(shape.width, noise) / std::sqrt(static_cast<double>(points.size()));
  shape.covariance = 0.25 * ends * ends * Matrix<2, 2>::Identity();
  return shape;
}

Shape round_shape(const RoundThing& thing, PointView<2> points, PointView<2> lasers, double noise) {
  constexpr std::size_t parts = 72;
  std::array<bool, parts> covered{};
  MeanMisfit misfit(noise);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector<2> off = points[i] - thing.centre;
    const double distance = off.norm();
    misfit.add(distance - thing.radius, off.dot(points[i] - lasers[i]) / (distance * (points[i] - lasers[i]).norm()));
    const double turns = std::atan2(off.y(), off.x()) / (2.0 * std::numbers::pi) + 0.5;
    covered[std::min(static_cast<std::size_t>(turns * parts), parts - 1)] = true;
  }
  Shape shape;
  shape.kind = ShapeKind::circle;
  shape.noise = misfit.value();
  shape.centre = thing.centre;
  shape.radius = thing.radius;
  shape.radius_sigma = std::sqrt(std::max(thing.covariance(2, 2), 0.0));
  shape.covariance = thing.covariance.topLeftCorner<2, 2>();
  shape.arc = 2.0 * std::numbers::pi / parts * static_cast<double>(std::count(covered.begin(), covered.end(), true));
  shape.width = shape.depth = 2.0 * thing.radius;
  shape.width_sigma = shape.depth_sigma = 2.0 * shape.radius_sigma;
  shape.width_seen = shape.depth_seen = true;
  return shape;
}

/// Some of them, evenly, where there are many.
PointCloud2 enough_of(PointView<2> all) {
  const std::size_t step = std::max<std::size_t>(1, all.size() / enough_points);
  PointCloud2 some;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

}  // namespace

Shape shape_of_run(PointView<2> all_points, PointView<2> all_lasers, double noise) {
  constexpr std::size_t least = 20;
  if (all_points.size() < least || all_points.size() != all_lasers.size()) return {};
  const PointCloud2 points = enough_of(all_points);
  const PointCloud2 lasers = enough_of(all_lasers);
  Shape best = box_of(points, lasers, noise);
  if (const auto thing = fit_round(points, lasers, noise)) {
    const Shape shape = round_shape(*thing, points, lasers, noise);
    // Fewer numbers that say as much say more.
    if (shape.arc >= RoundThing::least_arc && shape.noise < 1.05 * best.noise) best = shape;
  }
  if (best.noise > 3.0 * noise) best.kind = ShapeKind::unknown;
  return best;
}

}  // namespace slamicp
