// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/simulation/corridor_world.hpp>

namespace slamicp {
namespace {

PlacedObstacle box(const char* name, const Point2& centre, double heading) {
  return {name, {{centre, 0.480, 0.215, heading}}, {}};
}

PlacedObstacle cylinder(const char* name, const Point2& centre, double radius) {
  return {name, {}, {{centre, radius}}};
}

PlacedObstacle two_cylinders(const char* name, const Point2& first, const Point2& second, double radius) {
  return {name, {}, {{first, radius}, {second, radius}}};
}

}  // namespace

std::vector<PlacedObstacle> corridor_obstacles() {
  return {
      box("A1", {9.0, 0.3}, 0.0),
      box("A2", {12.8, 2.23}, 1.5),
      box("A3", {21.3, 0.5}, 1.5),
      cylinder("B1", {12.2, 1.34}, 0.042),
      cylinder("B2", {7.75, 2.12}, 0.042),
      cylinder("B3", {15.4, 1.06}, 0.042),
      two_cylinders("C1", {19.0, 0.7}, {19.2, 1.1}, 0.05),
      two_cylinders("C2", {20.7, 1.9}, {20.9, 1.5}, 0.05),
      two_cylinders("C3", {13.0, 1.8}, {13.3, 1.9}, 0.05),
      cylinder("D1", {9.2, 0.7}, 0.135),
      cylinder("D2", {12.6, 2.17}, 0.135),
      cylinder("D3", {15.6, 1.035}, 0.135),
  };
}

PlacedObstacle corridor_obstacle(std::string_view name) {
  for (PlacedObstacle& obstacle : corridor_obstacles())
    if (obstacle.name == name) return std::move(obstacle);
  throw Error("there is no obstacle '" + std::string(name) + "'", "world 'corridor'",
              "use A, B, C or D with 1, 2 or 3: A1 to D3");
}

World corridor_world_with(std::string_view obstacle_name) {
  return with_obstacle(corridor_world(), corridor_obstacle(obstacle_name));
}

}  // namespace slamicp
