// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

#include <slamicp/localization/localizer.hpp>

#include "support/room.hpp"

namespace {

std::atomic<bool> counting{false};
std::atomic<int> allocations{0};

void* allocate(std::size_t size) {
  if (counting) ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// Eigen, too, comes here: what it allocates it takes from malloc only where alignment demands it, and no fixed-size
// matrix does.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace slamicp {
namespace {

int allocations_of_update(Localizer& localizer, const LaserScan& scan) {
  allocations = 0;
  counting = true;
  localizer.update(scan);
  counting = false;
  return allocations;
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
}  // namespace slamicp
