// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <slamicp/geometry/angle.hpp>
#include <slamicp/obstacles/shape.hpp>

#include "obstacles/round_thing.hpp"

namespace slamicp {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double flattest = RoundThing::flattest;
constexpr double unseen_sigma = 0.1;  // of an end that something hides [m]
constexpr double most_error = 9.0;    // mean squared error of a shape, in variances of the noise
constexpr std::size_t least_for_line = 4;
constexpr std::size_t least_for_bend = 6;
constexpr std::size_t least_of_side = 3;
constexpr std::size_t enough_for_circle = 24;

Vector<2> left_of(const Vector<2>& direction) noexcept { return {-direction.y(), direction.x()}; }

struct StraightLine {
  Point2 middle;
  Vector<2> along;  // unit length
  Vector<2> normal() const noexcept { return left_of(along); }
};

/// How unlikely points make a shape: squared errors along their rays, in variances of the noise.
class Misfit {
 public:
  explicit Misfit(const ViewOfThing& view) noexcept : view_(view) {}

  /// @param error   of a point from the outline, across it
  /// @param normal  of the outline there
  void add(const Point2& point, double error, const Vector<2>& normal) noexcept {
    const Vector<2> ray = point - view_.laser;
    const double head_on = ray.dot(normal);
    const double cosine2 = std::max(head_on * head_on / ray.squaredNorm(), flattest * flattest);
    sum_ += error * error / cosine2;
    squares_ += error * error;
  }
  double sum() const noexcept { return sum_ / (view_.range_noise * view_.range_noise); }
  double mean_error() const noexcept { return std::sqrt(squares_ / static_cast<double>(view_.points.size())); }
  /// The Bayesian information criterion.
  double criterion(int parameters) const noexcept {
    return sum() + parameters * std::log(static_cast<double>(view_.points.size()));
  }

 private:
  const ViewOfThing& view_;
  double sum_ = 0.0;
  double squares_ = 0.0;
};

/// How little points scatter in the direction in which they scatter least, squared and summed.
double least_scatter(double xx, double xy, double yy) noexcept {
  const double difference = 0.5 * (xx - yy);
  return std::max(0.5 * (xx + yy) - std::sqrt(difference * difference + xy * xy), 0.0);
}

/// That direction.
Vector<2> least_direction(double xx, double xy, double yy) noexcept {
  const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);  // of the largest
  return {-std::sin(turn), std::cos(turn)};
}

/// Where the ray through a point, turned by an angle, meets a line.
Point2 on_line(const ViewOfThing& view, const StraightLine& line, const Point2& point, double turn) noexcept {
  const Vector<2> to_point = point - view.laser;
  const Vector<2> ray(std::cos(turn) * to_point.x() - std::sin(turn) * to_point.y(),
                      std::sin(turn) * to_point.x() + std::cos(turn) * to_point.y());
  const double steepness = line.normal().dot(ray);
  const double share = line.normal().dot(line.middle - view.laser) / steepness;
  const bool is_flat = std::abs(steepness) < 0.1 * ray.norm();
  // Along a flat ray the place is as unsure as the range, and more.
  if (is_flat || !(share > 0.0)) return line.middle + line.along.dot(point - line.middle) * line.along;
  return view.laser + share * ray;
}

/// The end of a side.
struct End {
  Point2 place;
  double sigma;  // along the side [m]
};

/// @param away  the sense in which the rays turn when they leave the thing, +1 or -1
End end_of_side(const ViewOfThing& view, const StraightLine& side, const Point2& last, bool is_seen,
                double away) noexcept {
  if (!is_seen) return {on_line(view, side, last, 0.0), unseen_sigma};
  const Point2 met = on_line(view, side, last, 0.0);
  const Point2 missed = on_line(view, side, last, away * view.beam_spacing);
  const double most = 0.1;  // [m]: a side that is seen so flat has no end to speak of
  Vector<2> beyond = missed - met;
  if (beyond.norm() > most) beyond *= most / beyond.norm();
  return {met + 0.5 * beyond, std::max(beyond.norm() / std::sqrt(12.0), 1e-3)};
}

