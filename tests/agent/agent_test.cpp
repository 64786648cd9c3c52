// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/agent/agent.hpp>
#include <slamicp/error.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>
#include <slamicp/simulation/robot.hpp>

namespace slamicp::agent_test {
namespace {

constexpr double period = 0.025;

struct Site {
  World world = corridor_world();
  LidarModel lidar = hokuyo_utm30lx();
  PointMap2::Pointer map;
  std::shared_ptr<const SplinePath> path;

  Site() {
    Random random(1);
    map = PointMap2::create(sample_map(world, random));
    path = std::make_shared<const SplinePath>(route(world, "reference").waypoints);
  }
};

const Site& site() {
  static const Site it;
  return it;
}

struct Drive {
  int cycles = 0;
  int stops = 0;
  double worst_cross_track = 0.0;
  bool finished = false;
  Pose2 end;
};

/// Drives on from a place of the path until the end, or for so many cycles.
Drive drive(const World& world, Agent& agent, double from, int cycles) {
  SimulatedRobot robot(apr02(), site().path->at(from), 3);
  agent.set_pose(robot.pose());
  Random random(4);
  Drive result;
  for (; result.cycles < cycles; ++result.cycles) {
    const double stamp = result.cycles * period;
    LaserScan seen = scan(world, robot.pose(), site().lidar, random);
    seen.stamp = stamp;
    seen.T_odom_robot = robot.odometry();
    const Cycle& cycle = agent.step(seen);
    EXPECT_TRUE(cycle.fix->usable()) << cycle.fix->brief();
    result.stops += cycle.decision == Decision::stop;
    const PathPlace place = site().path->nearest(robot.pose().translation(), 0.0, site().path->length());
    result.worst_cross_track = std::max(result.worst_cross_track, std::abs(place.cross_track));
    result.finished = cycle.tracking.finished;
    if (result.finished) break;
    robot.command(stamp, cycle.tracking.command);
    robot.advance(stamp + period);
  }
  result.end = robot.pose();
  return result;
}

TEST(AgentTest, DrivesTheReferencePathByItsLaser) {
  Agent agent(site().map, site().path, {.tracking = {.speed = 0.55}});
  const Drive drove = drive(site().world, agent, 0.0, 4000);
  EXPECT_TRUE(drove.finished);
  EXPECT_EQ(drove.stops, 0);
  EXPECT_LT(drove.worst_cross_track, 0.05);
}

TEST(AgentTest, StopsBeforeWhatStandsInItsWay) {
  const Pose2 there = site().path->at(9.0);
  const World world = with_cylinder(site().world, {there.translation(), 0.12});
  Agent agent(site().map, site().path);
  const Drive drove = drive(world, agent, 6.0, 800);
  EXPECT_FALSE(drove.finished);
  EXPECT_GT(drove.stops, 100);
  const double left = (there.translation() - drove.end.translation()).norm() - 0.12;
  EXPECT_GT(left, 0.4);
  EXPECT_LT(left, 0.7);
}

TEST(AgentTest, GoesOnOnceTheWayIsClear) {
  Agent agent(site().map, site().path);
  SimulatedRobot robot(apr02(), site().path->at(6.0), 3);
  agent.set_pose(robot.pose());
  Random random(4);
  const World blocked = with_cylinder(site().world, {site().path->at(7.0).translation(), 0.12});
  double travelled = 0.0;
  for (int k = 0; k < 600; ++k) {
    LaserScan seen = scan(k < 200 ? blocked : site().world, robot.pose(), site().lidar, random);
    seen.stamp = k * period;
    seen.T_odom_robot = robot.odometry();
    const Cycle& cycle = agent.step(seen);
    travelled = cycle.tracking.travelled;
    if (k == 199) {
      EXPECT_EQ(cycle.decision, Decision::stop);
      EXPECT_LT(travelled, 6.5);
    }
    robot.command(seen.stamp, cycle.tracking.command);
    robot.advance(seen.stamp + period);
  }
  EXPECT_GT(travelled, 8.0);
}

TEST(AgentTest, BothFormsFindTheSameObstacles) {
  const World world = corridor_world_with("A2");
  AgentOptions original{.form = AgentForm::original};
  AgentOptions improved;
  improved.localization.outputs.strays = false;  // by the outlier distance, as the original one has it
  Agent ours(site().map, site().path, improved);
  Agent theirs(site().map, site().path, original);
  Random random(5);
  int seen_by_both = 0;
  for (const double at : {6.0, 6.02, 6.04, 6.06}) {
    const Pose2 pose = site().path->at(at);
    ours.set_pose(pose);
    theirs.set_pose(pose);
    const LaserScan seen = scan(world, pose, site().lidar, random);
    const Cycle& a = ours.step(seen);
    const Cycle& b = theirs.step(seen);
    ASSERT_TRUE(b.fix->usable());
    EXPECT_LT(distance(a.fix->pose, b.fix->pose).translation, 0.05);
    ASSERT_EQ(a.obstacles.size(), b.obstacles.size());
    for (std::size_t k = 0; k < a.obstacles.size(); ++k) {
      EXPECT_LT((a.obstacles[k].obstacle.box.centre - b.obstacles[k].obstacle.box.centre).norm(), 0.1);
      ++seen_by_both;
    }
  }
  EXPECT_GE(seen_by_both, 4);
}

TEST(AgentTest, TimesComeFromTheClockThatItIsGiven) {
  double now = 0.0;
  Agent agent(site().map, site().path, {}, [&] { return now += 1.0; });
  agent.set_pose(site().path->at(0.0));
  Random random(5);
  const Cycle& cycle = agent.step(scan(site().world, site().path->at(0.0), site().lidar, random));
  EXPECT_EQ(cycle.times.localization, 1.0);
  EXPECT_EQ(cycle.times.total(), 4.0);
}

TEST(AgentTest, AScanThatShowsNothingStopsTheRobot) {
  Agent agent(site().map, site().path);
  agent.set_pose(site().path->at(2.0));
  Random random(5);
  for (int k = 0; k < 10; ++k) {
    LaserScan seen = scan(site().world, site().path->at(2.0), site().lidar, random);
    seen.stamp = k * period;
    agent.step(seen);
  }
  LaserScan nothing;
  nothing.stamp = 10 * period;
  const Cycle& cycle = agent.step(nothing);
  EXPECT_EQ(cycle.tracking.command.x, 0.0);
  EXPECT_EQ(cycle.tracking.command.turn, 0.0);
}

TEST(AgentTest, RefusesAbsurdOptions) {
  EXPECT_THROW(Agent(nullptr, site().path), Error);
  EXPECT_THROW(Agent(site().map, nullptr), Error);
  EXPECT_THROW(Agent(site().map, site().path, {.evaluation = {.confirmations = 0}}), Error);
  EXPECT_THROW(ObstacleEvaluation({.slow_distance = 0.1}), Error);
}

}  // namespace
}  // namespace slamicp::agent_test
