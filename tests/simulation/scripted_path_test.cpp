// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/scripted_path.hpp>

namespace slamicp {
namespace {

TEST(ScriptedPath, TwoWaypointsMakeAStraightLine) {
  const PointCloud2 waypoints = {{1.0, 1.0}, {4.0, 5.0}};
  const ScriptedPath path(waypoints);
  EXPECT_NEAR(path.length(), 5.0, 1e-9);
  const Pose2 middle = path.at(2.5);
  EXPECT_NEAR(middle.x, 2.5, 1e-9);
  EXPECT_NEAR(middle.y, 3.0, 1e-9);
  EXPECT_NEAR(middle.theta, std::atan2(4.0, 3.0), 1e-9);
  EXPECT_NEAR(path.at(99.0).y, 5.0, 1e-9);
}

TEST(ScriptedPath, PassesItsWaypointsAtEqualStepsAndLooksWhereItGoes) {
  const std::vector<Point2> waypoints = route(corridor_world(), "reference").waypoints;
  const ScriptedPath path(waypoints);
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

TEST(ScriptedPath, IsTheNaturalCubicWhereThatIsKnown) {
  // Equal chords (-1, 0), (0, 0), (1, 0) raised in the middle: y'' vanishes at the ends, so with chord length h on both
  // sides the slope at the ends is 3/2 of the chord's.
  const PointCloud2 waypoints = {{-1.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}};
  const Pose2 start = ScriptedPath(waypoints).at(0.0);
  EXPECT_NEAR(start.theta, std::atan2(1.5, 1.0), 1e-12);
}

TEST(ScriptedPath, RefusesWhatMakesNoPath) {
  const PointCloud2 one = {{0.0, 0.0}};
  const PointCloud2 twice = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}};
  const PointCloud2 not_finite = {{0.0, 0.0}, {std::nan(""), 0.0}};
  EXPECT_THROW(ScriptedPath{one}, Error);
  EXPECT_THROW(ScriptedPath{twice}, Error);
  EXPECT_THROW(ScriptedPath{not_finite}, Error);
}

}  // namespace
}  // namespace slamicp