/// In which sense the rays turn from the first point to the last: +1 counter-clockwise.
double sense_of(const ViewOfThing& view) noexcept {
  return cross(view.points.front() - view.laser, view.points.back() - view.laser) < 0.0 ? -1.0 : 1.0;
}

/// Along one axis and across it, by their variances.
Matrix<2, 2> covariance_along(const Vector<2>& axis, double along, double across) noexcept {
  const Vector<2> other = left_of(axis);
  return along * axis * axis.transpose() + across * other * other.transpose();
}

/// What lies across a side is known by the mean of its points.
double offset_variance(const ViewOfThing& view, const StraightLine& side, double points) noexcept {
  const double cosine = std::abs((side.middle - view.laser).normalized().dot(side.normal()));
  const double noise = view.range_noise * std::max(cosine, flattest);
  return noise * noise / std::max(points, 1.0);
}

void tell_line(const ViewOfThing& view, const StraightLine& line, Shape& shape) noexcept {
  const double sense = sense_of(view);
  const End first = end_of_side(view, line, view.points.front(), view.first_end_seen, -sense);
  const End last = end_of_side(view, line, view.points.back(), view.last_end_seen, sense);
  const double count = static_cast<double>(view.points.size());
  const double offset = offset_variance(view, line, count);
  shape.kind = ShapeKind::line;
  shape.depth = shape.depth_sigma = 0.0;
  shape.width = (last.place - first.place).norm();
  shape.width_sigma = std::hypot(first.sigma, last.sigma);
  shape.width_seen = view.first_end_seen && view.last_end_seen;
  shape.heading = wrap_half_turn(std::atan2(line.along.y(), line.along.x()));
  shape.heading_sigma = std::sqrt(12.0 * offset) / std::max(shape.width, 1e-3);
  shape.centre = 0.5 * (first.place + last.place);
  shape.covariance = covariance_along(line.along, 0.25 * shape.width_sigma * shape.width_sigma, offset);
}

/// How much of the circle the points cover, in beam order [rad].
double arc_of(const ViewOfThing& view, const RoundThing& circle) noexcept {
  const Vector<2> first = view.points.front() - circle.centre;
  const Vector<2> last = view.points.back() - circle.centre;
  return std::abs(std::atan2(cross(first, last), first.dot(last)));
}

void tell_circle(const ViewOfThing& view, const RoundThing& circle, double arc, Shape& shape) noexcept {
  shape.kind = ShapeKind::circle;
  shape.centre = circle.centre;
  shape.covariance = circle.covariance.topLeftCorner<2, 2>();
  shape.radius = circle.radius;
  shape.radius_sigma = std::sqrt(std::max(circle.covariance(2, 2), 0.0));
  shape.arc = arc;
  shape.width = shape.depth = 2.0 * circle.radius;
  shape.width_sigma = shape.depth_sigma = 2.0 * shape.radius_sigma;
  shape.width_seen = shape.depth_seen = view.first_end_seen && view.last_end_seen;
  shape.heading = shape.heading_sigma = 0.0;
}

/// Two sides at a right angle.
struct CornerThing {
  StraightLine first, second;
  std::size_t split;  // the first point of the second side
  Point2 corner;
};

