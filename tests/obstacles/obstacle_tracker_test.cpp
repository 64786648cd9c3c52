// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/obstacle_tracker.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "support/random.hpp"

namespace slamicp::obstacle_tracker_test {
namespace {

/// A hall of 12 m x 8 m.
World hall() {
  World world;
  world.name = "hall";
  const Point2 corners[] = {{0.0, 0.0}, {12.0, 0.0}, {12.0, 8.0}, {0.0, 8.0}};
  for (std::size_t k = 0; k < 4; ++k) world.walls.push_back({corners[k], corners[(k + 1) % 4]});
  world.pillars.push_back({{9.0, 6.5}, 0.3});
  return world;
}

Person walker(const Point2& from, const Point2& to) {
  Person person;
  person.name = "walker";
  person.way = {from, to};
  return person;
}

/// A robot in a world, and what it makes of it.
struct Watch {
  explicit Watch(World given, const ObstacleTrackerOptions& options = {})
      : world(std::move(given)), random(1), localizer(map_of(world)), tracker(options) {}

  static PointMap2::Pointer map_of(World world) {
    Random random(7);
    world.people.clear();
    world.obstacles.clear();
    return PointMap2::create(sample_map(world, random));
  }

  /// One scan from there.
  std::span<const Track> look(const Pose2& T_map_robot) {
    const LaserScan seen = scan(world, T_map_robot, lidar, random, stamp);
    if (stamp == 0.0) localizer.set_pose(T_map_robot);
    const Fix& fix = localizer.update(seen);
    obstacles = finder.find(fix, seen);
    stamp += 1.0 / lidar.rate;
    return tracker.update(fix, seen, obstacles);
  }

  World world;
  Random random;
  LidarModel lidar = hokuyo_utm30lx();
  Localizer localizer;
  ObstacleFinder finder;
  ObstacleTracker tracker;
  std::span<const Obstacle> obstacles;
  double stamp = 0.0;
};

const Pose2 here{2.0, 4.0, 0.0};

TEST(ObstacleTracker, WhoWalksIsOnePersonWithOneIdAndTheirSpeed) {
  World world = hall();
  world.people = {walker({4.5, 1.5}, {4.5, 6.5})};
  Watch watch(world);
  int id = 0;
  double decided = -1.0;
  while (watch.stamp < 3.5) {
    const double now = watch.stamp;
    const Track* person = nullptr;
    for (const Track& track : watch.look(here))
      if (track.kind == TrackKind::person && track.state == TrackState::confirmed) person = &track;
    if (person == nullptr) {
      EXPECT_LT(decided, 0.0) << "lost at " << now;
      continue;
    }
    if (decided < 0.0) decided = now;
    if (id == 0) id = person->id;
    EXPECT_EQ(person->id, id);
    const Pose2 truth = pose_at(world.people[0], now);
    EXPECT_LT((person->position - truth.translation()).norm(), 0.3);
    if (now > decided + 0.7) {
      EXPECT_NEAR(person->speed(), 1.2, 0.5);
    }
    EXPECT_EQ(person->motion, TrackMotion::moving);
  }
  EXPECT_GT(decided, 0.0);
  EXPECT_LT(decided, 1.0);
}

TEST(ObstacleTracker, AWallOfBoxesThatTheRobotDrivesRoundNeverMoves) {
  World world = hall();
  world = with_box(world, {{6.0, 4.0}, 1.2, 0.6, 0.4});
  world = with_cylinder(world, {{4.0, 6.0}, 0.042});
  Watch watch(world);
  for (int k = 0; k < 800; ++k) {
    const double angle = 0.25 * watch.stamp;
    const Pose2 pose{6.0 - 3.0 * std::cos(angle), 4.0 - 2.5 * std::sin(angle), 0.3 * std::sin(2.0 * angle)};
    for (const Track& track : watch.look(pose)) {
      EXPECT_NE(track.motion, TrackMotion::moving) << track.brief() << " at " << watch.stamp;
      EXPECT_EQ(track.velocity, Vector<2>(0.0, 0.0));
    }
  }
  const auto tracks = watch.tracker.tracks();
  EXPECT_TRUE(
      std::any_of(tracks.begin(), tracks.end(), [](const Track& track) { return track.motion == TrackMotion::still; }));
}

TEST(ObstacleTracker, WhatComesIntoViewPieceByPieceNeverMoves) {
  World world = hall();
  world = with_box(world, {{5.0, 4.0}, 0.8, 0.3, 0.0});  // hides what stands behind it
  for (const double across : {3.0, 4.0, 5.0}) world = with_box(world, {{7.5, across}, 0.2, 0.55, 0.0});
  Watch watch(world);
  watch.lidar.rate = 7.5;
  while (watch.stamp < 8.0) {
    const Pose2 pose{2.0 + 0.1 * watch.stamp, 2.0 + 0.5 * watch.stamp, 0.4 * std::sin(watch.stamp)};
    for (const Track& track : watch.look(pose)) {
      EXPECT_EQ(track.kind, TrackKind::thing) << track.brief() << " at " << watch.stamp;
      EXPECT_NE(track.motion, TrackMotion::moving) << track.brief() << " at " << watch.stamp;
    }
  }
}

TEST(ObstacleTracker, WhoIsHiddenForAWhileIsTheSameAfterwards) {
  World world = hall();
  world = with_box(world, {{4.0, 4.0}, 0.1, 0.8, 0.0});  // they pass behind it
  world.people = {walker({5.5, 1.5}, {5.5, 6.5})};
  Watch watch(world);
  int before = 0, after = 0;
  bool was_hidden = false;
  while (watch.stamp < 3.9) {
    for (const Track& track : watch.look(here)) {
      if (track.kind != TrackKind::person) continue;
      const double y = track.position.y();
      if (track.state == TrackState::hidden) was_hidden = true;
      if (track.state == TrackState::confirmed && y < 2.9) before = track.id;
      if (track.state == TrackState::confirmed && y > 5.1) after = track.id;
    }
  }
  EXPECT_TRUE(was_hidden);
  EXPECT_NE(before, 0);
  EXPECT_EQ(before, after);
}

TEST(ObstacleTracker, ASingleScanIsNotBelieved) {
  World world = with_box(hall(), {{5.0, 4.0}, 0.4, 0.4, 0.0});
  Watch watch(world);
  const auto first = watch.look(here);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].state, TrackState::tentative);
  EXPECT_STREQ(word_of(first[0]), "tentative");
  watch.world.obstacles.clear();
  for (int k = 0; k < 3; ++k) watch.look(here);
  EXPECT_TRUE(watch.tracker.tracks().empty());
}

