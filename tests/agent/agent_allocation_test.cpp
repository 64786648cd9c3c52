// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/agent/agent.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "support/allocations.hpp"

namespace slamicp::agent_allocation_test {
namespace {

TEST(AgentAllocationTest, AfterTheFirstScanACycleAllocatesNothing) {
  const World world = corridor_world();
  const auto path = std::make_shared<const SplinePath>(route(world, "reference").waypoints);
  Random random(1);
  Agent agent(PointMap2::create(sample_map(world, random)), path);
  const LidarModel lidar = hokuyo_utm30lx();
  double stamp = 0.0;
  const auto allocations_at = [&](const World& here, double travelled) {
    LaserScan seen = scan(here, path->at(travelled), lidar, random);
    seen.stamp = stamp += 0.025;
    return test::allocations_of([&] { agent.step(seen); });
  };
  agent.set_pose(path->at(7.0));
  EXPECT_GT(allocations_at(world, 7.0), 0) << "else nothing was counted";
  // More outliers than the first scan had, and obstacles where it had none: still nothing.
  World cluttered = corridor_world_with("D3");
  for (const char* name : {"A2", "B3", "C3"}) cluttered = with_obstacle(cluttered, corridor_obstacle(name));
  cluttered = with_cylinder(cluttered, {path->at(10.0).translation(), 0.12});
  std::size_t outliers = 0;
  std::size_t obstacles = 0;
  for (double travelled = 7.0; travelled < 9.0; travelled += 0.02) {
    LaserScan seen = scan(cluttered, path->at(travelled), lidar, random);
    seen.stamp = stamp += 0.025;
    const Cycle* cycle = nullptr;
    EXPECT_EQ(test::allocations_of([&] { cycle = &agent.step(seen); }), 0) << travelled;
    outliers = std::max(outliers, cycle->fix->outliers().size());
    obstacles = std::max(obstacles, cycle->obstacles.size());
  }
  EXPECT_GT(outliers, 50U);
  EXPECT_GT(obstacles, 2U);
  EXPECT_EQ(allocations_at(world, 9.0), 0);
  const LaserScan nothing;
  EXPECT_EQ(test::allocations_of([&] { agent.step(nothing); }), 0);
}

}  // namespace
}  // namespace slamicp::agent_allocation_test
