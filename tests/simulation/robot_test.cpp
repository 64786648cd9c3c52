// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/simulation/robot.hpp>

namespace slamicp::robot_test {
namespace {

TEST(SimulatedRobotTest, AnIdealOneDoesAsItIsToldAfterTheDelay) {
  OmniRobotModel ideal;
  ideal.encoder_noise = 0.0;
  SimulatedRobot robot(ideal, {1.0, 2.0, 0.5}, 1);
  robot.command(0.0, {0.3, 0.1, 0.4});
  robot.advance(0.05);
  EXPECT_LT(distance(robot.pose(), {1.0, 2.0, 0.5}).translation, 1e-12);
  robot.advance(1.05);
  const Pose2 expected = Pose2{1.0, 2.0, 0.5} * Pose2::exp({0.3, 0.1, 0.4});
  EXPECT_LT(distance(robot.pose(), expected).translation, 1e-9);
  EXPECT_LT(distance(robot.odometry(), Pose2::exp({0.3, 0.1, 0.4})).translation, 1e-9);
  EXPECT_NEAR(robot.velocity()[2], 0.4, 1e-9);
}

TEST(SimulatedRobotTest, SlipLosesWayThatItsEncodersDoNotSee) {
  OmniRobotModel model;
  model.slip = 0.05;
  SimulatedRobot robot(model, {}, 1);
  robot.command(0.0, {0.5, 0.0, 0.0});
  robot.advance(20.05);
  EXPECT_NEAR(robot.odometry().translation().norm(), 10.0, 0.1);
  EXPECT_LT(robot.pose().translation().norm(), 9.9);
  EXPECT_GT(robot.pose().translation().norm(), 9.0);
}

TEST(SimulatedRobotTest, TheSameSeedIsTheSameDrive) {
  const auto drive = [](std::uint64_t seed) {
    SimulatedRobot robot(apr02(), {}, seed);
    for (int k = 0; k < 40; ++k) {
      robot.command(0.025 * k, {0.3, 0.0, 0.2});
      robot.advance(0.025 * (k + 1));
    }
    return robot.pose();
  };
  EXPECT_EQ(drive(1).x, drive(1).x);
  EXPECT_EQ(drive(1).theta, drive(1).theta);
  EXPECT_NE(drive(1).x, drive(2).x);
}

TEST(SimulatedRobotTest, RefusesAbsurdModels) {
  OmniRobotModel model;
  model.slip = 0.7;
  EXPECT_THROW(SimulatedRobot(model, {}, 1), Error);
  model = {};
  model.radius_errors[1] = NAN;
  EXPECT_THROW(SimulatedRobot(model, {}, 1), Error);
}

}  // namespace
}  // namespace slamicp::robot_test
