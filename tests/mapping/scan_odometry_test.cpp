// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/mapping/scan_odometry.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp::scan_odometry_test {
namespace {

/// Along the main corridor, at the paper's speed.
const SimulatedRun& drive() {
  static const SimulatedRun run = [] {
    DriveOptions options;
    options.speed = 0.5;
    options.lidar.rate = 10.0;
    const World world = corridor_world();
    return simulate_drive(world, route(world, "reference").waypoints, options);
  }();
  return run;
}

/// How far the motion from the first scan to the last is off [m].
PoseDistance drift(const Trajectory& trajectory) {
  const Trajectory& truth = drive().truth;
  const Pose2 moved = truth.front().pose.inverse() * truth[trajectory.size() - 1].pose;
  return distance(trajectory.front().pose.inverse() * trajectory.back().pose, moved);
}

Trajectory follow(const ScanOdometryOptions& options, std::size_t scans) {
  ScanOdometry odometry(options);
  for (std::size_t k = 0; k < scans; ++k) {
    LaserScan scan = drive().scans[k];
    scan.T_odom_robot = Pose2{99.0, 3.0, 1.0};  // wheels that block
    odometry.add(scan);
  }
  EXPECT_EQ(odometry.unmatched(), 0);
  EXPECT_EQ(odometry.trajectory().size(), scans);
  return odometry.trajectory();
}

TEST(ScanOdometryTest, FollowsTheRobotWithoutWheelsByALocalMap) {
  const PoseDistance off = drift(follow({.map_radius = 8.0}, drive().scans.size()));
  EXPECT_LT(off.translation, 0.05);
  EXPECT_LT(off.rotation, 0.01);
}

TEST(ScanOdometryTest, FollowsTheRobotScanToScan) {
  const PoseDistance off = drift(follow({.reference = OdometryReference::previous_scan}, 60));
  EXPECT_LT(off.translation, 0.15);
  EXPECT_LT(off.rotation, 0.02);
}

TEST(ScanOdometryTest, TheLocalMapStaysLocal) {
  MapperOptions options;
  options.forget_distance = 4.0;
  Mapper mapper(options);
  std::size_t most = 0;
  for (const LaserScan& scan : drive().scans) {
    mapper.add(scan);
    most = std::max(most, mapper.map()->size());
  }
  const Point2 end = mapper.trajectory().back().pose.translation();
  std::size_t far = 0;
  std::size_t near = 0;
  for (const Point2& point : mapper.map()->points())
    if (is_finite<2>(point)) ++((point - end).norm() > 4.5 ? far : near);
  EXPECT_GT(near, 100U);
  EXPECT_LT(far, near / 2);
  Mapper all;
  for (const LaserScan& scan : drive().scans) all.add(scan);
  EXPECT_LT(most, all.map()->size());
  EXPECT_EQ(mapper.refined_map(), mapper.map());
}

TEST(ScanOdometryTest, RefusesAbsurdOptions) {
  EXPECT_THROW(ScanOdometry({.map_radius = 0.0}), Error);
  EXPECT_THROW(ScanOdometry({.max_iterations = 0}), Error);
  EXPECT_THROW(Mapper({.forget_distance = -1.0}), Error);
}

}  // namespace
}  // namespace slamicp::scan_odometry_test
