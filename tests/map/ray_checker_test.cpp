// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/map/ray_checker.hpp>

#include "support/room.hpp"

namespace slamicp::ray_checker_test {
namespace {

/// A wall of points along y at x = 1, from y = -2 to 2.
IndexedPoints<2> wall() {
  PointCloud2 points;
  for (int k = -100; k <= 100; ++k) points.emplace_back(1.0, 0.02 * k);
  return IndexedPoints<2>(points);
}

TEST(RayCheckerTest, TellsWhereARayEnds) {
  const IndexedPoints<2> map = wall();
  const RayChecker checker(map, 0.3, 0.005);
  EXPECT_EQ(checker.end_of({1.01, 0.5}), RayEnd::explained);
  EXPECT_EQ(checker.end_of({0.8, 0.5}), RayEnd::beside);
  EXPECT_EQ(checker.end_of({0.3, 0.1}), RayEnd::open);
}

TEST(RayCheckerTest, FindsTheWallThatARayWentThrough) {
  const IndexedPoints<2> map = wall();
  const RayChecker checker(map, 0.3, 0.005);
  EXPECT_TRUE(checker.passes_wall({0, 0}, {3.0, 0.7}));
  EXPECT_FALSE(checker.passes_wall({0, 0}, {1.0, 0.7})) << "it ends there";
  EXPECT_FALSE(checker.passes_wall({0, 0}, {0.5, 0.7})) << "it ends before";
  EXPECT_FALSE(checker.passes_wall({0, 0}, {3.0, 9.0})) << "the wall ends before";
  EXPECT_FALSE(checker.passes_wall({0.97, -3.0}, {0.97, 3.0})) << "it runs beside the wall";
}

TEST(RayCheckerTest, MeasuresTheWayToTheFirstWall) {
  const test::Room room = test::simple_room();
  const IndexedPoints<2> map(room.map(0.01));
  const RayChecker checker(map, 0.3, 0.005);
  const Pose2 laser{1.5, 1.2, 0.4};
  for (double angle = -3.0; angle < 3.0; angle += 0.05) {
    const Vector<2> ray(std::cos(laser.theta + angle), std::sin(laser.theta + angle));
    const WallMet wall = checker.first_wall(laser.translation(), ray, 0.0, 30.0);
    ASSERT_TRUE(wall.met) << angle;
    EXPECT_NEAR(wall.distance, room.range(laser, angle), wall.sure() ? 0.02 : 0.5) << angle;
  }
}

TEST(RayCheckerTest, LooksForWallsOnlyWhereItIsTold) {
  const IndexedPoints<2> map = wall();
  const RayChecker checker(map, 0.3, 0.005);
  const Vector<2> ahead(1.0, 0.0);
  EXPECT_NEAR(checker.first_wall({0, 0}, ahead, 0.0, 30.0).distance, 1.0, 0.01);
  EXPECT_FALSE(checker.first_wall({0, 0}, ahead, 0.0, 0.5).met);
  EXPECT_FALSE(checker.first_wall({0, 0}, ahead, 1.2, 30.0).met);
  EXPECT_FALSE(checker.first_wall({0, 0}, {-1.0, 0.0}, 0.0, 30.0).met);
  EXPECT_FALSE(checker.first_wall({1.005, -1.0}, {0.0, 1.0}, 0.0, 30.0).sure()) << "it grazes the wall";
}

}  // namespace
}  // namespace slamicp::ray_checker_test
