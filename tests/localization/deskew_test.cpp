// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gtest/gtest.h>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp::deskew_test {
namespace {

constexpr double rate = 40.0;
constexpr int settled = 6;  // scans, until the velocity is known

/// A robot that drives and turns at once, with constant velocity, and its scans.
struct Turning {
  World world = corridor_world();
  LidarModel lidar = hokuyo_utm30lx();
  Pose2 start{12.0, 1.2, 0.3};
  Vector<3> velocity{0.3, 0.0, 2.0};  // [m/s, m/s, rad/s]

  Turning() { lidar.sweep_time = 0.025; }
  Pose2 at(double stamp) const { return start * Pose2::exp(stamp * velocity); }
  LaserScan scan_at(double stamp, Random& random) const {
    LaserScan scan = slamicp::scan(world, at(stamp), Pose2::exp(lidar.sweep_time * velocity), lidar, random);
    scan.stamp = stamp;
    return scan;
  }
  PointMap2::Pointer map() const {
    Random random(1);
    return PointMap2::create(sample_map(world, random));
  }
};

struct Errors {
  std::vector<double> metres;
  double outliers = 0.0;  // mean, a scan
  double worst_turn = 0.0;

  double p95() {
    std::sort(metres.begin(), metres.end());
    return metres[metres.size() * 95 / 100];
  }
};

enum class Wheels { none, at_stamps, while_sweeping };

Errors follow(const Turning& robot, const LocalizerOptions& options, Wheels wheels) {
  Localizer localizer(robot.map(), options);
  localizer.set_pose(robot.start);
  Random random(2);
  Errors errors;
  constexpr int scans = 120;
  for (int k = 0; k < scans; ++k) {
    LaserScan scan = robot.scan_at(k / rate, random);
    if (wheels != Wheels::none) scan.T_odom_robot = Pose2{1.0, 2.0, 0.5} * robot.at(k / rate);
    if (wheels == Wheels::while_sweeping) scan.sweep_motion = Pose2::exp(robot.lidar.sweep_time * robot.velocity);
    const Fix& fix = localizer.update(scan);
    EXPECT_TRUE(fix.usable()) << fix.brief();
    if (k < settled) continue;
    const PoseDistance off = distance(fix.pose, robot.at(scan.stamp));
    errors.metres.push_back(off.translation);
    errors.worst_turn = std::max(errors.worst_turn, off.rotation);
    errors.outliers += static_cast<double>(fix.outliers().size()) / (scans - settled);
  }
  return errors;
}

TEST(DeskewTest, TurningAddsNoOutliersAndNoErrorWhateverTellsTheMotion) {
  const Turning turning;
  Turning resting;
  resting.velocity.setZero();
  const double at_rest = follow(resting, {}, Wheels::none).outliers;
  const double allowed = at_rest + 0.005 * turning.lidar.beams;
  for (const Wheels wheels : {Wheels::none, Wheels::at_stamps, Wheels::while_sweeping}) {
    Errors errors = follow(turning, {}, wheels);
    EXPECT_LE(errors.outliers, allowed) << static_cast<int>(wheels);
    EXPECT_LE(errors.p95(), 0.005) << static_cast<int>(wheels);
    EXPECT_LE(errors.worst_turn, 0.004) << static_cast<int>(wheels);
  }
}

TEST(DeskewTest, WithoutItTurnsSmear) {
  const Turning turning;
  Errors errors = follow(turning, {.deskew = false}, Wheels::while_sweeping);
  EXPECT_GT(errors.p95(), 0.005);
  EXPECT_GT(errors.worst_turn, 0.015) << "the pose is that of half way through the sweep";
}

TEST(DeskewTest, AMistakeAboutTheVelocityDiesAway) {
  Turning robot;
  Localizer localizer(robot.map());
  localizer.set_pose(robot.start);
  Random random(2);
  // The first scan knows of no motion: it is smeared, and with it what the next ones take for the velocity.
  localizer.update(robot.scan_at(0.0, random));
  EXPECT_GT(distance(localizer.fix().pose, robot.at(0.0)).rotation, 0.01);
  for (int k = 1; k < 8; ++k) localizer.update(robot.scan_at(k / rate, random));
  EXPECT_LT(distance(localizer.fix().pose, robot.at(7.0 / rate)).translation, 0.006);
  EXPECT_LT(distance(localizer.fix().pose, robot.at(7.0 / rate)).rotation, 0.003);
}

TEST(DeskewTest, WheelsThatAreNotToBeUsedAreNotBelievedDuringTheSweepEither) {
  const Turning robot;
  Localizer without(robot.map());
  Localizer not_used(robot.map(), {.use_odometry = false});
  without.set_pose(robot.start);
  not_used.set_pose(robot.start);
  Random random(2);
  for (int k = 0; k < 10; ++k) {
    LaserScan scan = robot.scan_at(k / rate, random);
    const Pose2 expected = without.update(scan).pose;
    scan.T_odom_robot = Pose2{9.0, 9.0, 1.0 * k};  // wheels that tell tales
    scan.sweep_motion = Pose2{0.2, 0.0, -0.4};
    const Pose2& pose = not_used.update(scan).pose;
    EXPECT_EQ(pose.x, expected.x);
    EXPECT_EQ(pose.theta, expected.theta);
  }
}

TEST(JoinedScansTest, TwoLasersGiveOneFix) {
  Turning robot;
  robot.lidar.beams = 541;
  robot.lidar.angle_min = -1.178;
  LidarModel rear = robot.lidar;
  rear.T_robot_laser = {-0.3, 0.1, 3.0};
  const double late = 0.011;  // the second laser starts its sweep later
  for (const bool wheels : {true, false}) {
    Localizer localizer(robot.map());
    localizer.set_pose(robot.start);
    Random random(3);
    for (int k = 0; k < 40; ++k) {
      const double stamp = k / rate;
      LaserScan scans[] = {
          robot.scan_at(stamp, random),
          scan(robot.world, robot.at(stamp + late), Pose2::exp(rear.sweep_time * robot.velocity), rear, random)};
      scans[1].stamp = stamp + late;
      if (wheels) {
        scans[0].T_odom_robot = robot.at(stamp);
        scans[1].T_odom_robot = robot.at(stamp + late);
      }
      const Fix& fix = localizer.update(scans);
      ASSERT_TRUE(fix.usable()) << fix.brief();
      EXPECT_EQ(fix.stamp, stamp);
      ASSERT_EQ(fix.scan.scans.size(), fix.scan.in_robot.size());
      EXPECT_EQ(fix.scan.scans.front(), 0);
      EXPECT_EQ(fix.scan.scans.back(), 1);
      if (k < settled) continue;
      EXPECT_LT(distance(fix.pose, robot.at(stamp)).translation, 0.01) << k;
      EXPECT_LT(fix.outliers().size(), 10U) << k;
    }
    EXPECT_EQ(&localizer.update(std::span<const LaserScan>{}), &localizer.fix());
  }
}

}  // namespace
}  // namespace slamicp::deskew_test
