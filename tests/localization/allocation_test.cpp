// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/localization/localizer.hpp>

#include "support/allocations.hpp"
#include "support/room.hpp"

namespace slamicp::allocation_test {
namespace {

int allocations_of_update(Localizer& localizer, const LaserScan& scan) {
  return test::allocations_of([&] { localizer.update(scan); });
}

TEST(AllocationTest, AfterTheFirstScanAnUpdateAllocatesNothing) {
  const test::Room room = test::simple_room();
  test::Room cluttered = room;
  cluttered.add_box({3.0, 1.8}, 0.4, 0.3, 0.5);
  for (const Method method : {Method::point_to_point, Method::point_to_line}) {
    Localizer localizer(PointMap2::create(room.map(0.01)), {.method = method, .outputs = Outputs::all()});
    const Pose2 start{1.5, 1.2, 0.4};
    localizer.set_pose(start);
    LaserScan poor = room.scan(start);
    for (std::size_t i = 0; i < poor.ranges.size(); i += 3) poor.ranges[i] = 0.0F;

    EXPECT_GT(allocations_of_update(localizer, poor), 0) << "else nothing was counted";
    // More returns than the first scan had, and more outliers: still nothing.
    EXPECT_EQ(allocations_of_update(localizer, room.scan(start)), 0);
    EXPECT_TRUE(localizer.fix().outliers().empty());
    EXPECT_EQ(allocations_of_update(localizer, cluttered.scan(start)), 0);
    EXPECT_GT(localizer.fix().outliers().size(), 20U);
    for (int k = 0; k < 20; ++k)
      EXPECT_EQ(allocations_of_update(localizer, cluttered.scan(start * Pose2{0.02 * k, 0.0, 0.01 * k})), 0);
    EXPECT_EQ(allocations_of_update(localizer, LaserScan{}), 0);
    EXPECT_EQ(allocations_of_update(localizer, poor), 0);
  }
}

}  // namespace
}  // namespace slamicp::allocation_test
