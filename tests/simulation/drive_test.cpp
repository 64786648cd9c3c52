// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp::drive_test {
namespace {

const PointCloud2 short_way = {{5.9, -4.2}, {5.9, -2.6}, {6.2, -1.0}};

bool same(const Pose2& a, const Pose2& b) { return a.x == b.x && a.y == b.y && a.theta == b.theta; }

TEST(Drive, ScansAtTheLidarsRateAlongTheWholePath) {
  const SimulatedRun run = simulate_drive(corridor_world(), short_way, {.speed = 0.5, .odometry = no_odometry_noise()});
  ASSERT_EQ(run.scans.size(), run.truth.size());
  EXPECT_NEAR(static_cast<double>(run.scans.size()), 3.25 / 0.5 * 40.0, 8.0);
  for (std::size_t i = 0; i < run.scans.size(); ++i) {
    EXPECT_EQ(run.scans[i].stamp, static_cast<double>(i) / 40.0);
    EXPECT_EQ(run.truth[i].stamp, run.scans[i].stamp);
    EXPECT_EQ(run.scans[i].ranges.size(), 1081U);
    // Perfect wheels: odometry is the truth as seen from the start.
    const Pose2 expected = run.truth.front().pose.inverse() * run.truth[i].pose;
    EXPECT_LT(distance(*run.scans[i].T_odom_robot, expected).translation, 1e-9);
  }
  EXPECT_LT((run.truth.back().pose.translation() - short_way.back()).norm(), 0.5 / 40.0);
}

TEST(Drive, TheSameSeedGivesTheSameBytesAndAnotherDoesNot) {
  const World world = corridor_world();
  const SimulatedRun one = simulate_drive(world, short_way, {.seed = 9});
  const SimulatedRun two = simulate_drive(world, short_way, {.seed = 9});
  const SimulatedRun other = simulate_drive(world, short_way, {.seed = 10});
  ASSERT_EQ(one.scans.size(), two.scans.size());
  for (std::size_t i = 0; i < one.scans.size(); ++i) {
    EXPECT_EQ(one.scans[i].ranges, two.scans[i].ranges);
    EXPECT_TRUE(same(*one.scans[i].T_odom_robot, *two.scans[i].T_odom_robot));
    EXPECT_TRUE(same(one.truth[i].pose, two.truth[i].pose));
  }
  EXPECT_NE(one.scans.back().ranges, other.scans.back().ranges);
  EXPECT_FALSE(same(*one.scans.back().T_odom_robot, *other.scans.back().T_odom_robot));
}

TEST(Drive, OdometryDriftsAsTheNoiseSays) {
  // A straight metre, many times: the spread after one metre is the sigma, whatever the number of steps.
  OdometryNoise noise = no_odometry_noise();
  noise.translation_sigma = 0.02;
  noise.rotation_sigma_per_metre = 0.01;
  noise.translation_scale_error = 0.05;
  Random random(2);
  constexpr int runs = 4000;
  double mean_x = 0.0;
  double square_x = 0.0;
  double square_theta = 0.0;
  for (int k = 0; k < runs; ++k) {
    Pose2 pose;
    for (int step = 0; step < 20; ++step) pose = pose * measured_motion({0.05, 0.0, 0.0}, noise, random);
    mean_x += pose.x / runs;
    square_x += pose.x * pose.x / runs;
    square_theta += pose.theta * pose.theta / runs;
  }
  EXPECT_NEAR(mean_x, 1.05, 0.0015);
  EXPECT_NEAR(std::sqrt(square_x - mean_x * mean_x), 0.02, 0.001);
  EXPECT_NEAR(std::sqrt(square_theta), 0.01, 0.0005);
}

TEST(Drive, AnotherLidarLeavesTheOdometryAsItIs) {
  LidarModel coarse = hokuyo_utm30lx();
  coarse.beams = 361;
  const World world = corridor_world();
  const SimulatedRun one = simulate_drive(world, short_way);
  const SimulatedRun two = simulate_drive(world, short_way, {.lidar = coarse});
  EXPECT_TRUE(same(*one.scans.back().T_odom_robot, *two.scans.back().T_odom_robot));
}

TEST(Drive, OnThreeWheelsGetsToTheEndWithOdometryOfItsOwn) {
  const World world = corridor_world();
  for (const LidarModel& lidar : {hokuyo_utm30lx(), real_hokuyo_utm30lx()}) {
    const SimulatedRun run = simulate_drive(world, short_way, apr02(), {.speed = 0.5, .lidar = lidar});
    ASSERT_EQ(run.scans.size(), run.truth.size());
    EXPECT_LT((run.truth.back().pose.translation() - short_way.back()).norm(), 0.03);
    const SplinePath path(short_way);
    double off = 0.0;
    for (const StampedPose& truth : run.truth)
      off = std::max(off, std::abs(path.nearest(truth.pose.translation(), 0.0, path.length()).cross_track));
    EXPECT_LT(off, 0.05);
    const Pose2 travelled = run.truth.front().pose.inverse() * run.truth.back().pose;
    const double drift = distance(*run.scans.back().T_odom_robot, travelled).translation;
    EXPECT_GT(drift, 1e-4) << "its wheels slip";
    EXPECT_LT(drift, 0.3);
    EXPECT_EQ(run.scans[3].sweep_motion.has_value(), lidar.sweep_time > 0.0);
    const SimulatedRun again = simulate_drive(world, short_way, apr02(), {.speed = 0.5, .lidar = lidar});
    EXPECT_EQ(run.scans.back().ranges, again.scans.back().ranges);
  }
}

TEST(Drive, MeetsPeopleWhereTheyAreAtItsStamps) {
  World world = corridor_world();
  Person person;
  person.way = {{5.5, -0.5}, {6.3, -0.5}};
  world.people.push_back(person);
  const SimulatedRun run = simulate_drive(world, short_way, {.lidar = hokuyo_utm30lx(0.0)});
  for (const std::size_t k : {std::size_t{40}, std::size_t{90}}) {
    Random random(1);
    const LaserScan seen = scan(world, run.truth[k].pose, hokuyo_utm30lx(0.0), random, run.truth[k].stamp);
    EXPECT_EQ(run.scans[k].ranges, seen.ranges);
  }
}

TEST(Drive, RefusesOptionsThatCannotBe) {
  EXPECT_THROW(simulate_drive({}, short_way, {.speed = 0.0}), Error);
  OdometryNoise noise;
  noise.translation_sigma = -1.0;
  EXPECT_THROW(simulate_drive({}, short_way, {.odometry = noise}), Error);
  LidarModel slow = real_hokuyo_utm30lx();
  slow.rate = 50.0;
  EXPECT_THROW(simulate_drive({}, short_way, apr02(), {.lidar = slow}), Error);
}

}  // namespace
}  // namespace slamicp::drive_test
