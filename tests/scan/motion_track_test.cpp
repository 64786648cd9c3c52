// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include <slamicp/scan/laser_mount.hpp>
#include <slamicp/scan/motion_track.hpp>

namespace slamicp::motion_track_test {
namespace {

MotionTrack::Sample at(double stamp, double x) { return {stamp, {x, 0.0, 0.0}}; }

TEST(MotionTrack, LiesBetweenTheSamplesAndABitBeyond) {
  MotionTrack track;
  EXPECT_FALSE(track.at(0.0));
  EXPECT_TRUE(track.add(at(1.0, 0.0)));
  EXPECT_TRUE(track.add(at(2.0, 1.0)));
  EXPECT_NEAR(track.at(1.25)->x, 0.25, 1e-12);
  EXPECT_NEAR(track.at(2.05)->x, 1.05, 1e-12);
  EXPECT_FALSE(track.at(2.2));
}

TEST(MotionTrack, GrownSampleBySampleInAnyOrderIsTheSameAsMadeAtOnce) {
  const std::vector<MotionTrack::Sample> samples{at(1.0, 0.1), at(3.0, 0.9), at(2.0, 0.4), at(2.0, 7.0), at(2.5, 0.5)};
  const MotionTrack whole(samples);
  MotionTrack grown;
  for (const auto& sample : samples) grown.add(sample);
  ASSERT_EQ(grown.size(), 4U);
  ASSERT_EQ(whole.size(), 4U);
  for (double stamp = 0.95; stamp < 3.1; stamp += 0.01) EXPECT_EQ(grown.at(stamp)->x, whole.at(stamp)->x) << stamp;
}

TEST(MotionTrack, AtASampleItIsThatSampleWhetherOthersHaveFollowedOrNot) {
  MotionTrack track;
  track.add({1.0, {0.1, 0.2, 0.3}});
  track.add({1.3, {0.7, 0.1, 0.5}});
  const Pose2 last = *track.at(1.3);
  track.add({1.7, {0.9, 0.3, 0.6}});
  const Pose2 middle = *track.at(1.3);
  EXPECT_EQ(last.x, 0.7);
  EXPECT_EQ(last.theta, 0.5);
  EXPECT_EQ(middle.x, last.x);
  EXPECT_EQ(middle.y, last.y);
  EXPECT_EQ(middle.theta, last.theta);
}

TEST(MotionTrack, ForgettingOldSamplesLeavesTheRestAsItIs) {
  MotionTrack track;
  for (int k = 0; k < 10; ++k) track.add(at(k, 0.1 * k * k));
  const double before = track.at(4.5)->x;
  track.forget_before(4.5);
  EXPECT_EQ(track.samples().front().stamp, 4.0);
  EXPECT_EQ(track.at(4.5)->x, before);
  EXPECT_FALSE(track.at(3.5));
  track.forget_before(100.0);
  EXPECT_EQ(track.size(), 1U);
}

TEST(MotionTrack, LeavesOutWhatIsNotFinite) {
  MotionTrack track;
  EXPECT_FALSE(track.add(at(std::numeric_limits<double>::quiet_NaN(), 0.0)));
  EXPECT_FALSE(track.add(at(1.0, std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(track.empty());
}

TEST(MotionTrack, TellsAScanWhereItBeganAndHowFarItsRobotGotMeanwhile) {
  const MotionTrack track({at(1.0, 0.0), at(2.0, 1.0)});
  LaserScan scan;
  scan.stamp = 1.5;
  scan.time_increment = 0.1;
  scan.ranges.assign(4, 1.0F);
  ASSERT_TRUE(set_odometry(track, scan));
  EXPECT_NEAR(scan.T_odom_robot->x, 0.5, 1e-12);
  EXPECT_NEAR(scan.sweep_motion->x, 0.3, 1e-12);
  scan.stamp = 5.0;
  EXPECT_FALSE(set_odometry(track, scan));
  EXPECT_FALSE(scan.T_odom_robot);
  EXPECT_FALSE(scan.sweep_motion);
}

TEST(LaserMount, ALaserThatHangsUpsideDownTurnsTheOtherWay) {
  Pose3 hanging;
  hanging.position = {0.2, 0.1, 1.0};
  hanging.orientation = Eigen::AngleAxisd(std::numbers::pi, Point3::UnitX());
  const LaserMount mount = laser_mount(hanging);
  EXPECT_TRUE(mount.upside_down);
  EXPECT_NEAR(mount.tilt, 0.0, 1e-6);
  LaserScan scan;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.01;
  apply(mount, scan);
  EXPECT_EQ(scan.angle_min, 1.0);
  EXPECT_EQ(scan.angle_increment, -0.01);
  EXPECT_EQ(scan.T_robot_laser.x, 0.2);
}

}  // namespace
}  // namespace slamicp::motion_track_test
