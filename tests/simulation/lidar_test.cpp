// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>

namespace slamicp::lidar_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

World room(double half_width, double half_depth) {
  World world;
  for (const Segment& side : sides({{0.0, 0.0}, 2.0 * half_width, 2.0 * half_depth, 0.0})) world.walls.push_back(side);
  return world;
}

double angle_of(const LidarModel& lidar, std::size_t beam) {
  return lidar.angle_min + static_cast<double>(beam) * lidar.angle_increment;
}

// What a ray meets, tested against everything: slow and plain.
double brute_force(const World& world, const Pose2& T_map_laser, double angle) {
  const Point2 origin = T_map_laser.translation();
  const Point2 direction(std::cos(T_map_laser.theta + angle), std::sin(T_map_laser.theta + angle));
  double nearest = infinity;
  const auto meet_segment = [&](const Segment& wall) {
    // origin + t * direction = a + u * (b - a), by Cramer's rule.
    const Point2 along = wall.b - wall.a;
    const Point2 to_a = wall.a - origin;
    const double determinant = along.x() * direction.y() - along.y() * direction.x();
    const double t = (along.x() * to_a.y() - along.y() * to_a.x()) / determinant;
    const double u = (direction.x() * to_a.y() - direction.y() * to_a.x()) / determinant;
    if (t >= 0.0 && u >= 0.0 && u <= 1.0 && t < nearest) nearest = t;
  };
  const auto meet_circle = [&](const Point2& centre, double radius) {
    const Point2 to_centre = centre - origin;
    const double b = direction.dot(to_centre);
    const double discriminant = b * b - to_centre.squaredNorm() + radius * radius;
    if (discriminant < 0.0) return;
    for (const double t : {b - std::sqrt(discriminant), b + std::sqrt(discriminant)})
      if (t >= 0.0 && t < nearest) nearest = t;
  };
  for (const Segment& wall : world.walls) meet_segment(wall);
  for (const Circle& pillar : world.pillars) meet_circle(pillar.centre, pillar.radius);
  for (const PlacedObstacle& obstacle : world.obstacles) {
    for (const Box& box : obstacle.boxes)
      for (const Segment& side : sides(box)) meet_segment(side);
    for (const Cylinder& cylinder : obstacle.cylinders) meet_circle(cylinder.centre, cylinder.radius);
  }
  return nearest;
}

TEST(Lidar, HokuyoUtm30lxIsAsInItsDataSheet) {
  const LidarModel lidar = hokuyo_utm30lx();
  EXPECT_EQ(lidar.problem(), "");
  EXPECT_EQ(lidar.beams, 1081);
  EXPECT_NEAR(angle_of(lidar, 1080), 0.75 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(angle_of(lidar, 540), 0.0, 1e-12);
}

TEST(Lidar, SeesTheWallsOfARoomWhereTheyAre) {
  const Pose2 T_map_laser{0.5, -0.25, 0.3};
  const LidarModel lidar = hokuyo_utm30lx();
  std::vector<double> ranges;
  true_ranges(room(3.0, 2.0), T_map_laser, lidar, ranges);
  ASSERT_EQ(ranges.size(), 1081U);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double angle = T_map_laser.theta + angle_of(lidar, i);
    const double to_x_wall = (std::copysign(3.0, std::cos(angle)) - T_map_laser.x) / std::cos(angle);
    const double to_y_wall = (std::copysign(2.0, std::sin(angle)) - T_map_laser.y) / std::sin(angle);
    EXPECT_NEAR(ranges[i], std::min(to_x_wall, to_y_wall), 1e-9) << "beam " << i;
  }
}

TEST(Lidar, SeesAPillarAsWideAsItIs) {
  World world;
  world.pillars.push_back({{2.0, 0.0}, 0.5});
  const LidarModel lidar = hokuyo_utm30lx();
  std::vector<double> ranges;
  true_ranges(world, {}, lidar, ranges);
  EXPECT_NEAR(ranges[540], 1.5, 1e-12);
  const double half_width = std::asin(0.25);
  for (std::size_t i = 0; i < ranges.size(); ++i)
    EXPECT_EQ(std::isfinite(ranges[i]), std::abs(angle_of(lidar, i)) < half_width) << "beam " << i;
}

