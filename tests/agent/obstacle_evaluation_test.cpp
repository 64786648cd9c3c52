// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/agent/obstacle_evaluation.hpp>
#include <slamicp/simulation/corridor_world.hpp>

#include "support/random.hpp"

namespace slamicp::obstacle_evaluation_test {
namespace {

const SplinePath& path() {
  static const SplinePath it(route(corridor_world(), "reference").waypoints);
  return it;
}

/// A fix on the path, and one obstacle of many points about a place beside it.
struct Scene {
  Fix fix;
  Obstacle obstacle;
};

Scene scene(double travelled, const Point2& place, double size, test::Random& random) {
  Scene made;
  made.fix.match.stop = Stop::converged;
  made.fix.pose = path().at(travelled) * Pose2{0.0, 0.02, 0.1};
  made.obstacle.box = {place, 2.0 * size, 2.0 * size, 0.0};
  for (int k = 0; k < 60; ++k) {
    // Along the thing, as a laser sees it, and noise.
    const Point2 in_map = place + Point2(size * std::cos(0.05 * k), size * std::sin(0.05 * k)) + random.point<2>(0.01);
    made.obstacle.points.push_back(static_cast<int>(made.fix.scan.in_robot.size()));
    made.fix.scan.in_robot.push_back(made.fix.pose.inverse() * in_map);
  }
  return made;
}

TEST(ObstacleEvaluation, SaysOfEachWhatHoldingEveryPointAgainstThePathSays) {
  test::Random random(1);
  const ObstacleEvaluationOptions options;
  ObstacleEvaluation evaluation(options);
  int on_the_way = 0;
  for (int k = 0; k < 100; ++k) {
    const double travelled = random.uniform(0.0, path().length() - 2.5);
    const double ahead = random.uniform(0.4, 1.4);
    const Point2 place = path().at(travelled + ahead) * Point2(0.0, random.uniform(-0.9, 0.9));
    const Scene made = scene(travelled, place, random.uniform(0.03, 0.3), random);
    evaluation.update(path(), travelled, made.fix, {&made.obstacle, 1});
    ASSERT_EQ(evaluation.obstacles().size(), 1U);
    const EvaluatedObstacle& it = evaluation.obstacles()[0];
    EXPECT_EQ(it.obstacle.points, made.obstacle.points);

    double nearest_ahead = 1e9;
    double least_aside = 1e9;
    for (const Point2& in_robot : made.fix.scan.in_robot) {
      const Point2 in_map = made.fix.pose * in_robot;
      const PathPlace beside = path().nearest(in_map, travelled, travelled + 2.0);
      const double aside = (path().at(beside.distance).translation() - in_map).norm();
      least_aside = std::min(least_aside, aside);
      if (aside < options.corridor_half_width) nearest_ahead = std::min(nearest_ahead, beside.distance - travelled);
    }
    EXPECT_NEAR(std::abs(it.cross_track), least_aside, 2e-3);
    if (std::abs(least_aside - options.corridor_half_width) < 0.02) continue;  // a point may fall on either side
    EXPECT_EQ(std::isfinite(it.ahead), nearest_ahead < 1e9);
    if (nearest_ahead > 1e8) continue;
    ++on_the_way;
    EXPECT_NEAR(it.ahead, nearest_ahead, 0.08);
  }
  EXPECT_GT(on_the_way, 20);
}

TEST(ObstacleEvaluation, KeepsNothingOfTheScanBefore) {
  test::Random random(2);
  ObstacleEvaluation evaluation({.confirmations = 1, .releases = 1});
  const Scene near = scene(3.0, path().at(3.4).translation(), 0.1, random);
  evaluation.update(path(), 3.0, near.fix, {&near.obstacle, 1});
  EXPECT_EQ(evaluation.decision(), Decision::stop);
  EXPECT_EQ(evaluation.speed_limit(), 0.0);
  evaluation.update(path(), 3.0, near.fix, {});
  EXPECT_TRUE(evaluation.obstacles().empty());
  EXPECT_EQ(evaluation.decision(), Decision::ignore);
  const Scene far = scene(3.0, path().at(12.0).translation(), 0.1, random);
  evaluation.update(path(), 3.0, far.fix, {&far.obstacle, 1});
  EXPECT_EQ(evaluation.obstacles()[0].decision, Decision::ignore);
  EXPECT_TRUE(std::isinf(evaluation.obstacles()[0].ahead));
}

/// A fix that can be used, on the path.
Fix good_fix(double travelled, double stamp) {
  Fix fix;
  fix.stamp = stamp;
  fix.pose = path().at(travelled);
  fix.match.stop = Stop::converged;
  return fix;
}

Track walker(const Point2& position, const Vector<2>& velocity) {
  Track track;
  track.id = 7;
  track.kind = TrackKind::person;
  track.motion = TrackMotion::moving;
  track.state = TrackState::confirmed;
  track.position = position;
  track.velocity = velocity;
  track.width = 0.4;
  return track;
}

TEST(ObstacleEvaluation, WhoWillCrossTheWayHoldsTheRobotBackBeforeTheyAreOnIt) {
  ObstacleEvaluation evaluation;
  const Pose2 ahead = path().at(3.9);
  const double speed = 0.4;
  const auto decide = [&](double aside, double velocity) {
    ObstacleEvaluation fresh;
    const Vector<2> to_the_right = ahead.rotation() * Vector<2>(0.0, velocity);
    const Track track = walker(ahead * Point2(0.0, aside), to_the_right);
    fresh.update(path(), 3.0, good_fix(3.0, 1.0), {}, {&track, 1}, speed);
    return fresh.decision();
  };
  EXPECT_EQ(decide(3.0, -1.2), Decision::slow) << "there in two seconds, as the robot is";
  EXPECT_EQ(decide(3.0, 1.2), Decision::ignore) << "they walk away";
  EXPECT_EQ(decide(8.0, -1.2), Decision::ignore) << "they come later";
  const Track near = walker(path().at(3.0) * Point2(0.0, 1.3), path().at(3.0).rotation() * Vector<2>(0.0, -1.2));
  evaluation.update(path(), 3.0, good_fix(3.0, 1.0), {}, {&near, 1}, speed);
  EXPECT_EQ(evaluation.decision(), Decision::stop) << "at the robot itself in less than a second, at once";
  EXPECT_EQ(evaluation.speed_limit(), 0.0);
}

TEST(ObstacleEvaluation, OnlyConfirmedTracksThatMoveAreThoughtAhead) {
  Track track = walker(path().at(3.0) * Point2(0.0, 1.3), path().at(3.0).rotation() * Vector<2>(0.0, -1.2));
  track.state = TrackState::tentative;
  ObstacleEvaluation evaluation;
  evaluation.update(path(), 3.0, good_fix(3.0, 1.0), {}, {&track, 1}, 0.4);
  EXPECT_EQ(evaluation.decision(), Decision::ignore);
  track.state = TrackState::confirmed;
  track.motion = TrackMotion::still;
  evaluation.update(path(), 3.0, good_fix(3.0, 1.1), {}, {&track, 1}, 0.4);
  EXPECT_EQ(evaluation.decision(), Decision::ignore);
}

TEST(ObstacleEvaluation, BlindLostOrLateItStops) {
  ObstacleEvaluation evaluation({.confirmations = 1, .releases = 2});
  EXPECT_EQ(evaluation.decision_at(0.0), Decision::stop) << "no scan yet";
  evaluation.update(path(), 3.0, good_fix(3.0, 1.0), {});
  EXPECT_EQ(evaluation.decision_at(1.2), Decision::ignore);
  EXPECT_EQ(evaluation.decision_at(1.6), Decision::stop) << "the next scan is late";
  Fix fix = good_fix(3.0, 1.1);
  fix.match.stop = Stop::no_overlap;
  evaluation.update(path(), 3.0, fix, {});
  EXPECT_EQ(evaluation.decision(), Decision::stop);
  evaluation.update(path(), 3.0, good_fix(3.0, 1.2), {});
  EXPECT_EQ(evaluation.decision(), Decision::stop) << "one clear scan is not enough";
  evaluation.update(path(), 3.0, good_fix(3.0, 1.3), {});
  EXPECT_EQ(evaluation.decision(), Decision::ignore);
  fix = good_fix(3.0, 1.4);
  fix.quality.state = TrackingState::lost;
  evaluation.update(path(), 3.0, fix, {});
  EXPECT_EQ(evaluation.decision(), Decision::stop);
  EXPECT_EQ(evaluation.speed_limit(), 0.0);
}

TEST(ObstacleEvaluation, WhatIsInAnExclusionZoneCountsForNothing) {
  test::Random random(3);
  const Scene near = scene(3.0, path().at(3.4).translation(), 0.1, random);
  const auto decision_with = [&](const ExclusionZone& zone) {
    ObstacleEvaluationOptions options{.confirmations = 1};
    options.exclusion_zones = {zone};
    ObstacleEvaluation evaluation(options);
    Fix fix = near.fix;
    fix.match.stop = Stop::converged;
    const Track track = walker(near.obstacle.box.centre, {0.1, 0.0});
    evaluation.update(path(), 3.0, fix, {&near.obstacle, 1}, {&track, 1}, 0.3);
    return evaluation.decision();
  };
  const std::vector<Point2> before_the_robot = {{0.1, -0.4}, {0.8, -0.4}, {0.8, 0.4}, {0.1, 0.4}};
  EXPECT_EQ(decision_with({before_the_robot, true}), Decision::ignore);
  std::vector<Point2> behind = before_the_robot;
  for (Point2& corner : behind) corner = -corner;
  EXPECT_EQ(decision_with({behind, true}), Decision::stop);
  std::vector<Point2> in_map;
  for (const Point2& corner : before_the_robot) in_map.push_back(near.fix.pose * corner);
  EXPECT_EQ(decision_with({in_map, false}), Decision::ignore);
  EXPECT_FALSE((ObstacleEvaluationOptions{.exclusion_zones = {{{{0.0, 0.0}}, true}}}).problem().empty());
}

}  // namespace
}  // namespace slamicp::obstacle_evaluation_test
