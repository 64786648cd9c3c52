// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/crowd.hpp>

namespace slamicp::crowd_test {
namespace {

constexpr CrowdLayout layouts[] = {CrowdLayout::crossing, CrowdLayout::along, CrowdLayout::groups,
                                   CrowdLayout::random_walk};

World crowded(const CrowdOptions& options, const World& world = corridor_world()) {
  return with_crowd(world, route(world, "reference").waypoints, options);
}

TEST(Crowd, AllAreSoundAndKeepClearOfTheWalls) {
  for (const CrowdLayout layout : layouts) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const World world = crowded({.people = 8, .layout = layout, .seed = seed});
      ASSERT_EQ(world.people.size(), 8U);
      for (const Person& person : world.people) {
        EXPECT_EQ(person.problem(), "") << person.name;
        for (double stamp = 0.0; stamp < 60.0; stamp += 0.1)
          ASSERT_GE(distance_to_walls(world, pose_at(person, stamp).translation()), 0.35 - 1e-9)
              << person.name << ", " << stamp << " s, layout " << static_cast<int>(layout);
      }
    }
  }
}

TEST(Crowd, TheSameSeedGivesTheSamePeopleAndAnotherDoesNot) {
  for (const CrowdLayout layout : layouts) {
    const Pose2 one = pose_at(crowded({.layout = layout, .seed = 4}).people.back(), 3.0);
    const Pose2 same = pose_at(crowded({.layout = layout, .seed = 4}).people.back(), 3.0);
    const Pose2 other = pose_at(crowded({.layout = layout, .seed = 5}).people.back(), 3.0);
    EXPECT_EQ(one.translation(), same.translation());
    EXPECT_EQ(one.theta, same.theta);
    EXPECT_NE(one.translation(), other.translation());
  }
}

TEST(Crowd, EachLayoutIsWhatItsNameSays) {
  const World empty = corridor_world();
  const SplinePath path(route(empty, "reference").waypoints);
  for (const Person& person : crowded({.people = 10, .layout = CrowdLayout::crossing}).people) {
    ASSERT_EQ(person.way.size(), 2U);
    const double left = path.nearest(person.way[0], 0.0, path.length()).cross_track;
    const double right = path.nearest(person.way[1], 0.0, path.length()).cross_track;
    EXPECT_GT(left, right) << person.name;
  }
  for (const Person& person : crowded({.people = 10, .layout = CrowdLayout::along}).people) {
    const double offset = path.nearest(person.way[1], 0.0, path.length()).cross_track;
    for (const Point2& corner : person.way)
      EXPECT_NEAR(path.nearest(corner, 0.0, path.length()).cross_track, offset, 0.15) << person.name;
  }
  const World standing = crowded({.people = 9, .layout = CrowdLayout::groups});
  for (const Person& person : standing.people) {
    EXPECT_EQ(person.way.size(), 1U);
    EXPECT_GT(std::abs(path.nearest(person.way[0], 0.0, path.length()).cross_track), 0.48);
    for (const Person& other : standing.people)
      EXPECT_TRUE(&other == &person || (other.way[0] - person.way[0]).norm() > 0.49) << person.name;
  }
  std::size_t corners = 0;
  for (const Person& person : crowded({.people = 10, .layout = CrowdLayout::random_walk}).people)
    corners += person.way.size();
  EXPECT_GT(corners, 60U);
}

TEST(Crowd, ObstaclesAndClosedDoorsAreInTheWay) {
  World world;
  for (const Segment& side : sides({{5.0, 0.0}, 12.0, 4.0, 0.0})) world.walls.push_back(side);
  world.routes.push_back({"reference", {{0.0, -1.0}, {5.0, -1.0}, {10.0, -1.0}}});
  world = with_box(world, {{5.0, 0.5}, 10.0, 0.2, 0.0});
  world.doors.push_back({"door", {-1.0, 0.5}, {0.0, 0.5}, 0.0, 0.0, 0.04});
  for (const Person& person : crowded({.people = 20, .layout = CrowdLayout::random_walk}, world).people) {
    for (const Point2& corner : person.way) {
      const bool is_below = corner.y() <= 0.4 - 0.35 + 1e-9;
      EXPECT_TRUE(is_below || corner.x() > 10.0) << person.name << " came through";
    }
  }
}

TEST(Crowd, SaysWhereThereIsNoRoom) {
  World world;
  for (const Segment& side : sides({{5.0, 0.0}, 12.0, 0.5, 0.0})) world.walls.push_back(side);
  world.routes.push_back({"reference", {{0.0, 0.0}, {10.0, 0.0}}});
  for (const CrowdLayout layout : layouts) EXPECT_THROW(crowded({.layout = layout}, world), Error);
  EXPECT_EQ(crowded({.people = 0}, world).people.size(), 0U);
  EXPECT_NE((CrowdOptions{.people = -1}.problem()), "");
  EXPECT_NE((CrowdOptions{.clearance = 0.0}.problem()), "");
}

}  // namespace
}  // namespace slamicp::crowd_test
