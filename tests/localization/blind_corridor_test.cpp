// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp::blind_corridor_test {
namespace {

// A reduced `scripts/measure honest --only corridor`: 60 m, of which 26 m show no end, at 1 m/s.
constexpr double length = 60.0;

struct Drive {
  SimulatedRun run;
  PointMap2::Pointer map;

  explicit Drive(bool with_odometry = true) {
    const World corridor = featureless_corridor(length, 2.5);
    Random random(7);
    DriveOptions options;
    options.speed = 1.0;
    options.lidar.angle_min = -2.35619449;
    options.lidar.rate = 20.0;
    options.odometry = no_odometry_noise();
    options.odometry.translation_scale_error = 0.02;
    run = simulate_drive(corridor, route(corridor, "reference").waypoints, options);
    map = PointMap2::create(sample_map(corridor, random));
    if (with_odometry) return;
    for (LaserScan& scan : run.scans) scan.T_odom_robot.reset();
  }

  bool sees_the_end(std::size_t k) const { return run.truth[k].pose.x > length - 30.0; }
};

TEST(BlindCorridorTest, FollowsOdometryUntilAnEndIsSeen) {
  const Drive drive;
  Localizer localizer(drive.map);
  localizer.set_pose(drive.run.truth.front().pose);
  std::size_t blind = 0, flagged = 0;
  double seen_since = 1e9;
  for (std::size_t k = 0; k < drive.run.scans.size(); ++k) {
    const Fix& fix = localizer.update(drive.run.scans[k]);
    const Pose2& truth = drive.run.truth[k].pose;
    const double along = std::abs(fix.pose.x - truth.x);
    const double odometry = std::abs(drive.run.scans[k].T_odom_robot->x + 2.0 - truth.x);
    ASSERT_LT(std::abs(fix.pose.y - truth.y), 0.01) << k;
    ASSERT_LT(along, std::max(3.0 * std::sqrt(fix.covariance_in_map()(0, 0)), 0.01)) << k;
    if (drive.sees_the_end(k)) {
      seen_since = std::min(seen_since, fix.stamp);
      if (fix.stamp > seen_since + 1.0) {
        ASSERT_LT(along, 0.03) << k;
      }
      continue;
    }
    ++blind;
    flagged += fix.match.uncertainty.blind && std::abs(fix.blind_direction.x()) > 0.99 ? 1U : 0U;
    ASSERT_LT(along, 1.05 * odometry + 0.01) << k;
    if (k > 0) {
      ASSERT_EQ(fix.carried_by, Carrier::odometry) << k;
      ASSERT_TRUE(fix.usable());
    }
  }
  EXPECT_GE(static_cast<double>(flagged), 0.99 * static_cast<double>(blind));
}

// Far along, the direction that odometry has gone is a little off, and so is where it has the robot across.
TEST(BlindCorridorTest, AnEndIsFoundAfterALongBlindWay) {
  const World corridor = featureless_corridor(120.0, 2.5);
  for (const std::uint64_t seed : {2U, 3U}) {
    Random random(seed);
    DriveOptions options;
    options.speed = 0.5;
    options.seed = seed;
    options.lidar.rate = 5.0;
    options.odometry = no_odometry_noise();
    options.odometry.translation_scale_error = 0.02;
    const SimulatedRun run = simulate_drive(corridor, route(corridor, "reference").waypoints, options);
    Localizer localizer(PointMap2::create(sample_map(corridor, random)));
    localizer.set_pose(run.truth.front().pose);
    std::size_t k = 0;
    for (; run.truth[k].pose.x < 120.0 - 29.0; ++k) localizer.update(run.scans[k]);
    const PoseDistance off = distance(localizer.update(run.scans[k]).pose, run.truth[k].pose);
    EXPECT_LT(off.translation, 0.03) << "seed " << seed;
    EXPECT_TRUE(localizer.fix().blind_direction.isZero());
  }
}

TEST(BlindCorridorTest, WithoutOdometryNothingMeasuredCarriesIt) {
  const Drive drive(false);
  Localizer localizer(drive.map);
  localizer.set_pose(drive.run.truth.front().pose);
  for (std::size_t k = 0; k < 20; ++k) localizer.update(drive.run.scans[k]);
  EXPECT_EQ(localizer.fix().stop(), Stop::degenerate);
  EXPECT_EQ(localizer.fix().carried_by, Carrier::velocity);
  EXPECT_FALSE(localizer.fix().usable());
  EXPECT_GT(std::sqrt(localizer.fix().covariance_in_map()(0, 0)), 0.2);
  EXPECT_LT(std::sqrt(localizer.fix().covariance_in_map()(1, 1)), 0.02);
}

}  // namespace
}  // namespace slamicp::blind_corridor_test
