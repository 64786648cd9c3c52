// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <slamicp/simulation/world.hpp>

namespace slamicp::world_test {
namespace {

TEST(World, DistancesAreToTheSurface) {
  EXPECT_DOUBLE_EQ(distance(Segment{{0.0, 0.0}, {2.0, 0.0}}, {1.0, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(distance(Segment{{0.0, 0.0}, {2.0, 0.0}}, {5.0, 4.0}), 5.0);
  const Box upright{{1.0, 1.0}, 2.0, 0.5, std::numbers::pi / 2.0};
  EXPECT_NEAR(distance(upright, {2.0, 1.0}), 0.75, 1e-12);
  EXPECT_NEAR(distance(upright, {1.0, 3.0}), 1.0, 1e-12);
  EXPECT_EQ(distance(upright, {1.1, 1.9}), 0.0);
  EXPECT_NEAR(distance(Cylinder{{0.0, 0.0}, 0.5}, {3.0, 4.0}), 4.5, 1e-12);
}

TEST(World, SidesOfABoxGoRoundItCounterClockwise) {
  double area = 0.0;
  const auto outline = sides({{3.0, -1.0}, 0.48, 0.215, 0.7});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(outline[i].b, outline[(i + 1) % 4].a);
    area += 0.5 * (outline[i].a.x() * outline[i].b.y() - outline[i].a.y() * outline[i].b.x());
  }
  EXPECT_NEAR(area, 0.48 * 0.215, 1e-12);
  EXPECT_NEAR((outline[0].b - outline[0].a).norm(), 0.48, 1e-12);
}

TEST(World, AddedThingsAreObstaclesOfACopy) {
  const World empty;
  const World world = with_cylinder(with_box(empty, {{1.0, 0.0}, 1.0, 1.0, 0.0}), {{4.0, 0.0}, 0.5});
  EXPECT_TRUE(empty.obstacles.empty());
  ASSERT_EQ(world.obstacles.size(), 2U);
  EXPECT_TRUE(world.walls.empty());
  EXPECT_NEAR(distance(world.obstacles[1], {4.0, 2.0}), 1.5, 1e-12);
}

}  // namespace
}  // namespace slamicp::world_test
