// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/obstacles/oriented_box.hpp>

#include "support/room.hpp"

namespace slamicp::oriented_box_test {
namespace {

using test::pi;

double heading_between(double a, double b) { return std::abs(std::remainder(a - b, pi)); }

TEST(SmallestBoxTest, OfARectangleIsThatRectangleHoweverItLies) {
  for (int k = -40; k <= 40; ++k) {
    const double heading = 0.04 * k;
    test::Room room;
    room.add_box({1.0, -2.0}, 0.48, 0.215, heading);
    const OrientedBox box = smallest_box(room.map(0.013));
    EXPECT_LT((box.centre - Point2(1.0, -2.0)).norm(), 1e-9);
    EXPECT_NEAR(box.width, 0.48, 1e-9);
    EXPECT_NEAR(box.depth, 0.215, 1e-9);
    EXPECT_LT(heading_between(box.heading, heading), 1e-9);
    EXPECT_GT(box.heading, -pi / 2.0);
    EXPECT_LE(box.heading, pi / 2.0);
  }
}

TEST(SmallestBoxTest, HoldsEveryPointAndIsNoLargerThanAnyOther) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    PointCloud2 cloud;
    for (int k = random.integer(3, 40); k > 0; --k) cloud.push_back(Point2(5, 3) + random.point<2>(1.0));
    const OrientedBox box = smallest_box(cloud);
    EXPECT_GE(box.width, box.depth);
    const Pose2 T_map_box{box.centre.x(), box.centre.y(), box.heading};
    for (const Point2& point : cloud) {
      const Point2 in_box = T_map_box.inverse() * point;
      EXPECT_LE(std::abs(in_box.x()), 0.5 * box.width + 1e-9);
      EXPECT_LE(std::abs(in_box.y()), 0.5 * box.depth + 1e-9);
    }
    for (int k = 0; k < 180; ++k) {
      const Bounds<2> bounds = bounds_of<2>(test::transformed(Pose2{0, 0, k * pi / 180.0}, cloud));
      EXPECT_LE(box.width * box.depth, (bounds.upper - bounds.lower).prod() + 1e-9);
    }
  }
}

TEST(TrimmedBoxTest, LeavesTheShareOutsideEachSide) {
  PointCloud2 cloud;
  for (int k = 0; k <= 100; ++k) cloud.emplace_back(0.04 * k, 0.01 * k);
  const OrientedBox box = trimmed_box(OrientedBox{}, cloud, 0.1);
  EXPECT_LT((box.centre - Point2(2.0, 0.5)).norm(), 1e-9);
  EXPECT_NEAR(box.width, 3.2, 1e-9);
  EXPECT_NEAR(box.depth, 0.8, 1e-9);
}

TEST(TrimmedBoxTest, WithoutTrimItIsTheBoxOfThePointsAtThatHeading) {
  test::Random random(4);
  PointCloud2 cloud;
  for (int k = 0; k < 50; ++k) cloud.push_back(Point2(5, 3) + random.point<2>(1.0));
  const OrientedBox smallest = smallest_box(cloud);
  const OrientedBox again = trimmed_box(smallest, cloud, 0.0);
  EXPECT_LT((again.centre - smallest.centre).norm(), 1e-9);
  EXPECT_NEAR(again.width, smallest.width, 1e-9);
  EXPECT_NEAR(again.depth, smallest.depth, 1e-9);
  EXPECT_NEAR(again.heading, smallest.heading, 1e-9);
  EXPECT_EQ(trimmed_box(smallest, {}, 0.1).width, smallest.width);
}

TEST(SmallestBoxTest, OfFewPointsIsAsFlatAsTheyAre) {
  const OrientedBox nothing = smallest_box({});
  EXPECT_EQ(nothing.width, 0.0);
  const OrientedBox point = smallest_box(PointCloud2(5, Point2(2, 3)));
  EXPECT_EQ(point.centre, Point2(2, 3));
  EXPECT_EQ(point.width, 0.0);
  EXPECT_EQ(point.depth, 0.0);
  const OrientedBox line = smallest_box(test::wall({1, 1}, {4, 5}, 0.1));
  EXPECT_NEAR(line.width, 5.0, 1e-9);
  EXPECT_NEAR(line.depth, 0.0, 1e-9);
  EXPECT_NEAR(line.heading, std::atan2(4.0, 3.0), 1e-9);
  EXPECT_LT((line.centre - Point2(2.5, 3.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace slamicp::oriented_box_test
