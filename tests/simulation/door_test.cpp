// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <numbers>

#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp::door_test {
namespace {

constexpr double quarter = 0.5 * std::numbers::pi;

/// A wall with two faces, 0.1 m apart, ahead of the origin.
World wall() {
  World world;
  world.walls = {{{2.0, -3.0}, {2.0, 3.0}}, {{2.1, -3.0}, {2.1, 3.0}}};
  return world;
}

/// A metre of it, which opens away from the origin.
Door door(double opening, double mapped_opening) {
  return {"door", {2.05, -0.5}, {2.05, 0.5}, opening, mapped_opening, 0.04};
}

double ahead(const World& world) {
  const LidarModel lidar = hokuyo_utm30lx();
  std::vector<double> ranges;
  true_ranges(world, {0.0, 0.1, 0.0}, lidar, ranges);
  return ranges[540];
}

TEST(Door, CutsAGapWithRevealsIntoBothFacesOfAWall) {
  const World world = with_door(wall(), door(-quarter, -quarter));
  ASSERT_EQ(world.walls.size(), 6U);
  EXPECT_NEAR(distance(world.walls[0], {2.0, 0.0}), 0.5, 1e-9);
  EXPECT_NEAR(distance(world.walls[1], {2.0, 0.0}), 0.5, 1e-9);
  for (const Segment& reveal : {world.walls[4], world.walls[5]}) {
    EXPECT_NEAR((reveal.a - reveal.b).norm(), 0.1, 1e-9);
    EXPECT_NEAR(std::abs(reveal.a.y()), 0.5, 1e-9);
  }
  EXPECT_TRUE(std::isinf(ahead(world)));
}

TEST(Door, LeavesWallsAloneThatOnlyTouchItsGap) {
  const World once = with_door(wall(), door(0.0, 0.0));
  const World twice = with_door(once, door(0.0, 0.0));
  ASSERT_EQ(twice.walls.size(), once.walls.size());
  for (std::size_t k = 0; k < once.walls.size(); ++k) {
    EXPECT_EQ(once.walls[k].a, twice.walls[k].a);
    EXPECT_EQ(once.walls[k].b, twice.walls[k].b);
  }
}

TEST(Door, TheLidarSeesItAsItStandsNowAndTheMapAsItStoodThen) {
  const auto middle_points = [](const World& world) {
    Random random(1);
    int count = 0;
    for (const Point2& point : sample_map(world, 0.01, 0.0, random))
      count += std::abs(point.x() - 2.05) < 0.03 && std::abs(point.y()) < 0.4;
    return count;
  };
  const World now_open = with_door(wall(), door(-quarter, 0.0));
  EXPECT_TRUE(std::isinf(ahead(now_open)));
  EXPECT_GT(middle_points(now_open), 100);
  EXPECT_LT(distance_to_walls(now_open, {2.05, 0.1}), 1e-9) << "by the map";
  const World now_closed = with_door(wall(), door(0.0, -quarter));
  EXPECT_NEAR(ahead(now_closed), 2.03, 1e-9);
  EXPECT_EQ(middle_points(now_closed), 0);
  EXPECT_GT(distance_to_walls(now_closed, {2.05, 0.1}), 0.3);
}

TEST(Door, TurnsAboutItsHinge) {
  const Box open = leaf(door(-quarter, 0.0), -quarter);
  EXPECT_LT((open.centre - Point2(2.55, -0.5)).norm(), 1e-12);
  EXPECT_NEAR(open.width, 1.0, 1e-12);
  EXPECT_NEAR(open.heading, 0.0, 1e-12);
}

}  // namespace
}  // namespace slamicp::door_test
