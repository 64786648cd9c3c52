// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <limits>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>
#include <slamicp/mapping/mapper.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp::mapper_test {
namespace {

/// The reference route at few scans a second: the robot moves 10 cm between two.
SimulatedRun short_run(double range_noise = 0.01) {
  DriveOptions options;
  options.speed = 0.5;
  options.lidar = hokuyo_utm30lx(range_noise);
  options.lidar.rate = 5.0;
  const World world = corridor_world();
  return simulate_drive(world, route(world, "reference").waypoints, options);
}

/// A map of all points takes long.
SimulatedRun half_of(SimulatedRun run) {
  run.scans.resize(run.scans.size() / 2);
  run.truth.resize(run.scans.size());
  return run;
}

Mapper mapped(const SimulatedRun& run, MapperOptions options = {}) {
  options.initial_pose = run.truth.front().pose;
  Mapper mapper(options);
  for (const LaserScan& scan : run.scans) mapper.add(scan);
  return mapper;
}

double mean_distance_to_walls(const PointMap2& map) {
  const World world = corridor_world();
  double sum = 0.0;
  for (const Point2& point : map.points()) sum += distance_to_walls(world, point);
  return sum / static_cast<double>(map.size());
}

TEST(MapperTest, FollowsTheRobotAndKeepsAPoseForEveryScan) {
  const SimulatedRun run = short_run();
  const Mapper mapper = mapped(run);
  ASSERT_EQ(mapper.trajectory().size(), run.scans.size());
  EXPECT_EQ(mapper.unmatched(), 0);
  const TrajectoryError error = absolute_error(mapper.trajectory(), run.truth);
  EXPECT_LT(error.translation.mean, 0.03);
  EXPECT_LT(error.translation.max, 0.08);
}

TEST(MapperTest, GrowsByOutliersOnlyUnlessToldOtherwise) {
  const SimulatedRun run = half_of(short_run());
  const Mapper thin = mapped(run);
  const Mapper thick = mapped(run, {.update = MapUpdate::all_points});
  EXPECT_LT(5 * thin.map()->size(), thick.map()->size());
  EXPECT_GT(thin.keyframes(), 10);
}

TEST(MapperTest, AFinerInsertionDistanceMakesADenserMap) {
  const SimulatedRun run = short_run();
  EXPECT_GT(mapped(run, {.insertion_distance = 0.02}).map()->size(), mapped(run).map()->size());
}

TEST(MapperTest, TheRefinedMapIsNearerToTheWallsAndSmaller) {
  const Mapper mapper = mapped(short_run(0.02), {.insertion_distance = 0.03});
  const PointMap2::Pointer refined = mapper.refined_map();
  EXPECT_LT(refined->size(), mapper.map()->size());
  EXPECT_GT(2 * refined->size(), mapper.map()->size() / 2);
  EXPECT_LT(mean_distance_to_walls(*refined), 0.9 * mean_distance_to_walls(*mapper.map()));
}

double farthest_from_walls(const PointMap2& map) {
  const World world = corridor_world();
  double farthest = 0.0;
  for (const Point2& point : map.points()) farthest = std::max(farthest, distance_to_walls(world, point));
  return farthest;
}

TEST(MapperTest, ReadingsThatMixNearAndFarAreNotInTheRefinedMap) {
  DriveOptions options;
  options.speed = 0.5;
  options.lidar = hokuyo_utm30lx();
  options.lidar.mixed_pixels = 0.1;
  options.lidar.rate = 5.0;
  const World world = corridor_world();
  const Mapper mapper =
      mapped(simulate_drive(world, route(world, "reference").waypoints, options), {.insertion_distance = 0.02});
  EXPECT_GT(farthest_from_walls(*mapper.map()), 0.5) << "else there is nothing to leave out";
  EXPECT_LT(farthest_from_walls(*mapper.refined_map()), 0.25);
}

TEST(MapperTest, WhatNoScanCouldConfirmStaysInTheRefinedMap) {
  SimulatedRun run = short_run();
  run.scans.resize(1);
  const Mapper mapper = mapped(run);
  EXPECT_EQ(mapper.refined_map()->size(), mapper.map()->size());
}

TEST(MapperTest, AMapOfAllPointsIsNotRefined) {
  const Mapper mapper = mapped(half_of(short_run()), {.update = MapUpdate::all_points});
  EXPECT_EQ(mapper.refined_map(), mapper.map());
}

TEST(MapperTest, WithoutAPointThereIsNoMap) {
  Mapper mapper;
  EXPECT_EQ(mapper.map(), nullptr);
  EXPECT_EQ(mapper.refined_map(), nullptr);
  LaserScan nothing;
  nothing.ranges.assign(10, 0.0F);
  mapper.add(nothing);
  EXPECT_EQ(mapper.map(), nullptr);
  EXPECT_EQ(mapper.trajectory().size(), 1U);
}

TEST(MapperTest, TheFirstPoseFixesTheFrame) {
  const SimulatedRun run = short_run();
  MapperOptions options;
  options.initial_pose = {3.0, -2.0, 0.5};
  Mapper mapper(options);
  mapper.add(run.scans.front());
  EXPECT_LT(distance(mapper.trajectory().front().pose, options.initial_pose).translation, 1e-12);
}

TEST(MapperTest, PlacesAScanThatMatchesNothingByPrediction) {
  SimulatedRun run = short_run();
  Mapper mapper;
  mapper.add(run.scans[0]);
  LaserScan elsewhere = run.scans[1];
  elsewhere.T_odom_robot = *run.scans[0].T_odom_robot * Pose2{1000.0, 0.0, 0.0};
  const std::size_t before = mapper.map()->size();
  mapper.add(elsewhere);
  EXPECT_EQ(mapper.unmatched(), 1);
  EXPECT_GT(mapper.map()->size(), before);
  EXPECT_NEAR(mapper.trajectory().back().pose.x, 1000.0, 1e-6);
}

TEST(MapperTest, RefusesAbsurdOptions) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Mapper({.insertion_distance = 0.0}), Error);
  EXPECT_THROW(Mapper({.keyframe_distance = -1.0}), Error);
  EXPECT_THROW(Mapper({.keyframe_turn = nan}), Error);
  EXPECT_THROW(Mapper({.initial_pose = {nan, 0.0, 0.0}}), Error);
  EXPECT_THROW(Mapper({.max_correspondence_distance = -0.3}), Error);
  EXPECT_THROW(Mapper({.ranges = {5.0, 1.0}}), Error);
}

}  // namespace
}  // namespace slamicp::mapper_test
