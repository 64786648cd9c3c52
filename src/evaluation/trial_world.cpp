// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/simulation/corridor_world.hpp>

namespace slamicp {
namespace {

void add_sides(World& world, const Box& box) {
  for (const Segment& side : sides(box)) world.walls.push_back(side);
}

/// Six rooms along a passage, a desk and a cupboard in each, every other door open.
World office() {
  World world;
  world.name = "office";
  add_sides(world, {{9.0, 6.0}, 18.0, 12.0, 0.0});
  for (const double y : {5.0, 7.0}) {
    const double into_room = y < 6.0 ? -1.0 : 1.0;
    for (int room = 0; room < 3; ++room) {
      const double left = 6.0 * room;
      const double door = left + 1.4 + 0.9 * room;
      world.walls.push_back({{left, y}, {door, y}});
      world.walls.push_back({{door + 0.95, y}, {left + 6.0, y}});
      if (room > 0) world.walls.push_back({{left, y}, {left, y + 5.0 * into_room}});
      add_sides(world, {{door + 0.1, y + 0.45 * into_room}, 0.04, 0.85, 0.12 * room});
      add_sides(world, {{left + 3.9 - 0.4 * room, y + (3.1 + 0.3 * room) * into_room}, 1.6, 0.8, 0.25 * room});
      add_sides(world, {{left + 5.6, y + 1.6 * into_room}, 0.5, 1.1, 0.0});
    }
  }
  world.routes.push_back(
      {"reference", {{0.8, 6.0}, {4.0, 6.1}, {8.5, 5.9}, {8.0, 4.2}, {7.2, 2.5}, {8.2, 4.0}, {9.0, 6.0}, {17.0, 6.0}}});
  return world;
}

World hall() {
  World world;
  world.name = "hall";
  add_sides(world, {{0.0, 0.0}, 24.0, 16.0, 0.0});
  for (const Point2& pillar : {Point2(-6.0, -3.0), Point2(6.0, -3.0), Point2(-6.0, 3.5), Point2(6.0, 3.5)})
    world.pillars.push_back({pillar, 0.4});
  world.routes.push_back({"reference", {{-10.0, -6.0}, {-3.0, 0.0}, {0.0, 5.0}, {9.0, 6.0}}});
  return world;
}

/// Rows of racks, each a row of posts and pallets of unequal depth.
World warehouse() {
  World world;
  world.name = "warehouse";
  add_sides(world, {{22.0, 12.0}, 44.0, 24.0, 0.0});
  Random random(5);
  for (int row = 0; row < 4; ++row)
    for (int bay = 0; bay < 12; ++bay) {
      const Point2 corner(5.0 + 2.8 * bay, 4.0 + 5.0 * row);
      add_sides(world, {corner, 0.12, 1.1, 0.0});
      const double depth = random.uniform(0.7, 1.0);
      if (random.uniform() < 0.8)
        add_sides(world, {corner + Point2(1.4, random.uniform(-0.1, 0.1)), random.uniform(1.5, 2.3), depth, 0.0});
    }
  world.routes.push_back(
      {"reference",
       {{2.5, 2.0}, {2.5, 6.5}, {20.0, 6.6}, {38.0, 6.4}, {41.5, 9.0}, {38.0, 11.5}, {20.0, 11.4}, {6.0, 11.5}}});
  return world;
}

constexpr std::array<std::string_view, 4> names = {"office", "corridor", "hall", "warehouse"};

PlacedObstacle person_or_box(const Point2& at, Random& random) {
  PlacedObstacle thing;
  const double size = random.uniform(0.12, 0.3);
  const double heading = random.uniform(0.0, std::numbers::pi);
  if (random.uniform() < 0.6)
    thing.cylinders.push_back({at, size});
  else
    thing.boxes.push_back({at, 3.0 * size, 2.0 * size, heading});
  return thing;
}

}  // namespace

std::span<const std::string_view> trial_world_names() noexcept { return names; }

World trial_world(std::string_view name) {
  if (name == "office") return office();
  if (name == "corridor") return corridor_world();
  if (name == "hall") return hall();
  if (name == "warehouse") return warehouse();
  throw Error("there is no trial world '" + std::string(name) + "'", "trial_world",
              "use office, corridor, hall or warehouse");
}

World featureless_corridor(double length, double width) {
  World world;
  world.name = "featureless corridor";
  add_sides(world, {{0.5 * length, 0.0}, length, width, 0.0});
  world.routes.push_back({"reference", {{2.0, 0.0}, {0.5 * length, 0.0}, {length - 2.0, 0.0}}});
  return world;
}

Pose2 place_beside_route(const World& world, Random& random) {
  const SplinePath path(route(world, "reference").waypoints);
  while (true) {
    const Pose2 on_route = path.at(random.uniform(0.0, path.length()));
    const Pose2 beside = on_route * Pose2{0.0, random.uniform(-0.3, 0.3), random.uniform(-3.1, 3.1)};
    if (distance_to_walls(world, beside.translation()) > 0.25) return beside;
  }
}

double hidden_share(std::span<const double> bare, std::span<const double> now) noexcept {
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < bare.size(); ++i) hidden += now[i] < bare[i] ? 1U : 0U;
  return bare.empty() ? 0.0 : static_cast<double>(hidden) / static_cast<double>(bare.size());
}

World with_unmapped_things(World world, const Pose2& T_map_robot, const LidarModel& lidar, double share,
                           Random& random) {
  std::vector<double> bare, now;
  true_ranges(world, T_map_robot * lidar.T_robot_laser, lidar, bare);
  for (int tries = 0; tries < 200; ++tries) {
    true_ranges(world, T_map_robot * lidar.T_robot_laser, lidar, now);
    if (hidden_share(bare, now) >= share) break;
    const double direction = random.uniform(-std::numbers::pi, std::numbers::pi);
    const Point2 at = T_map_robot * (random.uniform(0.7, 5.0) * Point2(std::cos(direction), std::sin(direction)));
    PlacedObstacle thing = person_or_box(at, random);
    if (distance(thing, T_map_robot.translation()) > 0.35) world = with_obstacle(std::move(world), std::move(thing));
  }
  return world;
}

World furnished(World world, int count, Random& random) {
  for (int k = 0; k < count; ++k) {
    const Pose2 beside = place_beside_route(world, random);
    Box box;
    box.width = random.uniform(0.3, 1.5);
    box.depth = random.uniform(0.3, 0.8);
    box.heading = beside.theta;
    const double side = random.uniform(0.8, 2.0);
    box.centre = beside * Point2(0.0, random.uniform() < 0.5 ? side : -side);
    add_sides(world, box);
  }
  return world;
}

}  // namespace slamicp
