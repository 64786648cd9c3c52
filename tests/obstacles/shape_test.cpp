// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/obstacles/shape.hpp>

#include "support/room.hpp"

namespace slamicp::shape_test {
namespace {

constexpr double spacing = 0.25 * test::pi / 180.0;

/// What a laser at the origin sees of a room's walls, and nothing else.
PointCloud2 seen(const test::Room& room, const Point2& laser, double noise, test::Random& random) {
  PointCloud2 points;
  const Pose2 pose{laser.x(), laser.y(), 0.0};
  for (double angle = -test::pi; angle < test::pi; angle += spacing) {
    const double range = room.range(pose, angle);
    if (range > 0.0)
      points.push_back(laser + (range + random.normal(noise)) * Point2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

PointCloud2 seen_cylinder(const Point2& centre, double radius, const Point2& laser, double noise,
                          test::Random& random) {
  PointCloud2 points;
  for (double angle = -test::pi; angle < test::pi; angle += spacing) {
    const Point2 ray(std::cos(angle), std::sin(angle));
    const double along = ray.dot(centre - laser);
    const double aside = std::abs(ray.x() * (centre - laser).y() - ray.y() * (centre - laser).x());
    if (along <= 0.0 || aside >= radius) continue;
    const double range = along - std::sqrt(radius * radius - aside * aside);
    points.push_back(laser + (range + random.normal(noise)) * ray);
  }
  return points;
}

Shape shape_of(const PointCloud2& points, double noise) {
  return ShapeFinder().find({points, Point2::Zero(), spacing, std::max(noise, 0.003), true, true});
}

TEST(ShapeTest, ACornerThatIsSeenIsABoxOfItsSize) {
  test::Random random(1);
  for (const double noise : {0.0, 0.005, 0.01}) {
    test::Room room;
    room.add_box({2.0, 0.3}, 0.48, 0.36, 0.8);
    const Shape shape = shape_of(seen(room, Point2::Zero(), noise, random), noise);
    ASSERT_EQ(shape.kind, ShapeKind::box) << noise;
    EXPECT_NEAR(shape.width, 0.48, 0.01 + 2.0 * noise);
    EXPECT_NEAR(shape.depth, 0.36, 0.01 + 2.0 * noise);
    EXPECT_NEAR(shape.heading, 0.8, 0.02 + 5.0 * noise);
    EXPECT_LT((shape.centre - Point2(2.0, 0.3)).norm(), 0.01 + noise);
    EXPECT_TRUE(shape.width_seen && shape.depth_seen);
  }
}

TEST(ShapeTest, AFlatSideIsALineOfItsLength) {
  test::Random random(2);
  test::Room room;
  room.add_box({2.0, 0.0}, 0.2, 0.5, 0.0);
  const Shape shape = shape_of(seen(room, Point2::Zero(), 0.01, random), 0.01);
  ASSERT_EQ(shape.kind, ShapeKind::line);
  EXPECT_NEAR(shape.width, 0.5, 0.02);
  EXPECT_EQ(shape.depth, 0.0);
  EXPECT_NEAR(std::abs(shape.heading), test::pi / 2.0, 0.05);
  EXPECT_LT((shape.centre - Point2(1.9, 0.0)).norm(), 0.01);
}

TEST(ShapeTest, ARoundThingIsACircle) {
  test::Random random(3);
  for (const double radius : {0.135, 0.2, 0.4}) {
    const Shape shape = shape_of(seen_cylinder({2.0, 0.5}, radius, Point2::Zero(), 0.005, random), 0.005);
    ASSERT_EQ(shape.kind, ShapeKind::circle) << radius;
    EXPECT_NEAR(shape.radius, radius, 0.015);
    EXPECT_LT((shape.centre - Point2(2.0, 0.5)).norm(), 0.02);
    EXPECT_GT(shape.arc, 2.0);
    EXPECT_EQ(shape.width, 2.0 * shape.radius);
  }
}

TEST(ShapeTest, ACircleIsNeitherTooSmallNorTooLargeOnAverageAndAsSureAsItSays) {
  test::Random random(4);
  double sum = 0.0, in_sigmas = 0.0;
  int circles = 0;
  for (int k = 0; k < 300; ++k) {
    const Shape shape = shape_of(seen_cylinder({1.5, 0.2}, 0.135, Point2::Zero(), 0.01, random), 0.01);
    if (shape.kind != ShapeKind::circle) continue;
    ++circles;
    sum += shape.radius;
    in_sigmas += std::pow((shape.radius - 0.135) / shape.radius_sigma, 2);
  }
  ASSERT_GT(circles, 290);
  EXPECT_NEAR(sum / circles, 0.135, 0.003);
  EXPECT_NEAR(std::sqrt(in_sigmas / circles), 1.0, 0.4);
}

TEST(ShapeTest, AnUnseenEndIsNotGuessed) {
  test::Random random(5);
  test::Room room;
  room.add_box({2.0, 0.0}, 0.2, 0.5, 0.0);
  PointCloud2 points = seen(room, Point2::Zero(), 0.003, random);
  const Point2 end = points.back();
  points.resize(points.size() / 2);
  const Shape shape = ShapeFinder().find({points, Point2::Zero(), spacing, 0.005, true, false});
  ASSERT_EQ(shape.kind, ShapeKind::line);
  EXPECT_FALSE(shape.width_seen);
  EXPECT_NEAR(shape.width, 0.25, 0.02) << "what was seen of it";
  EXPECT_GT(shape.width_sigma, 0.05);
  EXPECT_GT((shape.centre - end).norm(), 0.2);
  EXPECT_NE(shape.brief().find("or more"), std::string::npos);
}

TEST(ShapeTest, FewOrScatteredPointsHaveNoShape) {
  test::Random random(6);
  EXPECT_EQ(shape_of({{1, 0}, {1, 0.01}, {1, 0.02}}, 0.01).kind, ShapeKind::unknown);
  PointCloud2 scattered;
  for (int k = 0; k < 40; ++k) scattered.push_back(Point2(2.0, 0.0) + random.point<2>(0.2));
  const Shape shape = shape_of(scattered, 0.01);
  EXPECT_EQ(shape.kind, ShapeKind::unknown);
  EXPECT_NEAR(shape.width, 0.4, 0.25);
  EXPECT_EQ(shape_of({}, 0.01).kind, ShapeKind::unknown);
}

TEST(ShapeOfRunTest, ABoxSeenFromManyPlacesHasItsSize) {
  test::Random random(7);
  test::Room room;
  room.add_box({3.0, 0.6}, 0.48, 0.215, 0.3);
  PointCloud2 points, lasers;
  for (double x = 0.0; x < 6.0; x += 0.05) {
    const PointCloud2 here = seen(room, {x, -0.6}, 0.01, random);
    points.insert(points.end(), here.begin(), here.end());
    lasers.resize(points.size(), Point2(x, -0.6));
  }
  const Shape shape = shape_of_run(points, lasers, 0.01);
  ASSERT_EQ(shape.kind, ShapeKind::box);
  EXPECT_TRUE(shape.width_seen);
  EXPECT_TRUE(shape.depth_seen);
  EXPECT_NEAR(shape.width, 0.48, 0.012);
  EXPECT_NEAR(shape.depth, 0.215, 0.012);
  EXPECT_NEAR(shape.heading, 0.3, 0.02);
  EXPECT_LT((shape.centre - Point2(3.0, 0.6)).norm(), 0.01);
}

TEST(ShapeOfRunTest, ARoundThingSeenFromManyPlacesHasItsRadius) {
  test::Random random(8);
  for (const double radius : {0.042, 0.135}) {
    PointCloud2 points, lasers;
    for (double x = 1.0; x < 5.0; x += 0.05) {
      const PointCloud2 here = seen_cylinder({3.0, 0.5}, radius, {x, -0.6}, 0.01, random);
      points.insert(points.end(), here.begin(), here.end());
      lasers.resize(points.size(), Point2(x, -0.6));
    }
    const Shape shape = shape_of_run(points, lasers, 0.01);
    ASSERT_EQ(shape.kind, ShapeKind::circle) << radius;
    EXPECT_GT(shape.arc, test::pi / 2.0);
    EXPECT_NEAR(shape.radius, radius, 0.004);
    EXPECT_LT((shape.centre - Point2(3.0, 0.5)).norm(), 0.006);
  }
}

}  // namespace
}  // namespace slamicp::shape_test