TEST(Lidar, AgreesWithBruteForceAllOverTheCorridor) {
  World world = corridor_world();
  for (const PlacedObstacle& obstacle : corridor_obstacles()) world = with_obstacle(world, obstacle);
  LidarModel all_round = hokuyo_utm30lx();
  all_round.beams = 720;
  all_round.angle_increment = 2.0 * std::numbers::pi / 720.0;
  Random random(7);
  std::vector<double> ranges;
  for (int place = 0; place < 50; ++place) {
    const Pose2 T_map_laser{random.uniform(0.0, 25.0), random.uniform(0.0, 2.5), random.uniform(-9.0, 9.0)};
    for (LidarModel lidar : {hokuyo_utm30lx(), all_round}) {
      lidar.angle_min = random.uniform(-7.0, 7.0);
      true_ranges(world, T_map_laser, lidar, ranges);
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        const double expected = brute_force(world, T_map_laser, angle_of(lidar, i));
        ASSERT_NEAR(ranges[i], expected, 1e-6) << to_string(T_map_laser) << ", beam " << i;
      }
    }
  }
}

TEST(Lidar, NothingWithinReachIsNoReturn) {
  LidarModel lidar = hokuyo_utm30lx();
  Random random(1);
  for (const float range : scan({}, {}, lidar, random).ranges) EXPECT_EQ(range, 0.0F);
  for (const float range : scan(room(31.0, 31.0), {}, lidar, random).ranges) EXPECT_EQ(range, 0.0F);
  for (const float range : scan(room(0.05, 0.05), {}, lidar, random).ranges) EXPECT_EQ(range, 0.0F);
}

TEST(Lidar, MeasuresFromWhereItSitsOnTheRobot) {
  LidarModel lidar = hokuyo_utm30lx(0.0);
  lidar.T_robot_laser = {0.2, 0.0, std::numbers::pi / 2.0};
  Random random(1);
  const LaserScan sweep = scan(room(3.0, 2.0), {1.0, 0.0, 0.0}, lidar, random);
  EXPECT_NEAR(sweep.ranges[540], 2.0, 1e-6);  // ahead of the laser is the left of the robot
  EXPECT_NEAR(sweep.ranges[180], 1.8, 1e-6);  // 90 deg to its right is ahead of the robot
  EXPECT_EQ(sweep.T_robot_laser.x, 0.2);
}

TEST(Lidar, NoiseHasTheStandardDeviationAskedFor) {
  const World world = room(5.0, 5.0);
  const LidarModel lidar = hokuyo_utm30lx(0.02);
  std::vector<double> truth;
  true_ranges(world, {}, lidar, truth);
  Random random(3);
  double mean = 0.0;
  double square = 0.0;
  constexpr int scans = 50;
  for (int k = 0; k < scans; ++k) {
    const LaserScan sweep = scan(world, {}, lidar, random);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double error = static_cast<double>(sweep.ranges[i]) - truth[i];
      mean += error / (scans * 1081.0);
      square += error * error / (scans * 1081.0);
    }
  }
  EXPECT_NEAR(mean, 0.0, 0.0004);
  EXPECT_NEAR(std::sqrt(square), 0.02, 0.0003);
}

TEST(Lidar, AnObstacleChangesOnlyTheBeamsThatMeetIt) {
  const Pose2 T_map_robot{8.0, 1.4, 0.2};
  Random random(4);
  Random same = random;
  const LaserScan without = scan(corridor_world(), T_map_robot, hokuyo_utm30lx(), random);
  const LaserScan with = scan(corridor_world_with("D1"), T_map_robot, hokuyo_utm30lx(), same);
  int changed = 0;
  for (std::size_t i = 0; i < with.ranges.size(); ++i) changed += with.ranges[i] != without.ranges[i] ? 1 : 0;
  EXPECT_GT(changed, 30);
  EXPECT_LT(changed, 80);
}

