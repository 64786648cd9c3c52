// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/ray_class.hpp>

#include "support/room.hpp"

namespace slamicp::ray_class_test {
namespace {

/// A corridor along x, 2 m wide and 10 m long, open at its right end; a way goes off its upper wall from x = 4 to 5.
IndexedPoints<2> corridor() {
  test::Room room;
  const Point2 corners[][2] = {{{0, 0}, {10, 0}}, {{0, 2}, {4, 2}}, {{5, 2}, {10, 2}}, {{0, 0}, {0, 2}}};
  for (const auto& one : corners) room.walls.push_back({one[0], one[1]});
  return IndexedPoints<2>(room.map(0.01));
}

class RayClassTest : public testing::Test {
 protected:
  IndexedPoints<2> map_ = corridor();
  RayClassifier classify_{map_, 0.03};
  Point2 laser_{2.0, 1.0};
};

TEST_F(RayClassTest, WhatStandsBeforeAWallIsAnObstacle) {
  EXPECT_EQ(classify_(laser_, {3.0, 0.5}), RayClass::obstacle);
  EXPECT_EQ(classify_(laser_, {2.0, 0.06}), RayClass::obstacle) << "near to the wall";
}

TEST_F(RayClassTest, WhatIsSeenThroughAWallMeansThatItIsGone) {
  EXPECT_EQ(classify_(laser_, {2.5, -1.0}), RayClass::gone);
  EXPECT_EQ(classify_(laser_, {2.0, -0.06}), RayClass::gone);
}

TEST_F(RayClassTest, WhatLiesBeyondTheMapsEdgeIsUnmapped) {
  EXPECT_EQ(classify_(laser_, {15.0, 1.1}), RayClass::unmapped);
  EXPECT_EQ(classify_({4.5, 1.0}, {4.5, 4.0}), RayClass::unmapped) << "through the opening";
}

TEST_F(RayClassTest, WhatStandsBeforeAnOpeningBetweenWallsIsAnObstacle) {
  // Beyond it the map has nothing, but the place is in the corridor; it has walls to both sides of the ray.
  EXPECT_EQ(classify_({7.0, 1.0}, {9.0, 1.0}), RayClass::obstacle);
}

TEST_F(RayClassTest, WhatARayGrazesCannotBeTold) { EXPECT_EQ(classify_({1.0, 0.02}, {12.0, -0.2}), RayClass::unknown); }

TEST_F(RayClassTest, RaysThatAreNoneCannotBeTold) {
  EXPECT_EQ(classify_(laser_, laser_), RayClass::unknown);
  EXPECT_EQ(classify_(laser_, {test::nan, 0.0}), RayClass::unknown);
}

TEST(ClassifyOutliersTest, GivesEachOutlierOfAFixItsClass) {
  const test::Room room = test::simple_room();
  test::Room changed = room;
  changed.add_box({3.0, 1.8}, 0.4, 0.3, 1.0);
  const Pose2 pose{1.5, 1.2, 0.4};
  Localizer localizer(PointMap2::create(room.map(0.01)));
  localizer.set_pose(pose);
  const LaserScan scan = changed.scan(pose);
  const Fix& fix = localizer.update(scan);
  const std::vector<RayClass> classes = classify_outliers(fix, scan);
  ASSERT_EQ(classes.size(), fix.outliers().size());
  ASSERT_GT(classes.size(), 10U);
  for (const RayClass one : classes) EXPECT_EQ(one, RayClass::obstacle);
}

TEST(ClassifyOutliersTest, SeesThatAWallIsGone) {
  test::Room room = test::simple_room();
  const Pose2 pose{1.5, 1.2, 0.4};
  Localizer localizer(PointMap2::create(room.map(0.01)));
  localizer.set_pose(pose);
  test::Room open = room;
  open.walls.erase(open.walls.begin() + 3);  // the back of the niche: rays go on through it
  for (const auto& [a, b] :
       {std::pair<Point2, Point2>{{6.6, 1.5}, {8.0, 1.5}}, std::pair<Point2, Point2>{{8.0, 1.5}, {8.0, 2.3}},
        std::pair<Point2, Point2>{{8.0, 2.3}, {6.6, 2.3}}})
    open.walls.push_back({a, b});
  const LaserScan scan = open.scan(pose);
  const Fix& fix = localizer.update(scan);
  const std::vector<RayClass> classes = classify_outliers(fix, scan);
  const auto gone = std::count(classes.begin(), classes.end(), RayClass::gone);
  ASSERT_GT(classes.size(), 5U);
  EXPECT_GT(gone, static_cast<std::ptrdiff_t>(classes.size() * 2 / 3));
  EXPECT_EQ(std::count(classes.begin(), classes.end(), RayClass::obstacle), 0);
}

}  // namespace
}  // namespace slamicp::ray_class_test
