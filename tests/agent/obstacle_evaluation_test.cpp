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

}  // namespace
}  // namespace slamicp::obstacle_evaluation_test
