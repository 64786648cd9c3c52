// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>

#include "support/room.hpp"

namespace slamicp::find_obstacles_test {
namespace {

struct Seen {
  LaserScan scan;
  Fix fix;
};

/// What a robot at (1.5, 1.2) that looks ahead sees, with boxes that its map does not know.
Seen look_at(const std::vector<Point2>& boxes, double noise = 0.0, const Pose2& T_robot_laser = {}) {
  const test::Room room = test::simple_room();
  test::Room with_boxes = room;
  for (const Point2& box : boxes) with_boxes.add_box(box, 0.4, 0.3, 1.0);
  const Pose2 pose{1.5, 1.2, 0.4};
  test::Random random(1);
  Localizer localizer(PointMap2::create(room.map(0.01)));
  localizer.set_pose(pose);
  LaserScan scan = with_boxes.scan(pose * T_robot_laser, 0.0, noise, noise > 0.0 ? &random : nullptr);
  scan.T_robot_laser = T_robot_laser;
  return {scan, localizer.update(scan)};
}

TEST(FindObstaclesTest, WithoutOutliersThereAreNone) {
  const Seen seen = look_at({});
  EXPECT_TRUE(find_obstacles(seen.fix, seen.scan).empty());
}

TEST(FindObstaclesTest, OneThingIsOneObstacleWithItsPlaceSizeAndDistance) {
  const Point2 place(3.0, 1.8);
  for (const Pose2& T_robot_laser : {Pose2{}, Pose2{0.3, -0.1, 0.2}}) {
    const Seen seen = look_at({place}, 0.0, T_robot_laser);
    const std::vector<Obstacle> obstacles = find_obstacles(seen.fix, seen.scan);
    ASSERT_EQ(obstacles.size(), 1U);
    const Obstacle& obstacle = obstacles[0];
    EXPECT_LT((obstacle.box.centre - place).norm(), 0.15) << "only its near sides are seen";
    EXPECT_GT(obstacle.box.width, 0.3);
    EXPECT_LT(obstacle.box.width, 0.5);
    EXPECT_EQ(obstacle.points, seen.fix.outliers());
    EXPECT_EQ(obstacle.ray_class, RayClass::obstacle);
    EXPECT_TRUE(obstacle.first_end_seen && obstacle.last_end_seen);
    EXPECT_EQ(obstacle.shape.kind, ShapeKind::box);
    EXPECT_NEAR(obstacle.shape.width, 0.4, 0.03);
    EXPECT_NEAR(obstacle.shape.depth, 0.3, 0.03);
    EXPECT_LT((obstacle.shape.centre - place).norm(), 0.02);
    EXPECT_NEAR((obstacle.nearest - (seen.fix.pose * T_robot_laser).translation()).norm(), obstacle.distance, 1e-6);
    double nearest = 1e9;
    for (const int i : obstacle.points)
      nearest = std::min(
          nearest, static_cast<double>(
                       seen.scan.ranges[static_cast<std::size_t>(seen.fix.scan.beams[static_cast<std::size_t>(i)])]));
    EXPECT_NEAR(obstacle.distance, nearest, 1e-6) << "the laser's own reading";
    EXPECT_NE(obstacle.brief().find(" points"), std::string::npos);
  }
}

TEST(FindObstaclesTest, NoiseDoesNotTearAThing) {
  const Seen seen = look_at({{3.0, 1.8}}, 0.01);
  EXPECT_EQ(find_obstacles(seen.fix, seen.scan).size(), 1U);
}

TEST(FindObstaclesTest, TwoThingsAreTwoNearestFirst) {
  const Seen seen = look_at({{4.5, 1.2}, {2.4, 2.2}});
  const std::vector<Obstacle> obstacles = find_obstacles(seen.fix, seen.scan);
  ASSERT_EQ(obstacles.size(), 2U);
  EXPECT_LT((obstacles[0].box.centre - Point2(2.4, 2.2)).norm(), 0.2);
  EXPECT_LT((obstacles[1].box.centre - Point2(4.5, 1.2)).norm(), 0.2);
  EXPECT_LT(obstacles[0].distance, obstacles[1].distance);
}

TEST(FindObstaclesTest, AThingBehindAnotherIsApart) {
  // The far one peeps out beside the near one: beams follow each other, ranges jump.
  const Seen seen = look_at({{2.5, 1.6}, {4.2, 1.55}});
  const std::vector<Obstacle> obstacles = find_obstacles(seen.fix, seen.scan);
  ASSERT_EQ(obstacles.size(), 2U);
  EXPECT_TRUE(obstacles[0].points.front() == obstacles[1].points.back() + 1 ||
              obstacles[1].points.front() == obstacles[0].points.back() + 1)
      << "else this test shows nothing";
}

TEST(FindObstaclesTest, FewerPointsThanAskedForAreNoObstacle) {
  const Seen seen = look_at({{3.0, 1.8}});
  const int points = static_cast<int>(seen.fix.outliers().size());
  EXPECT_EQ(find_obstacles(seen.fix, seen.scan, {.min_points = points}).size(), 1U);
  EXPECT_EQ(find_obstacles(seen.fix, seen.scan, {.min_points = points + 1}).size(), 0U);
}

/// What a robot sees of a box beside a wall, by the paper's distance and by ours.
Seen beside_wall(double gap, bool strays, double noise) {
  const test::Room room = test::simple_room();
  test::Room with_box = room;
  with_box.add_box({3.0, 4.0 - gap - 0.05}, 0.1, 0.1, 0.0);
  const Pose2 pose{2.2, 2.2, 1.0};
  test::Random random(3);
  LocalizerOptions options;
  options.outputs.strays = strays;
  Localizer localizer(PointMap2::create(room.map(0.01)), options);
  localizer.set_pose(pose);
  LaserScan scan = with_box.scan(pose, 0.0, noise, noise > 0.0 ? &random : nullptr);
  return {scan, localizer.update(scan)};
}

TEST(FindObstaclesTest, ASmallThingBesideAWallIsSeenByTheNoiseNotByThePapersDistance) {
  for (const double noise : {0.0, 0.01}) {
    const Seen by_paper = beside_wall(0.1, false, noise);
    EXPECT_TRUE(find_obstacles(by_paper.fix, by_paper.scan).empty());
    const Seen by_noise = beside_wall(0.1, true, noise);
    const std::vector<Obstacle> obstacles = find_obstacles(by_noise.fix, by_noise.scan);
    ASSERT_EQ(obstacles.size(), 1U);
    EXPECT_LT((obstacles[0].box.centre - Point2(3.0, 3.85)).norm(), 0.06);
    EXPECT_EQ(obstacles[0].ray_class, RayClass::obstacle);
  }
}

TEST(FindObstaclesTest, NothingNewIsNoObstacleHoweverMuchNoise) {
  const test::Room room = test::simple_room();
  test::Random random(4);
  Localizer localizer(PointMap2::create(room.map(0.01, 0.01, &random)));
  const Pose2 pose{1.5, 1.2, 0.4};
  localizer.set_pose(pose);
  int obstacles = 0;
  for (int k = 0; k < 100; ++k) {
    const LaserScan scan = room.scan(pose, 0.025 * k, 0.01, &random);
    obstacles += static_cast<int>(find_obstacles(localizer.update(scan), scan).size());
  }
  EXPECT_EQ(obstacles, 0);
}

TEST(FindObstaclesTest, ThingsWithTheWallShowingBetweenThemAreTwo) {
  // 2 m away a beam takes 17 mm: three of them see the wall between two posts.
  const test::Room room = test::simple_room();
  test::Room with_posts = room;
  with_posts.add_box({2.0, 3.6}, 0.1, 0.1, 0.0);
  with_posts.add_box({2.17, 3.6}, 0.1, 0.1, 0.0);
  const Pose2 pose{2.08, 1.6, 1.57};
  Localizer localizer(PointMap2::create(room.map(0.01)));
  localizer.set_pose(pose);
  const LaserScan scan = with_posts.scan(pose);
  const std::vector<Obstacle> obstacles = find_obstacles(localizer.update(scan), scan);
  ASSERT_EQ(obstacles.size(), 2U);
  for (const Obstacle& obstacle : obstacles) EXPECT_TRUE(obstacle.first_end_seen && obstacle.last_end_seen);
}

TEST(FindObstaclesTest, WhatStandsAcrossTheFirstBeamOfAFullTurnIsOne) {
  const test::Room room = test::simple_room();
  test::Room with_box = room;
  with_box.add_box({1.0, 2.0}, 0.3, 0.3, 0.0);
  const Pose2 pose{2.2, 2.0, 0.0};  // the box stands behind the robot
  LaserScan scan;
  scan.angle_min = -test::pi;
  scan.angle_increment = 2.0 * test::pi / 720.0;
  scan.range_max = 30.0;
  for (int i = 0; i < 720; ++i)
    scan.ranges.push_back(static_cast<float>(with_box.range(pose, scan.angle_min + i * scan.angle_increment)));
  Localizer localizer(PointMap2::create(room.map(0.01)));
  localizer.set_pose(pose);
  const Fix& fix = localizer.update(scan);
  const std::vector<Obstacle> obstacles = find_obstacles(fix, scan);
  ASSERT_EQ(obstacles.size(), 1U);
  EXPECT_EQ(obstacles[0].points.size(), fix.outliers().size());
  EXPECT_GT(obstacles[0].points.front(), obstacles[0].points.back()) << "from the last beams on";
  EXPECT_NEAR(obstacles[0].shape.centre.x(), 1.15, 0.01) << "its near side";
  EXPECT_NEAR(obstacles[0].shape.centre.y(), 2.0, 0.01);
  EXPECT_TRUE(obstacles[0].first_end_seen && obstacles[0].last_end_seen);
}

TEST(FindObstaclesTest, AnEndHiddenByAnotherThingIsNotSeen) {
  const Seen seen = look_at({{2.5, 1.6}, {4.2, 1.55}});
  const std::vector<Obstacle> obstacles = find_obstacles(seen.fix, seen.scan);
  ASSERT_EQ(obstacles.size(), 2U);
  EXPECT_TRUE(obstacles[0].first_end_seen && obstacles[0].last_end_seen);
  EXPECT_NE(obstacles[1].first_end_seen, obstacles[1].last_end_seen);
}

TEST(FindObstaclesTest, AFinderThatIsUsedAgainKeepsNothingOfTheScanBefore) {
  ObstacleFinder finder;
  finder.reserve(1, 10);
  const Seen two = look_at({{4.5, 1.2}, {2.4, 2.2}});
  const Seen one = look_at({{3.0, 1.8}});
  const Seen none = look_at({});
  for (const Seen* seen : {&two, &one, &none, &two}) {
    const std::span<const Obstacle> found = finder.find(seen->fix, seen->scan);
    const std::vector<Obstacle> expected = find_obstacles(seen->fix, seen->scan);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].points, expected[k].points);
      EXPECT_EQ(found[k].box.centre, expected[k].box.centre);
      EXPECT_EQ(found[k].distance, expected[k].distance);
    }
  }
}

TEST(FindObstaclesTest, AbsurdOptionsAreRefused) {
  const Seen seen = look_at({});
  const ObstacleOptions absurd[] = {{.min_points = 0},          {.min_far_points = 0},
                                    {.range_noise = -0.1},      {.range_noise = test::nan},
                                    {.min_incidence_deg = 0.0}, {.min_incidence_deg = 90.0}};
  for (const ObstacleOptions& options : absurd) {
    EXPECT_FALSE(options.problem().empty());
    EXPECT_THROW(find_obstacles(seen.fix, seen.scan, options), Error);
  }
}

}  // namespace
}  // namespace slamicp::find_obstacles_test