TEST(Lidar, RefusesAModelThatCannotBe) {
  LidarModel lidar = hokuyo_utm30lx();
  lidar.beams = 2000;
  EXPECT_NE(lidar.problem(), "");
  Random random(1);
  EXPECT_THROW(scan({}, {}, lidar, random), Error);
  lidar = hokuyo_utm30lx();
  lidar.angle_increment = -0.01;
  EXPECT_NE(lidar.problem(), "");
  EXPECT_NE(hokuyo_utm30lx(-0.01).problem(), "");
}

TEST(Lidar, SeesFromWhereItIsAtEachBeamWhileItMoves) {
  const World world = corridor_world_with("C2");
  Random random(7);
  LidarModel lidar = hokuyo_utm30lx();
  lidar.beams = 271;
  lidar.angle_increment *= 4.0;
  std::vector<double> ranges;
  int hits = 0;
  for (int run = 0; run < 200; ++run) {
    // Fast, and now and then through a wall: then things are near.
    const Pose2 T_map_laser{random.uniform(0.5, 25.0), random.uniform(0.1, 2.4), random.uniform(-3.1, 3.1)};
    const double most = run % 2 == 0 ? 0.05 : 0.4;
    const Pose2 motion{random.uniform(-most, most), random.uniform(-most, most), random.uniform(-0.5, 0.5)};
    true_ranges(world, T_map_laser, motion, lidar, ranges);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const Pose2 there = T_map_laser * interpolate(motion, static_cast<double>(i) / 270.0);
      const double expected = brute_force(world, there, angle_of(lidar, i));
      if (std::isinf(expected) && std::isinf(ranges[i])) continue;
      ++hits;
      ASSERT_NEAR(ranges[i], expected, 1e-6) << "run " << run << ", beam " << i;
    }
  }
  EXPECT_GT(hits, 50000);
}

TEST(Lidar, AFullTurnWhileTurningSeesAllAround) {
  LidarModel lidar = hokuyo_utm30lx();
  lidar.beams = 720;
  lidar.angle_increment = 2.0 * std::numbers::pi / 720.0;
  std::vector<double> ranges;
  for (const double turned : {-0.8, 0.8}) {
    true_ranges(room(3.0, 2.0), {}, {0.0, 0.0, turned}, lidar, ranges);
    for (std::size_t i = 0; i < ranges.size(); ++i)
      ASSERT_NEAR(ranges[i],
                  brute_force(room(3.0, 2.0), {0.0, 0.0, turned * static_cast<double>(i) / 719.0}, angle_of(lidar, i)),
                  1e-9);
  }
}

TEST(Lidar, RefusesASweepThatNoRobotMakes) {
  std::vector<double> ranges;
  EXPECT_THROW(true_ranges(room(3.0, 2.0), {}, {2.0, 0.0, 0.0}, hokuyo_utm30lx(), ranges), Error);
  EXPECT_THROW(true_ranges(room(3.0, 2.0), {}, {0.0, 0.0, 3.0}, hokuyo_utm30lx(), ranges), Error);
}

