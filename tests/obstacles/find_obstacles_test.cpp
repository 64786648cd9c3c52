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
  const ObstacleOptions absurd[] = {{.min_points = 0},
                                    {.range_noise = -0.1},
                                    {.range_noise = test::nan},
                                    {.min_incidence_deg = 0.0},
                                    {.min_incidence_deg = 90.0}};
  for (const ObstacleOptions& options : absurd) {
    EXPECT_FALSE(options.problem().empty());
    EXPECT_THROW(find_obstacles(seen.fix, seen.scan, options), Error);
  }
}

}  // namespace
}  // namespace slamicp::find_obstacles_test
