// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp {
namespace {

// The last-bit error of a length must not cost a point.
std::size_t steps_of(double length, double spacing) noexcept {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / spacing - 1e-9)));
}

}  // namespace

PointCloud2 sample_map(const World& world, double spacing, double noise_sigma, Random& random) {
  if (!(spacing > 0.0 && std::isfinite(spacing))) throw Error("spacing must be above 0 m", "sample_map", "try 0.0086");
  if (!(noise_sigma >= 0.0 && std::isfinite(noise_sigma)))
    throw Error("noise_sigma must be 0 m or more", "sample_map", "try 0.01");

  PointCloud2 map;
  const auto sample_wall = [&](const Segment& wall) {
    const Point2 along = wall.b - wall.a;
    const double length = along.norm();
    if (!(length > 0.0)) return;
    const Point2 normal = Point2(-along.y(), along.x()) / length;
    const std::size_t steps = steps_of(length, spacing);
    for (std::size_t i = 0; i < steps; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(steps);
      map.push_back(wall.a + share * along + noise_sigma * random.normal() * normal);
    }
  };
  for (const Segment& wall : world.walls) sample_wall(wall);
  for (const Circle& pillar : world.pillars) {
    const std::size_t steps = steps_of(2.0 * std::numbers::pi * pillar.radius, spacing);
    for (std::size_t i = 0; i < steps; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(steps);
      const Point2 normal(std::cos(angle), std::sin(angle));
      map.push_back(pillar.centre + (pillar.radius + noise_sigma * random.normal()) * normal);
    }
  }
  for (const Door& door : world.doors)
    for (const Segment& side : sides(leaf(door, door.mapped_opening))) sample_wall(side);
  return map;
}

PointCloud2 sample_map(const World& world, Random& random) {
  return sample_map(world, default_map_spacing, default_map_noise, random);
}

}  // namespace slamicp