TEST(ObstacleTracker, WhatWasTakenAwayIsForgottenAndItsIdNotUsedAgain) {
  World world = with_box(hall(), {{5.0, 4.0}, 0.4, 0.4, 0.0});
  Watch watch(world);
  for (int k = 0; k < 40; ++k) watch.look(here);
  ASSERT_EQ(watch.tracker.tracks().size(), 1U);
  const int id = watch.tracker.tracks()[0].id;
  watch.world.obstacles.clear();
  for (int k = 0; k < 20; ++k) watch.look(here);
  EXPECT_TRUE(watch.tracker.tracks().empty());
  watch.world = world;
  for (int k = 0; k < 10; ++k) watch.look(here);
  ASSERT_EQ(watch.tracker.tracks().size(), 1U);
  EXPECT_GT(watch.tracker.tracks()[0].id, id);
}

TEST(ObstacleTracker, TheFixesUncertaintyGoesIntoThePositions) {
  World world = with_box(hall(), {{5.0, 4.0}, 0.4, 0.4, 0.0});
  Watch watch(world);
  const LaserScan seen = scan(world, here, watch.lidar, watch.random);
  watch.localizer.set_pose(here);
  Fix fix = watch.localizer.update(seen);
  const auto variance = [&](double turn) {
    fix.covariance.setZero();
    fix.covariance(2, 2) = turn * turn;
    ObstacleTracker tracker;
    const auto obstacles = watch.finder.find(fix, seen);
    return Matrix<2, 2>(tracker.update(fix, seen, obstacles)[0].covariance.topLeftCorner<2, 2>());
  };
  const Matrix<2, 2> more = variance(0.02) - variance(0.0);
  constexpr double lever = 2.8;  // ahead: the near side of the box [m]
  EXPECT_NEAR(std::sqrt(more(1, 1)), 0.02 * lever, 0.004) << "across the line of sight";
  EXPECT_LT(std::sqrt(std::abs(more(0, 0))), 0.004) << "not along it";
}

TEST(ObstacleTracker, AStampThatDoesNotRiseAndALostFixChangeNothing) {
  World world = with_box(hall(), {{5.0, 4.0}, 0.4, 0.4, 0.0});
  Watch watch(world);
  for (int k = 0; k < 10; ++k) watch.look(here);
  LaserScan seen = scan(world, here, watch.lidar, watch.random, watch.stamp);
  Fix fix = watch.localizer.update(seen);
  const auto obstacles = watch.finder.find(fix, seen);
  const Track before = watch.tracker.tracks()[0];
  fix.stamp = watch.stamp - 0.2;
  EXPECT_EQ(watch.tracker.update(fix, seen, obstacles)[0].scans, before.scans);
  fix.stamp = watch.stamp;
  fix.quality.state = TrackingState::lost;
  const auto after = watch.tracker.update(fix, seen, obstacles);
  ASSERT_EQ(after.size(), 1U) << "nothing is placed by a lost fix";
  EXPECT_EQ(after[0].state, TrackState::hidden);
  EXPECT_EQ(after[0].scans, before.scans);
}

TEST(ObstacleTracker, AbsurdOptionsAreRefused) {
  const ObstacleTrackerOptions absurd[] = {
      {.confirmations = 0},     {.confirm_within = 0.0}, {.patience = 0.0},
      {.hidden_patience = 0.1}, {.settle = 0.0},         {.least_motion = test::nan},
      {.agility = 0.0},         {.gate = -1.0},          {.most_tracks = 0}};
  for (const ObstacleTrackerOptions& options : absurd) {
    EXPECT_FALSE(options.problem().empty());
    EXPECT_THROW(ObstacleTracker{options}, Error);
  }
  EXPECT_TRUE(ObstacleTrackerOptions{}.problem().empty());
}

}  // namespace
}  // namespace slamicp::obstacle_tracker_test
