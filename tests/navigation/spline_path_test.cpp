// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/simulation/corridor_world.hpp>

#include "support/random.hpp"

namespace slamicp::spline_path_test {
namespace {

TEST(SplinePath, TwoWaypointsMakeAStraightLine) {
  const PointCloud2 waypoints = {{1.0, 1.0}, {4.0, 5.0}};
  const SplinePath path(waypoints);
  EXPECT_NEAR(path.length(), 5.0, 1e-9);
  const Pose2 middle = path.at(2.5);
  EXPECT_NEAR(middle.x, 2.5, 1e-9);
  EXPECT_NEAR(middle.y, 3.0, 1e-9);
  EXPECT_NEAR(middle.theta, std::atan2(4.0, 3.0), 1e-9);
  EXPECT_NEAR(path.at(99.0).y, 5.0, 1e-9);
}

TEST(SplinePath, PassesItsWaypointsAtEqualStepsAndLooksWhereItGoes) {
  const std::vector<Point2> waypoints = route(corridor_world(), "reference").waypoints;
  const SplinePath path(waypoints);
  std::size_t passed = 0;
  Pose2 previous = path.at(0.0);
  constexpr double step = 0.001;
  for (double travelled = step; travelled <= path.length(); travelled += step) {
    const Pose2 here = path.at(travelled);
    const PoseDistance moved = distance(previous, here);
    ASSERT_NEAR(moved.translation, step, 1e-6);
    ASSERT_LT(moved.rotation, 2.0 * step) << "bends within half a metre";
    const Pose2 motion = previous.inverse() * here;
    ASSERT_NEAR(motion.y, 0.0, 2e-6) << "no sideways motion";
    if (passed < waypoints.size() && (previous.translation() - waypoints[passed]).norm() < step) ++passed;
    previous = here;
  }
  EXPECT_GE(passed + 1, waypoints.size());  // the last one is the end
  EXPECT_LT((path.at(path.length()).translation() - waypoints.back()).norm(), 1e-9);
}

TEST(SplinePath, IsTheNaturalCubicWhereThatIsKnown) {
  // Equal chords (-1, 0), (0, 0), (1, 0) raised in the middle: y'' vanishes at the ends, so with chord length h on both
  // sides the slope at the ends is 3/2 of the chord's.
  const PointCloud2 waypoints = {{-1.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}};
  const Pose2 start = SplinePath(waypoints).at(0.0);
  EXPECT_NEAR(start.theta, std::atan2(1.5, 1.0), 1e-12);
}

TEST(SplinePath, RefusesWhatMakesNoPath) {
  const PointCloud2 one = {{0.0, 0.0}};
  const PointCloud2 twice = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}};
  const PointCloud2 not_finite = {{0.0, 0.0}, {std::nan(""), 0.0}};
  EXPECT_THROW(SplinePath{one}, Error);
  EXPECT_THROW(SplinePath{twice}, Error);
  EXPECT_THROW(SplinePath{not_finite}, Error);
}

TEST(SplinePath, SamplesAreEquallyFarApart) {
  const SplinePath path(route(corridor_world(), "reference").waypoints);
  const std::vector<Pose2> poses = path.sampled(0.02);
  EXPECT_EQ(poses.size(), static_cast<std::size_t>(std::ceil(path.length() / 0.02)) + 1);
  for (std::size_t i = 1; i + 1 < poses.size(); ++i)
    ASSERT_NEAR(distance(poses[i - 1], poses[i]).translation, 0.02, 2e-5);
  EXPECT_LT(distance(poses.back(), path.at(path.length())).translation, 1e-12);
  EXPECT_THROW(path.sampled(0.0), Error);
}

TEST(SplinePath, CurvatureIsTheTurnOfTheHeading) {
  const SplinePath path(route(corridor_world(), "reference").waypoints);
  for (double distance = 0.1; distance < path.length() - 0.1; distance += 0.05) {
    const double turned = wrap_angle(path.at(distance + 1e-4).theta - path.at(distance - 1e-4).theta);
    ASSERT_NEAR(path.curvature(distance), turned / 2e-4, 1e-2);
  }
  const PointCloud2 straight = {{0.0, 0.0}, {3.0, 1.0}};
  EXPECT_EQ(SplinePath(straight).curvature(1.0), 0.0);
}

TEST(SplinePath, FindsThePlaceBesideAPoint) {
  const SplinePath path(route(corridor_world(), "reference").waypoints);
  for (double distance = 0.5; distance < path.length() - 0.5; distance += 0.37)
    for (const double aside : {-0.2, 0.0, 0.13}) {
      const PathPlace place = path.nearest(path.at(distance) * Point2(0.0, aside), distance - 1.0, distance + 1.0);
      ASSERT_NEAR(place.distance, distance, 1e-3);
      ASSERT_NEAR(place.cross_track, aside, 1e-6);
    }
  EXPECT_EQ(path.nearest(path.at(0.0) * Point2(-1.0, 0.0), -1.0, 1.0).distance, 0.0);
}

TEST(SplinePath, NoPlaceIsNearerThanTheNearest) {
  const SplinePath path(route(corridor_world(), "reference").waypoints);
  test::Random random(3);
  for (int k = 0; k < 500; ++k) {
    const double from = random.uniform(-0.5, path.length());
    const double to = from + random.uniform(0.0, 1.5);
    const Point2 point = path.at(random.uniform(from, to)).translation() + random.point<2>(0.4);
    const PathPlace place = path.nearest(point, from, to);
    EXPECT_GE(place.distance, std::clamp(from, 0.0, path.length()));
    EXPECT_LE(place.distance, std::clamp(to, 0.0, path.length()));
    const double distance = (path.at(place.distance).translation() - point).norm();
    for (double other = std::max(from, 0.0); other < std::min(to, path.length()); other += 0.003)
      ASSERT_GE((path.at(other).translation() - point).norm(), distance - 1e-6);
  }
}

TEST(SplinePath, PlacesAreThePathAtEqualSteps) {
  const SplinePath path(route(corridor_world(), "reference").waypoints);
  const PointView<2> places = path.places();
  ASSERT_EQ(places.size(), static_cast<std::size_t>(std::ceil(path.length() / SplinePath::place_spacing)) + 1);
  for (std::size_t k = 0; k < places.size(); ++k)
    EXPECT_LT((places[k] - path.at(static_cast<double>(k) * SplinePath::place_spacing).translation()).norm(), 1e-12);
  const PointCloud2 short_way = {{0.0, 0.0}, {0.01, 0.0}};
  EXPECT_EQ(SplinePath(short_way).places().size(), 2U);
}

}  // namespace
}  // namespace slamicp::spline_path_test
