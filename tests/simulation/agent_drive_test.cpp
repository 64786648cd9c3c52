// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/simulation/agent_drive.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp::agent_drive_test {
namespace {

PointMap2::Pointer site_map() {
  static const PointMap2::Pointer map = [] {
    Random random(1);
    return PointMap2::create(sample_map(corridor_world(), random));
  }();
  return map;
}

std::shared_ptr<const SplinePath> reference() {
  static const auto path = std::make_shared<const SplinePath>(route(corridor_world(), "reference").waypoints);
  return path;
}

TEST(AgentDriveTest, DrivesTheReferencePathWithARealLidarOnSlippingWheels) {
  AgentDriveOptions options;
  options.agent.tracking.speed = 0.55;
  double squares = 0.0;
  std::size_t cycles = 0;
  int held_back = 0;
  const AgentDriveResult drove =
      drive_agent(corridor_world(), site_map(), reference(), options, [&](const DriveMoment& now) {
        const double place = now.cycle.tracking.travelled;
        const PathPlace really = reference()->nearest(now.T_map_robot.translation(), place - 0.5, place + 0.5);
        squares += really.cross_track * really.cross_track;
        ++cycles;
        held_back += now.cycle.decision != Decision::ignore;
        return true;
      });
  EXPECT_TRUE(drove.finished);
  EXPECT_LT(drove.seconds, 1.3 * reference()->length() / 0.55);
  EXPECT_LE(std::sqrt(squares / static_cast<double>(cycles)), 0.015);
  EXPECT_EQ(held_back, 0);
}

TEST(AgentDriveTest, PassesThePapersObstaclesWithoutAStopAndSeesThem) {
  AgentDriveOptions options;
  options.start = 4.0;
  options.most_seconds = 12.0;
  std::size_t seen = 0;
  drive_agent(corridor_world_with("A2"), site_map(), reference(), options, [&](const DriveMoment& now) {
    seen = std::max(seen, now.cycle.obstacles.size());
    EXPECT_NE(now.cycle.decision, Decision::stop);
    return true;
  });
  EXPECT_GE(seen, 1U);
}

TEST(AgentDriveTest, TheSameSeedIsTheSameDrive) {
  const auto ends = [](std::uint64_t seed) {
    AgentDriveOptions options;
    options.seed = seed;
    options.most_seconds = 2.0;
    Pose2 end;
    drive_agent(corridor_world(), site_map(), reference(), options, [&](const DriveMoment& now) {
      end = now.T_map_robot;
      return true;
    });
    return end;
  };
  EXPECT_EQ(ends(1).x, ends(1).x);
  EXPECT_EQ(ends(1).theta, ends(1).theta);
  EXPECT_NE(ends(1).x, ends(2).x);
}

TEST(AgentDriveTest, EndsWhenTold) {
  int cycles = 0;
  const auto until_ten = [&](const DriveMoment&) { return ++cycles < 10; };
  EXPECT_FALSE(drive_agent(corridor_world(), site_map(), reference(), {}, until_ten).finished);
  EXPECT_EQ(cycles, 10);
}

TEST(AgentDriveTest, RefusesAbsurdOptions) {
  AgentDriveOptions options;
  options.lidar.sweep_time = 0.1;
  const auto never = [](const DriveMoment&) { return false; };
  EXPECT_THROW(drive_agent(corridor_world(), site_map(), reference(), options, never), Error);
  EXPECT_THROW(drive_agent(corridor_world(), site_map(), nullptr, {}, never), Error);
}

}  // namespace
}  // namespace slamicp::agent_drive_test
