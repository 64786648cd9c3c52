// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {
namespace {

constexpr double nothing_near = std::numeric_limits<double>::infinity();

double distance_to_round(const Point2& centre, double radius, const Point2& point) noexcept {
  return std::max(0.0, (point - centre).norm() - radius);
}

}  // namespace

World with_obstacle(World world, PlacedObstacle obstacle) {
  world.obstacles.push_back(std::move(obstacle));
  return world;
}

World with_box(World world, const Box& box) { return with_obstacle(std::move(world), {"box", {box}, {}}); }

World with_cylinder(World world, const Cylinder& cylinder) {
  return with_obstacle(std::move(world), {"cylinder", {}, {cylinder}});
}

const Route& route(const World& world, std::string_view name) {
  std::string known;
  for (const Route& candidate : world.routes) {
    if (candidate.name == name) return candidate;
    known += (known.empty() ? "" : ", ") + candidate.name;
  }
  throw Error("there is no route '" + std::string(name) + "'", "world '" + world.name + "'",
              known.empty() ? "this world has no routes: give waypoints" : "use one of: " + known);
}

Box leaf(const Door& door, double opening) noexcept {
  const Point2 closed = door.latch - door.hinge;
  const Pose2 T_map_leaf{door.hinge.x(), door.hinge.y(), wrap_angle(std::atan2(closed.y(), closed.x()) + opening)};
  const double width = closed.norm();
  return {T_map_leaf * Point2(0.5 * width, 0.0), width, door.thickness, T_map_leaf.theta};
}

std::array<Segment, 4> sides(const Box& box) noexcept {
  const Pose2 T_map_box{box.centre.x(), box.centre.y(), box.heading};
  const double x = box.width / 2.0;
  const double y = box.depth / 2.0;
  const std::array<Point2, 4> corner = {T_map_box * Point2(-x, -y), T_map_box * Point2(x, -y), T_map_box * Point2(x, y),
                                        T_map_box * Point2(-x, y)};
  return {Segment{corner[0], corner[1]}, Segment{corner[1], corner[2]}, Segment{corner[2], corner[3]},
          Segment{corner[3], corner[0]}};
}

double distance(const Segment& segment, const Point2& point) noexcept {
  const Point2 along = segment.b - segment.a;
  const double squared_length = along.squaredNorm();
  const double share =
      squared_length > 0.0 ? std::clamp((point - segment.a).dot(along) / squared_length, 0.0, 1.0) : 0.0;
  return (segment.a + share * along - point).norm();
}

double distance(const Box& box, const Point2& point) noexcept {
  const Point2 in_box = Pose2{box.centre.x(), box.centre.y(), box.heading}.inverse() * point;
  return std::hypot(std::max(0.0, std::abs(in_box.x()) - box.width / 2.0),
                    std::max(0.0, std::abs(in_box.y()) - box.depth / 2.0));
}

double distance(const Cylinder& cylinder, const Point2& point) noexcept {
  return distance_to_round(cylinder.centre, cylinder.radius, point);
}

double distance(const PlacedObstacle& obstacle, const Point2& point) noexcept {
  double nearest = nothing_near;
  for (const Box& box : obstacle.boxes) nearest = std::min(nearest, distance(box, point));
  for (const Cylinder& cylinder : obstacle.cylinders) nearest = std::min(nearest, distance(cylinder, point));
  return nearest;
}

double distance_to_walls(const World& world, const Point2& point) noexcept {
  double nearest = nothing_near;
  for (const Segment& wall : world.walls) nearest = std::min(nearest, distance(wall, point));
  for (const Circle& pillar : world.pillars)
    nearest = std::min(nearest, distance_to_round(pillar.centre, pillar.radius, point));
  for (const Door& door : world.doors) nearest = std::min(nearest, distance(leaf(door, door.mapped_opening), point));
  return nearest;
}

}  // namespace slamicp
