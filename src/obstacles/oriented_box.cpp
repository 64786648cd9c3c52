// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <slamicp/geometry/angle.hpp>
#include <slamicp/obstacles/oriented_box.hpp>

namespace slamicp {
namespace {

/// Along a direction, then across it.
class Along {
 public:
  explicit Along(const Point2& direction) noexcept : direction_(direction) {}

  bool operator()(const Point2& a, const Point2& b) const noexcept {
    const double difference = direction_.dot(a) - direction_.dot(b);
    return difference < 0.0 || (difference == 0.0 && cross(direction_, a) < cross(direction_, b));
  }

 private:
  Point2 direction_;
};

/// Points of a scan are nearly in order along what they show: insertion takes a few steps for each. Where it would take
/// more, std::sort does it.
void sort_points(PointCloud2& points, const Along& before) {
  constexpr std::size_t few = 8;
  std::size_t steps = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point2 point = points[i];
    std::size_t place = i;
    for (; place > 0 && before(point, points[place - 1]); --place) points[place] = points[place - 1];
    points[place] = point;
    steps += i - place;
    if (steps > few * points.size()) return std::sort(points.begin(), points.end(), before);
  }
}

/// Goes on with one side of a hull, from its last point to `end`.
/// @param points  those between, in order
template <typename Iterator>
void go_round(Iterator point, Iterator stop, const Point2& end, PointCloud2& hull) {
  const std::size_t fixed = hull.size();
  const auto add = [&](const Point2& next) {
    while (hull.size() > fixed && cross(hull.back() - hull[hull.size() - 2], next - hull.back()) <= 0.0)
      hull.pop_back();
    hull.push_back(next);
  };
  for (; point != stop; ++point)
    if (cross(end - hull.back(), *point - hull.back()) < 0.0) add(*point);  // others lie within
  add(end);
}

/// The convex hull, counter-clockwise (Andrew 1979, monotone chain). `points` are finite; they are put in order.
void convex_hull(PointCloud2& points, PointCloud2& hull) {
  hull.clear();
  if (points.empty()) return;
  const Point2 direction = points.back() - points.front();
  sort_points(points, Along(direction.squaredNorm() > 0.0 ? direction : Point2(1.0, 0.0)));
  points.erase(std::unique(points.begin(), points.end()), points.end());
  hull.push_back(points.front());
  if (points.size() == 1) return;
  go_round(points.begin() + 1, points.end() - 1, points.back(), hull);
  if (points.size() == 2) return;
  go_round(points.rbegin() + 1, points.rend() - 1, points.front(), hull);
  hull.pop_back();
}

/// How far the points reach along a direction of length one, and across it.
Bounds<2> extent_along(const PointCloud2& points, const Point2& along) noexcept {
  Bounds<2> extent;
  for (const Point2& point : points) extent.include({along.dot(point), cross(along, point)});
  return extent;
}

/// The same rectangle, its longer side first.
OrientedBox normalized(OrientedBox box) {
  if (box.depth > box.width) {
    std::swap(box.width, box.depth);
    box.heading += std::numbers::pi / 2.0;
  }
  box.heading = wrap_half_turn(box.heading);
  return box;
}

}  // namespace

OrientedBox smallest_box(PointView<2> points) { return BoxFinder().smallest(points); }

void BoxFinder::reserve(std::size_t points) {
  points_.reserve(points);
  hull_.reserve(points + 2);  // it closes before it is done
}

OrientedBox BoxFinder::smallest(PointView<2> points) {
  points_.clear();
  std::copy_if(points.begin(), points.end(), std::back_inserter(points_), is_finite<2>);
  convex_hull(points_, hull_);
  if (hull_.empty()) return {};
  Point2 along(1.0, 0.0);
  Bounds<2> extent;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < hull_.size(); ++k) {
    const Point2 side = hull_[(k + 1) % hull_.size()] - hull_[k];
    const Point2 direction = hull_.size() > 1 ? Point2(side.normalized()) : along;
    const Bounds<2> here = extent_along(hull_, direction);
    const double area = (here.upper - here.lower).prod();
    if (area >= least) continue;
    least = area;
    along = direction;
    extent = here;
  }
  const Point2 middle = 0.5 * (extent.lower + extent.upper);
  const Point2 size = extent.upper - extent.lower;
  const Point2 across(-along.y(), along.x());
  return normalized({along * middle.x() + across * middle.y(), size.x(), size.y(), std::atan2(along.y(), along.x())});
}

OrientedBox trimmed_box(const OrientedBox& box, PointView<2> points, double trim) {
  if (points.empty()) return box;
  const Point2 along(std::cos(box.heading), std::sin(box.heading));
  const Point2 across(-along.y(), along.x());
  const auto extent = [&](const Point2& axis) {
    std::vector<double> places;
    places.reserve(points.size());
    for (const Point2& point : points)
      if (is_finite<2>(point)) places.push_back(axis.dot(point));
    if (places.empty()) return std::pair(0.0, 0.0);
    std::sort(places.begin(), places.end());
    const auto outside = static_cast<std::size_t>(trim * static_cast<double>(places.size()));
    return std::pair(places[outside], places[places.size() - 1 - outside]);
  };
  const auto [back, front] = extent(along);
  const auto [right, left] = extent(across);
  return normalized(
      {0.5 * (back + front) * along + 0.5 * (right + left) * across, front - back, left - right, box.heading});
}

}  // namespace slamicp
