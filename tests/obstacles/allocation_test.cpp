// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>

#include "support/allocations.hpp"
#include "support/room.hpp"

namespace slamicp::obstacle_allocation_test {
namespace {

TEST(ObstacleAllocationTest, AFinderWithRoomAllocatesNothing) {
  const test::Room room = test::simple_room();
  test::Room cluttered = room;
  cluttered.add_box({3.0, 1.8}, 0.4, 0.3, 0.5);
  cluttered.add_box({4.5, 1.0}, 0.2, 0.2, 0.1);
  cluttered.add_box({1.0, 3.85}, 0.1, 0.1, 0.0);
  Localizer localizer(PointMap2::create(room.map(0.01)));
  const Pose2 start{1.5, 1.2, 0.4};
  localizer.set_pose(start);
  ObstacleFinder finder;
  EXPECT_GT(test::allocations_of([&] { finder.reserve(8, 541); }), 0) << "else nothing was counted";
  localizer.update(cluttered.scan(start));
  for (int k = 0; k < 20; ++k) {
    const LaserScan scan = cluttered.scan(start * Pose2{0.02 * k, 0.0, 0.01 * k});
    const Fix& fix = localizer.update(scan);
    std::size_t found = 0;
    EXPECT_EQ(test::allocations_of([&] { found = finder.find(fix, scan).size(); }), 0);
    EXPECT_GE(found, 2U);
  }
}

}  // namespace
}  // namespace slamicp::obstacle_allocation_test
