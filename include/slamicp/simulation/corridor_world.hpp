// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// The embedded world, in the likeness of the paper's Figures 1, 4 and 5: a corridor of 25.2 m x 2.5 m along x from
/// the origin, a side corridor that joins it from below, doors, pilasters, pillars in alcoves and a room with its door
/// open. Nothing repeats, so a scan fixes the position along the corridor too.
///
/// Routes:
/// - "reference": the paper's s-shaped path, out of the side corridor and along the main one, to the right.
/// - "survey": through all of it and back, for a robot that makes the map.
World corridor_world();

/// The paper's obstacles in corridor_world(), A1 to D3: A a box of 480 x 215 mm, B a cylinder of 42 mm radius, C two
/// cylinders of 50 mm, D a cylinder of 135 mm, each at three places. The paper shows the places in a figure only; ours
/// leave the reference route free (not the survey route) and show at most about as many outliers as Table 1 counts.
std::vector<PlacedObstacle> corridor_obstacles();

/// The obstacle of that name, "A1" to "D3". Throws Error for any other.
PlacedObstacle corridor_obstacle(std::string_view name);

/// corridor_world() with the obstacle of that name in it. Throws Error for a name that is not "A1" to "D3".
World corridor_world_with(std::string_view obstacle_name);

}  // namespace slamicp