TEST(Lidar, ARealOneSwingsLosesAndMixesReadings) {
  LidarModel lidar = hokuyo_utm30lx(0.0);
  Random random(1);
  const World world = with_cylinder(room(3.0, 2.0), {{1.5, 0.0}, 0.3});
  std::vector<double> truth;
  true_ranges(world, {}, lidar, truth);

  lidar.bias = 0.02;
  LaserScan seen = scan(world, {}, lidar, random);
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) worst = std::max(worst, std::abs(seen.ranges[i] - truth[i]));
  EXPECT_GT(worst, 0.015);
  EXPECT_LE(worst, 0.02 + 1e-6);

  lidar.bias = 0.0;
  lidar.dropouts = 0.1;
  seen = scan(world, {}, lidar, random);
  const auto lost = std::count(seen.ranges.begin(), seen.ranges.end(), 0.0F);
  EXPECT_NEAR(static_cast<double>(lost), 108.0, 40.0);

  lidar.dropouts = 0.0;
  lidar.mixed_pixels = 1.0;
  seen = scan(world, {}, lidar, random);
  std::size_t between = 0;
  for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
    const double reading = static_cast<double>(seen.ranges[i]);
    const auto [near, far] = std::minmax(truth[i], truth[i + 1]);
    if (far - near < 0.1) continue;
    EXPECT_GE(reading, near - 1e-6);
    EXPECT_LE(reading, far + 1e-6);
    between += reading > near + 1e-3 && reading < far - 1e-3;
  }
  EXPECT_EQ(between, 2U) << "both sides of the cylinder";
  EXPECT_EQ(real_hokuyo_utm30lx().problem(), "");
}

Person walker(const Point2& from, const Point2& to) {
  Person person;
  person.way = {from, to};
  person.speed = 1.4;
  return person;
}

/// The world with people frozen part of the way between two moments.
World frozen(World world, double first, double last, double share) {
  for (const Person& person : world.people) {
    const PersonOutline before = outline_at(person, first);
    const PersonOutline after = outline_at(person, last);
    for (std::size_t k = 0; k < before.count; ++k)
      world.pillars.push_back({before.centres[k] + share * (after.centres[k] - before.centres[k]), before.radius});
  }
  world.people.clear();
  return world;
}

TEST(Lidar, SeesPeopleWhereTheyAreAtEachBeam) {
  World world = corridor_world();
  world.people = {walker({6.0, 1.5}, {12.0, 1.0}), walker({9.0, 0.6}, {9.1, 2.0}), walker({16.0, 1.2}, {3.0, 1.2})};
  world.people.back().shape = PersonShape::body;
  LidarModel lidar = real_hokuyo_utm30lx();
  lidar.beams = 271;
  lidar.angle_increment *= 4.0;
  Random random(3);
  std::vector<double> ranges;
  std::vector<double> without;
  int on_people = 0;
  for (int run = 0; run < 100; ++run) {
    lidar.sweep_time = run % 3 == 0 ? 0.0 : run % 3 == 1 ? 0.025 : 0.2;
    const double stamp = random.uniform(0.0, 30.0);
    const Pose2 T_map_laser{random.uniform(6.0, 14.0), random.uniform(0.4, 2.1), random.uniform(-3.1, 3.1)};
    const Pose2 motion = run % 2 == 0 ? Pose2{} : Pose2{0.03, 0.01, random.uniform(-0.1, 0.1)};
    true_ranges(world, T_map_laser, motion, lidar, ranges, stamp);
    true_ranges(corridor_world(), T_map_laser, motion, lidar, without);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      on_people += ranges[i] < without[i];
      const double share = static_cast<double>(i) / 270.0;
      const World there = frozen(world, stamp, stamp + lidar.sweep_time, share);
      const double expected = brute_force(there, T_map_laser * interpolate(motion, share), angle_of(lidar, i));
      ASSERT_NEAR(ranges[i], expected, 1e-6) << "run " << run << ", beam " << i;
    }
  }
  EXPECT_GT(on_people, 500);
}

TEST(Lidar, ASweepIsStampedAndPeopleMoveBetweenSweeps) {
  World world = room(5.0, 5.0);
  world.people = {walker({2.0, -2.0}, {2.0, 2.0})};
  Random random(1);
  const LidarModel lidar = hokuyo_utm30lx(0.0);
  const LaserScan early = scan(world, {}, lidar, random, 1.0);
  const LaserScan later = scan(world, {}, lidar, random, 2.0);
  EXPECT_EQ(early.stamp, 1.0);
  EXPECT_EQ(later.stamp, 2.0);
  EXPECT_NE(early.ranges, later.ranges);
}

}  // namespace
}  // namespace slamicp::lidar_test
