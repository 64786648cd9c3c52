// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/simulation/world.hpp>

namespace slamicp::node {

/// A room of 12 m x 8 m with a thing or two in it, so that a scan holds every direction: the fronts' tests have it too.
inline World room() {
  World world;
  const auto wall = [&](double ax, double ay, double bx, double by) { world.walls.push_back({{ax, ay}, {bx, by}}); };
  wall(0, 0, 12, 0), wall(12, 0, 12, 8), wall(12, 8, 0, 8), wall(0, 8, 0, 0);
  wall(4, 0, 4, 2), wall(8, 8, 8, 6.5), wall(8, 6.5, 10, 6.5);
  world.pillars.push_back({{3.0, 6.0}, 0.3});
  return world;
}

}  // namespace slamicp::node
