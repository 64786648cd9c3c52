// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/map/ray_checker.hpp>

namespace slamicp {

RayChecker::RayChecker(const IndexedPoints<2>& map, double match_distance, double noise) noexcept
    : points_(map),
      match_distance_(match_distance),
      on_surface_(std::clamp(4.0 * noise, std::min(0.03, 0.5 * match_distance), 0.5 * match_distance)),
      step_(std::min(match_distance, map.cells().cell_options().reach)),
      touch_(std::clamp(0.75 * points_.spacing(), std::min(0.01, 0.5 * match_distance), 0.5 * match_distance)) {}

RayEnd RayChecker::end_of(const Point2& to) const noexcept {
  const Neighbour nearest = points_.nearest(to, match_distance_);
  if (!nearest.found()) return RayEnd::open;
  const Surface2 surface = points_.surface(static_cast<std::size_t>(nearest.index));
  const double off =
      surface.valid() ? std::abs(surface.normal.dot(to - surface.centroid)) : std::sqrt(nearest.squared_distance);
  return off <= on_surface_ ? RayEnd::explained : RayEnd::beside;
}

/// Goes along the ray in leaps as long as nothing is near (Hart 1996, "Sphere tracing").
bool RayChecker::passes_wall(const Point2& from, const Point2& to) const noexcept {
  constexpr int most_leaps = 400;
  const double length = (to - from).norm();
  const Vector<2> along = (to - from) / length;
  double at = 0.0;
  for (int leap = 0; leap < most_leaps && at < length - match_distance_; ++leap) {
    const Neighbour nearest = points_.nearest(from + at * along, match_distance_);
    if (!nearest.found()) {
      at += match_distance_;
      continue;
    }
    const double room = std::sqrt(nearest.squared_distance);
    if (room < touch_ && parts(nearest.index, from, to)) return true;
    at += std::max(room, touch_);
  }
  return false;
}

WallMet RayChecker::first_wall(const Point2& from, const Vector<2>& direction, double start,
                               double reach) const noexcept {
  constexpr int most_leaps = 1000;
  double at = start;
  for (int leap = 0; leap < most_leaps && at < reach; ++leap) {
    const Neighbour nearest = points_.nearest(from + at * direction, step_);
    if (!nearest.found()) {
      at += step_;
      continue;
    }
    const double room = std::sqrt(nearest.squared_distance);
    if (room < touch_) return wall_at(nearest.index, from, direction, at);
    at += room;
  }
  return {};
}

/// The wall that a map point is of, which the ray has come near to.
WallMet RayChecker::wall_at(int wall, const Point2& from, const Vector<2>& direction, double at) const noexcept {
  const Surface2 surface = points_.surface(static_cast<std::size_t>(wall));
  if (!surface.valid()) return {true, at, 0.0};
  const double steepness = std::abs(surface.normal.dot(direction));
  const double left = surface.normal.dot(surface.centroid - from - at * direction);
  const double along = steepness > 0.0 ? left / surface.normal.dot(direction) : 0.0;
  // A ray that runs beside a wall meets it where it came near.
  const double most = 2.0 * touch_ / std::max(steepness, 0.1);
  return {true, at + std::clamp(along, -most, most), steepness};
}

/// True if the wall that a map point is of stands between both places, and not just beside one of them.
bool RayChecker::parts(int wall, const Point2& from, const Point2& to) const noexcept {
  const Surface2 surface = points_.surface(static_cast<std::size_t>(wall));
  if (!surface.valid()) return false;
  const double before = surface.normal.dot(from - surface.centroid);
  const double behind = surface.normal.dot(to - surface.centroid);
  return before * behind < 0.0 && std::min(std::abs(before), std::abs(behind)) > 0.5 * match_distance_;
}

}  // namespace slamicp
