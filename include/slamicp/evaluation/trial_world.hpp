// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/random.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// The worlds that covariances are tried in: "office" (rooms, desks, open doors), "corridor" (corridor_world()), "hall"
/// (24 m x 16 m, four pillars), "warehouse" (44 m x 24 m, racks that look alike).
std::span<const std::string_view> trial_world_names() noexcept;

/// The world of that name. Each has a route "reference" to stand on. Throws Error for any other name.
World trial_world(std::string_view name);

/// A corridor along x from the origin, without doors, pillars or anything else to hold on to but its two ends.
/// @param length  [m], > 0
/// @param width   [m], > 0; the robot's route "reference" runs in the middle, from 2 m after one end to 2 m before the
///                other
World featureless_corridor(double length, double width);

/// Somewhere along the world's route "reference", up to 0.3 m beside it, with any heading.
Pose2 place_beside_route(const World& world, Random& random);

/// Of the ranges of one lidar at one place, the share that things have made shorter. As many each.
double hidden_share(std::span<const double> bare, std::span<const double> now) noexcept;

/// The world with people and boxes around the robot that the map does not know, until they take so large a share of
/// the beams that return.
/// @param share  in [0, 0.9]
World with_unmapped_things(World world, const Pose2& T_map_robot, const LidarModel& lidar, double share,
                           Random& random);

/// The world with furniture beside its route, as a map has it that was made before the furniture was carried away.
/// @param count  of boxes of 0.3 to 1.5 m
World furnished(World world, int count, Random& random);

}  // namespace slamicp