void tell_box(const ViewOfThing& view, const CornerThing& found, Shape& shape) noexcept {
  const double sense = sense_of(view);
  const End first = end_of_side(view, found.first, view.points.front(), view.first_end_seen, -sense);
  const End last = end_of_side(view, found.second, view.points.back(), view.last_end_seen, sense);
  const double first_offset = offset_variance(view, found.first, static_cast<double>(found.split));
  const double second_offset =
      offset_variance(view, found.second, static_cast<double>(view.points.size() - found.split));
  const Vector<2> one = first.place - found.corner;
  const Vector<2> other = last.place - found.corner;
  shape.kind = ShapeKind::box;
  shape.centre = found.corner + 0.5 * (one + other);
  shape.width = one.norm();
  shape.depth = other.norm();
  shape.width_sigma = std::sqrt(first.sigma * first.sigma + second_offset);
  shape.depth_sigma = std::sqrt(last.sigma * last.sigma + first_offset);
  shape.width_seen = view.first_end_seen;
  shape.depth_seen = view.last_end_seen;
  shape.covariance = covariance_along(found.first.along, 0.25 * first.sigma * first.sigma + second_offset,
                                      0.25 * last.sigma * last.sigma + first_offset);
  double heading = std::atan2(found.first.along.y(), found.first.along.x());
  shape.heading_sigma = std::sqrt(12.0 * first_offset) / std::max(shape.width, 1e-3);
  if (shape.depth > shape.width) {
    std::swap(shape.width, shape.depth);
    std::swap(shape.width_sigma, shape.depth_sigma);
    std::swap(shape.width_seen, shape.depth_seen);
    shape.heading_sigma = std::sqrt(12.0 * second_offset) / std::max(shape.width, 1e-3);
    heading += half_turn / 2.0;
  }
  shape.heading = wrap_half_turn(heading);
}

/// What can be said of points without a shape: how far they reach.
void tell_extent(const ViewOfThing& view, const StraightLine& along, Shape& shape) noexcept {
  Bounds<2> extent;
  for (const Point2& point : view.points)
    extent.include({along.along.dot(point - along.middle), along.normal().dot(point - along.middle)});
  const Point2 middle = 0.5 * (extent.lower + extent.upper);
  const Vector<2> size = extent.upper - extent.lower;
  shape.centre = along.middle + middle.x() * along.along + middle.y() * along.normal();
  shape.width = size.x();
  shape.depth = size.y();
  shape.width_sigma = shape.depth_sigma = unseen_sigma;
  const double noise2 = view.range_noise * view.range_noise;
  shape.covariance =
      covariance_along(along.along, size.x() * size.x() / 12.0 + noise2, size.y() * size.y() / 12.0 + noise2);
  shape.heading = wrap_half_turn(std::atan2(along.along.y(), along.along.x()));
  shape.heading_sigma = half_turn / 4.0;
}

/// The shapes of a view, the likeliest so far kept.
class Choice {
 public:
  explicit Choice(const ViewOfThing& view, Shape& shape) noexcept
      : view_(view),
        shape_(shape),
        most_(most_error * static_cast<double>(view.points.size())),
        best_(std::numeric_limits<double>::infinity()) {}

  /// @returns the line's misfit
  double try_line(const StraightLine& line) noexcept {
    Misfit misfit(view_);
    const Vector<2> normal = line.normal();
    for (const Point2& point : view_.points) misfit.add(point, normal.dot(point - line.middle), normal);
    if (is_best(misfit, 2)) tell_line(view_, line, shape_);
    return misfit.sum();
  }

  void try_circle() noexcept {
    // Some of many points tell whether it is a circle; all of them then say which.
    const std::size_t stride = std::max<std::size_t>(1, view_.points.size() / enough_for_circle);
    const std::optional<RoundThing> some =
        fit_round(view_.points, {&view_.laser, 1}, view_.range_noise, {stride, nullptr, std::min(most_, best_)});
    if (!some || arc_of(view_, *some) < RoundThing::least_arc || !is_best(misfit_of(*some), 3)) return;
    tell_circle(view_, *some, arc_of(view_, *some), shape_);
  }

  /// The last word on what was chosen.
  void finish() noexcept {
    if (shape_.kind != ShapeKind::circle || view_.points.size() < 2 * enough_for_circle) return;
    const RoundThing start{shape_.centre, shape_.radius, Matrix<3, 3>::Zero()};
    if (const auto all = fit_round(view_.points, {&view_.laser, 1}, view_.range_noise, {1, &start}))
      tell_circle(view_, *all, arc_of(view_, *all), shape_);
  }

