// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/scan/scan_points.hpp>

#include "support/random.hpp"

namespace slamicp::scan_points_test {
namespace {

using test::pi;

LaserScan scan_of(std::vector<float> ranges) {
  LaserScan scan;
  scan.angle_min = -pi / 2.0;
  scan.angle_increment = pi / 2.0;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  scan.ranges = std::move(ranges);
  return scan;
}

TEST(ScanPointsTest, BeamsGoCounterClockwiseFromTheFirst) {
  const ScanPoints points = to_points(scan_of({1.0F, 2.0F, 3.0F}));
  ASSERT_EQ(points.in_robot.size(), 3U);
  EXPECT_LT((points.in_robot[0] - Point2(0, -1)).norm(), 1e-12);
  EXPECT_LT((points.in_robot[1] - Point2(2, 0)).norm(), 1e-12);
  EXPECT_LT((points.in_robot[2] - Point2(0, 3)).norm(), 1e-12);
  EXPECT_NEAR(field_of_view(scan_of({1.0F, 2.0F, 3.0F})), pi, 1e-12);
  EXPECT_EQ(field_of_view(LaserScan{}), 0.0);
}

TEST(ScanPointsTest, PointsAreWhereTheLaserSitsOnTheRobot) {
  test::Random random(1);
  for (int run = 0; run < 100; ++run) {
    LaserScan scan = scan_of({1.5F, 2.5F, 3.5F, 4.5F});
    const ScanPoints in_laser = to_points(scan);
    scan.T_robot_laser = random.pose<2>(0.5, 3.0);
    const ScanPoints in_robot = to_points(scan);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_LT((in_robot.in_robot[k] - scan.T_robot_laser * in_laser.in_robot[k]).norm(), 1e-12);
  }
}

TEST(ScanPointsTest, WhatIsNoReturnIsLeftOutAndBeamsKeepTheirNumbers) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float inf = std::numeric_limits<float>::infinity();
  const ScanPoints points =
      to_points(scan_of({nan, 1.0F, inf, -inf, 0.0F, -0.0F, 2.0F, -3.0F, 0.05F, 30.0F, 81.83F, 3.0F}));
  EXPECT_EQ(points.beams, (std::vector<int>{1, 6, 11}));
  EXPECT_EQ(points.in_robot.size(), 3U);
}

TEST(ScanPointsTest, ALimitLessScanStillKnowsNoReturns) {
  LaserScan scan;
  scan.ranges = {0.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1.0F};
  EXPECT_EQ(to_points(scan).beams, (std::vector<int>{3}));
  scan.range_max = test::infinity;
  EXPECT_EQ(to_points(scan).beams, (std::vector<int>{3}));
}

TEST(ScanPointsTest, AReadingAtTheLimitIsNoReturnThoughFloatsRound) {
  for (const double limit : {4.095, 5.6, 29.9, 30.0, 81.83}) {
    LaserScan scan = scan_of({1.0F, static_cast<float>(limit)});
    scan.range_max = limit;
    EXPECT_EQ(to_points(scan).beams, std::vector<int>{0}) << limit;
    scan.range_min = limit;
    scan.range_max = 1e300;
    EXPECT_EQ(to_points(scan).beams, std::vector<int>{1}) << limit;
  }
}

TEST(ScanPointsTest, TheFilterDropsShorterAndReachedReadings) {
  const ScanPoints points = to_points(scan_of({0.4F, 0.5F, 1.0F, 5.0F, 6.0F}), {.min_range = 0.5, .max_range = 5.0});
  EXPECT_EQ(points.beams, (std::vector<int>{1, 2}));
}

TEST(ScanPointsTest, ReusesItsMemory) {
  ScanPoints points;
  to_points(scan_of(std::vector<float>(100, 1.0F)), {}, points);
  const Point2* memory = points.in_robot.data();
  to_points(scan_of({2.0F, 0.0F, 3.0F}), {}, points);
  EXPECT_EQ(points.in_robot.data(), memory);
  EXPECT_EQ(points.beams, (std::vector<int>{0, 2}));
}

TEST(ScanPointsTest, AnEmptyScanHasNoPoints) { EXPECT_TRUE(to_points(LaserScan{}).in_robot.empty()); }

TEST(ScanProjectorTest, EachPointIsSeenFromWhereTheRobotWas) {
  test::Random random(3);
  ScanProjector projector;
  for (int run = 0; run < 50; ++run) {
    LaserScan scan = scan_of(std::vector<float>(37, 2.0F));
    scan.angle_increment = random.uniform(-0.2, 0.2);
    scan.ranges[5] = 0.0F;
    scan.T_robot_laser = random.pose<2>(0.5, 3.0);
    const SweepMotion motion{random.pose<2>(0.5, 3.0), random.pose<2>(0.5, 1.0)};
    ScanPoints points;
    projector.append(scan, {}, motion, points);
    ASSERT_EQ(points.in_robot.size(), 36U);
    for (std::size_t k = 0; k < points.in_robot.size(); ++k) {
      const double angle = scan.angle_min + points.beams[k] * scan.angle_increment;
      const Pose2 robot = motion.T_start_first * interpolate(motion.T_first_last, points.beams[k] / 36.0);
      const Point2 expected = robot * (scan.T_robot_laser * Point2(2.0 * std::cos(angle), 2.0 * std::sin(angle)));
      EXPECT_LT((points.in_robot[k] - expected).norm(), 1e-9);
    }
  }
}

TEST(ScanProjectorTest, ScansAreJoinedOneAfterTheOther) {
  ScanProjector projector;
  ScanPoints points;
  projector.append(scan_of({1.0F, 0.0F, 3.0F}), {}, {}, points);
  projector.append(scan_of({1.0F}), {}, {{5.0, 0.0, 0.0}, {}}, points);
  EXPECT_EQ(points.beams, (std::vector<int>{0, 2, 0}));
  EXPECT_LT((points.in_robot[2] - Point2(5.0, -1.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace slamicp::scan_points_test
