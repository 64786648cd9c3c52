// SPDX-License-Identifier: Apache-2.0
#include <numbers>
#include <span>

#include <slamicp/simulation/corridor_world.hpp>

namespace slamicp {
namespace {

// A step in a wall: a door niche, a pilaster, an alcove.
struct Step {
  double from;   // along the wall, from its start [m]
  double to;     // [m]
  double depth;  // out of the room [m]; negative: into it
};

void add_outline(World& world, std::span<const Point2> corners) {
  for (std::size_t i = 1; i < corners.size(); ++i) world.walls.push_back({corners[i - 1], corners[i]});
}

// A wall from start to end with the room on its left.
void add_wall(World& world, const Point2& start, const Point2& end, const std::vector<Step>& steps) {
  const Point2 along = (end - start).normalized();
  const Point2 outward(along.y(), -along.x());
  PointCloud2 corners = {start};
  for (const Step& step : steps) {
    corners.push_back(start + step.from * along);
    corners.push_back(start + step.from * along + step.depth * outward);
    corners.push_back(start + step.to * along + step.depth * outward);
    corners.push_back(start + step.to * along);
  }
  corners.push_back(end);
  add_outline(world, corners);
}

// An open door: a leaf 40 mm thick, from its hinge into the direction of the heading.
void add_door_leaf(World& world, const Point2& hinge, double width, double heading) {
  const Pose2 T_map_hinge{hinge.x(), hinge.y(), heading};
  const Box leaf{T_map_hinge * Point2(width / 2.0, 0.0), width, 0.04, heading};
  for (const Segment& side : sides(leaf)) world.walls.push_back(side);
}

void add_main_corridor(World& world) {
  // The lower wall, left and right of the side corridor.
  add_wall(world, {0.0, 0.0}, {5.0, 0.0}, {{1.15, 2.05, 0.08}, {3.4, 3.8, -0.2}});
  add_wall(world, {6.8, 0.0}, {25.2, 0.0},
           {{1.3, 2.2, 0.08},      // door
            {4.1, 4.5, -0.2},      // pilaster
            {6.4, 8.6, 0.9},       // alcove
            {10.2, 10.55, -0.18},  // pilaster
            {11.8, 12.75, 0.1},    // door
            {14.3, 15.2, 0.07},    // door
            {16.1, 17.3, -0.1}});  // radiator
  world.pillars.push_back({{13.9, -0.45}, 0.12});
  add_wall(world, {25.2, 0.0}, {25.2, 2.5}, {{0.45, 2.05, 0.1}});  // double door
  // The upper wall, right and left of the open room.
  add_wall(world, {25.2, 2.5}, {10.25, 2.5},
           {{1.8, 2.2, -0.2},      // pilaster
            {4.4, 5.3, 0.08},      // door
            {7.2, 9.0, 0.8},       // alcove
            {10.5, 10.9, -0.2},    // pilaster
            {12.7, 13.6, 0.08}});  // door, ajar
  world.pillars.push_back({{17.2, 2.95}, 0.15});
  add_door_leaf(world, {12.47, 2.53}, 0.86, std::numbers::pi + 0.2);
  add_wall(world, {9.3, 2.5}, {0.0, 2.5},
           {{0.75, 1.1, -0.2},   // pilaster
            {1.9, 2.8, 0.06},    // door
            {4.6, 5.5, 0.09},    // door
            {7.1, 7.5, -0.2}});  // pilaster
  add_wall(world, {0.0, 2.5}, {0.0, 0.0}, {{0.8, 1.7, 0.12}});
}

void add_side_corridor(World& world) {
  add_wall(world, {5.0, 0.0}, {5.0, -5.0}, {{1.5, 2.4, 0.06}});
  add_wall(world, {5.0, -5.0}, {6.8, -5.0}, {{0.3, 1.5, 0.12}});  // window
  add_wall(world, {6.8, -5.0}, {6.8, 0.0}, {{1.4, 2.3, 0.09}});
}

void add_room(World& world) {
  const PointCloud2 corners = {{10.25, 2.5}, {10.25, 2.65}, {11.2, 2.65}, {11.2, 4.6},
                               {8.6, 4.6},   {8.6, 2.65},   {9.3, 2.65},  {9.3, 2.5}};
  add_outline(world, corners);
  add_door_leaf(world, {10.27, 2.69}, 0.88, 1.35);
  for (const Segment& side : sides({{9.03, 4.35}, 0.65, 0.4, 0.0})) world.walls.push_back(side);  // cupboard
}

}  // namespace

World corridor_world() {
  World world;
  world.name = "corridor";
  add_main_corridor(world);
  add_side_corridor(world);
  add_room(world);
  world.routes.push_back({"reference",
                          {{5.9, -4.2},
                           {5.9, -2.6},
                           {5.95, -1.2},
                           {6.45, 0.25},
                           {7.6, 1.3},
                           {9.2, 1.7},
                           {11.0, 1.25},
                           {12.6, 0.8},
                           {14.2, 1.1},
                           {15.6, 1.55},
                           {17.0, 1.35}}});
  world.routes.push_back({"survey", {{5.9, -4.2}, {5.9, -1.8},  {5.65, -0.3}, {4.6, 0.8},   {3.0, 0.9},  {1.6, 0.65},
                                     {1.0, 0.95}, {1.0, 1.55},  {1.6, 1.8},   {4.0, 1.5},   {9.0, 1.3},  {16.0, 1.3},
                                     {21.0, 0.9}, {23.4, 0.65}, {24.0, 0.95}, {24.0, 1.55}, {23.4, 1.8}, {21.0, 1.4},
                                     {16.0, 1.1}, {9.0, 1.2},   {7.2, 0.9},   {6.15, -0.3}, {5.9, -1.8}, {5.9, -3.6}}});
  return world;
}

}  // namespace slamicp