  void try_corner(const CornerThing& found, const Point2& mean) noexcept {
    const bool points_to_laser = (found.corner - mean).dot(view_.laser - mean) > 0.0;
    if (!points_to_laser) return;
    Misfit misfit(view_);
    for (std::size_t k = 0; k < view_.points.size(); ++k) {
      const StraightLine& side = k < found.split ? found.first : found.second;
      const Vector<2> normal = side.normal();
      misfit.add(view_.points[k], normal.dot(view_.points[k] - side.middle), normal);
    }
    if (!is_best(misfit, 5)) return;
    shape_.radius = shape_.radius_sigma = shape_.arc = 0.0;
    tell_box(view_, found, shape_);
  }

 private:
  Misfit misfit_of(const RoundThing& circle) const noexcept {
    Misfit misfit(view_);
    for (const Point2& point : view_.points) {
      const Vector<2> off = point - circle.centre;
      const double distance = std::max(off.norm(), 1e-9);
      misfit.add(point, distance - circle.radius, off / distance);
    }
    return misfit;
  }

  bool is_best(const Misfit& misfit, int parameters) noexcept {
    const double criterion = misfit.criterion(parameters);
    if (misfit.sum() > most_ || criterion >= best_) return false;
    best_ = criterion;
    shape_.noise = misfit.mean_error();
    return true;
  }

  const ViewOfThing& view_;
  Shape& shape_;
  double most_;
  double best_;
};

}  // namespace

void ShapeFinder::reserve(std::size_t points) { until_.reserve(points + 1); }

/// Sums over the points before each, about the first, so that products stay small.
void ShapeFinder::sum_up(PointView<2> points) {
  about_ = points.front();
  until_.resize(points.size() + 1);
  until_[0] = {};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vector<2> off = points[k] - about_;
    const Moments& before = until_[k];
    until_[k + 1] = {before.count + 1.0, before.sum + off, before.xx + off.x() * off.x(), before.xy + off.x() * off.y(),
                     before.yy + off.y() * off.y()};
  }
}

/// Of points `from` to `to`, about their mean.
ShapeFinder::Spread ShapeFinder::spread(std::size_t from, std::size_t to) const noexcept {
  const Moments& a = until_[from];
  const Moments& b = until_[to];
  const double one = 1.0 / (b.count - a.count);
  const Vector<2> sum = b.sum - a.sum;
  return {b.xx - a.xx - sum.x() * sum.x() * one, b.xy - a.xy - sum.x() * sum.y() * one,
          b.yy - a.yy - sum.y() * sum.y() * one, about_ + one * sum};
}

Shape ShapeFinder::find(const ViewOfThing& view) {
  const std::size_t count = view.points.size();
  Shape shape;
  if (count == 0) return shape;
  sum_up(view.points);
  const Spread all = spread(0, count);
  const Vector<2> across = least_direction(all.xx, all.xy, all.yy);
  const StraightLine line{all.mean, {across.y(), -across.x()}};
  tell_extent(view, line, shape);
  if (count < least_for_line) return shape;
  Choice choice(view, shape);
  // A line that is off by no more than the noise leaves nothing for bent shapes to explain.
  if (choice.try_line(line) < static_cast<double>(count) || count < least_for_bend) return shape;
  choice.try_circle();

  // The second side turned by a right angle scatters as the first.
  double least = std::numeric_limits<double>::infinity();
  std::size_t split = 0;
  for (std::size_t k = least_of_side; k + least_of_side <= count; ++k) {
    const Spread a = spread(0, k);
    const Spread b = spread(k, count);
    const double scatter = least_scatter(a.xx + b.yy, a.xy - b.xy, a.yy + b.xx);
    if (scatter >= least) continue;
    least = scatter;
    split = k;
  }
  const Spread a = spread(0, split);
  const Spread b = spread(split, count);
  const Vector<2> normal = least_direction(a.xx + b.yy, a.xy - b.xy, a.yy + b.xx);
  const StraightLine first{a.mean, {normal.y(), -normal.x()}};
  const StraightLine second{b.mean, normal};
  choice.try_corner({first, second, split, first.middle + first.along.dot(b.mean - a.mean) * first.along}, all.mean);
  choice.finish();
  return shape;
}

}  // namespace slamicp
