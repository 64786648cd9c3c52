// SPDX-License-Identifier: Apache-2.0
#include "simulation/clearance.hpp"

#include <algorithm>

namespace slamicp {
namespace {

double side_of_line(const Segment& line, const Point2& point) noexcept {
  return cross(line.b - line.a, point - line.a);
}

bool do_cross(const Segment& one, const Segment& other) noexcept {
  return side_of_line(one, other.a) * side_of_line(one, other.b) < 0.0 &&
         side_of_line(other, one.a) * side_of_line(other, one.b) < 0.0;
}

/// 0 where they cross; else one of the four ends is nearest to the other line.
double distance_between(const Segment& one, const Segment& other) noexcept {
  if (do_cross(one, other)) return 0.0;
  return std::min({distance(one, other.a), distance(one, other.b), distance(other, one.a), distance(other, one.b)});
}

}  // namespace

Clearance::Clearance(const World& world) : edges_(world.walls), rounds_(world.pillars) {
  const auto add_box = [this](const Box& box) {
    for (const Segment& side : sides(box)) edges_.push_back(side);
  };
  for (const Door& door : world.doors) add_box(leaf(door, door.opening));
  for (const PlacedObstacle& obstacle : world.obstacles) {
    for (const Box& box : obstacle.boxes) add_box(box);
    for (const Cylinder& cylinder : obstacle.cylinders) rounds_.push_back({cylinder.centre, cylinder.radius});
  }
}

bool Clearance::is_clear(const Point2& a, const Point2& b, double margin) const noexcept {
  const Segment way{a, b};
  return std::none_of(edges_.begin(), edges_.end(),
                      [&](const Segment& edge) { return distance_between(way, edge) < margin; }) &&
         std::none_of(rounds_.begin(), rounds_.end(),
                      [&](const Circle& round) { return distance(way, round.centre) < round.radius + margin; });
}

}  // namespace slamicp
