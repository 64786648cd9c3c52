// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <slamicp/obstacles/oriented_box.hpp>

namespace slamicp {
namespace {

double cross(const Point2& a, const Point2& b) noexcept { return a.x() * b.y() - a.y() * b.x(); }

/// The convex hull, counter-clockwise (Andrew 1979, monotone chain).
PointCloud2 convex_hull(PointView<2> points) {
  PointCloud2 sorted;
  std::copy_if(points.begin(), points.end(), std::back_inserter(sorted), is_finite<2>);
  std::sort(sorted.begin(), sorted.end(),
            [](const Point2& a, const Point2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;

  PointCloud2 hull;
  const auto grow = [&hull](const Point2& point, std::size_t fixed) {
    while (hull.size() > fixed + 1 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const Point2& point : sorted) grow(point, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto point = sorted.rbegin() + 1; point != sorted.rend(); ++point) grow(*point, lower);
  hull.pop_back();
  return hull;
}

OrientedBox box_along(const PointCloud2& hull, double heading) {
  const Point2 along(std::cos(heading), std::sin(heading));
  const Point2 across(-along.y(), along.x());
  Bounds<2> extent;
  for (const Point2& point : hull) extent.include({along.dot(point), across.dot(point)});
  const Point2 middle = 0.5 * (extent.lower + extent.upper);
  const Point2 size = extent.upper - extent.lower;
  return {along * middle.x() + across * middle.y(), size.x(), size.y(), heading};
}

/// The same rectangle, its longer side first.
OrientedBox normalized(OrientedBox box) {
  constexpr double pi = std::numbers::pi;
  if (box.depth > box.width) {
    std::swap(box.width, box.depth);
    box.heading += pi / 2.0;
  }
  box.heading = std::remainder(box.heading, pi);
  if (box.heading <= -pi / 2.0) box.heading += pi;
  return box;
}

}  // namespace

OrientedBox smallest_box(PointView<2> points) {
  const PointCloud2 hull = convex_hull(points);
  if (hull.empty()) return {};
  OrientedBox best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Point2 side = hull[(k + 1) % hull.size()] - hull[k];
    const OrientedBox box = box_along(hull, std::atan2(side.y(), side.x()));
    const double area = box.width * box.depth;
    if (area < least) {
      least = area;
      best = box;
    }
  }
  return normalized(best);
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
