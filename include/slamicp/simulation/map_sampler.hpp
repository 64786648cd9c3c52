// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/simulation/random.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// From one map point to the next along a wall [m]: gives `corridor_world()` the 10,402 points of the paper's map.
inline constexpr double default_map_spacing = 0.0086;
/// How far map points stray from their wall, one standard deviation [m].
inline constexpr double default_map_noise = 0.01;

/// A map as a careful survey would make it: points at equal steps along walls and around pillars, off by normal noise
/// along the surface's normal. Doors stand as the map has them. Obstacles and people are left out: they are what the
/// map does not know.
///
/// Points stand wall by wall, then pillars, then doors, in the world's order, both faces of a thin thing included.
/// @param spacing      at most this far apart along a wall [m], > 0
/// @param noise_sigma  standard deviation [m], >= 0
/// Throws Error for a spacing or noise out of range.
PointCloud2 sample_map(const World& world, double spacing, double noise_sigma, Random& random);

/// The same at the default spacing and noise.
PointCloud2 sample_map(const World& world, Random& random);

}  // namespace slamicp
