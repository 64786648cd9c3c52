// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/scan/odometry_model.hpp>

#include "support/random.hpp"

namespace slamicp::odometry_model_test {
namespace {

TEST(DifferentialDriveTest, GoesStraightAndTurnsOnTheSpot) {
  const DifferentialDrive drive{0.1, 0.1, 0.5};
  EXPECT_NEAR(drive.motion({10.0, 10.0}).x, 1.0, 1e-12);
  EXPECT_NEAR(drive.motion({-2.5, 2.5}).theta, 1.0, 1e-12);
  EXPECT_NEAR(drive.motion({-2.5, 2.5}).translation().norm(), 0.0, 1e-12);
  // A quarter of a circle of radius 1 to the left.
  const double quarter = test::pi / 2.0;
  const Pose2 arc = drive.motion({0.75 * quarter / 0.1, 1.25 * quarter / 0.1});
  EXPECT_NEAR(arc.x, 1.0, 1e-12);
  EXPECT_NEAR(arc.y, 1.0, 1e-12);
  EXPECT_NEAR(arc.theta, quarter, 1e-12);
}

TEST(DifferentialDriveTest, TurnsAreThoseOfTheMotion) {
  const DifferentialDrive drive{0.08, 0.11, 0.37};
  const auto turns = drive.turns(drive.motion({3.0, -1.0}));
  EXPECT_NEAR(turns[0], 3.0, 1e-12);
  EXPECT_NEAR(turns[1], -1.0, 1e-12);
}

TEST(OmniDriveTest, InverseAndForwardKinematicsAgree) {
  test::Random random(1);
  for (int run = 0; run < 100; ++run) {
    const OmniDrive drive{{random.uniform(0.05, 0.2), random.uniform(0.05, 0.2), random.uniform(0.05, 0.2)},
                          random.uniform(0.1, 0.5),
                          random.uniform(-3.0, 3.0)};
    const Pose2 motion = random.pose<2>(0.5, 1.0);
    const PoseDistance off = distance(drive.motion(drive.turns(motion)), motion);
    EXPECT_LT(off.translation, 1e-12);
    EXPECT_LT(off.rotation, 1e-12);
  }
}

TEST(OmniDriveTest, EqualTurnsSpinAndAWheelPushesAcrossItsArm) {
  const OmniDrive drive{{0.1, 0.1, 0.1}, 0.2, 0.0};
  const Pose2 spin = drive.motion({2.0, 2.0, 2.0});
  EXPECT_NEAR(spin.theta, 1.0, 1e-12);
  EXPECT_NEAR(spin.translation().norm(), 0.0, 1e-12);
  // The first wheel stands ahead and pushes to the left.
  const Pose2::Tangent twist = drive.motion({1.0, 0.0, 0.0}).log();
  EXPECT_NEAR(twist[0], 0.0, 1e-12);
  EXPECT_GT(twist[1], 0.0);
}

TEST(OdometryScaleTest, MendsWhatWheelsGetWrong) {
  const OdometryScale scale{1.1, 0.9, 0.02};
  const Pose2 straight = scale.motion({2.0, 0.0, 0.0});
  EXPECT_NEAR(straight.log()[0], 2.2, 1e-12);
  EXPECT_NEAR(straight.theta, 0.04, 1e-12);
  EXPECT_NEAR(scale.motion({0.0, 0.0, 1.0}).theta, 0.9, 1e-12);
  EXPECT_NEAR(OdometryScale{}.motion({1.0, 0.5, 0.3}).y, 0.5, 1e-12);
}

TEST(MotionNoiseTest, VarianceGrowsWithTheWayHoweverItIsCut) {
  const MotionNoise noise;
  const Matrix<3, 3> whole = noise.covariance({2.0, 0.0, 0.0});
  const Matrix<3, 3> half = noise.covariance({1.0, 0.0, 0.0});
  EXPECT_NEAR(whole(0, 0), 2.0 * half(0, 0), 1e-15);
  EXPECT_NEAR(half(0, 0), 0.03 * 0.03, 1e-15);
  EXPECT_NEAR(half(2, 2), 0.015 * 0.015, 1e-15);
  EXPECT_TRUE(noise.covariance({}).isZero());
}

TEST(OdometryModelTest, AbsurdModelsSayWhy) {
  EXPECT_NE((DifferentialDrive{0.0, 0.1, 0.4}.problem()), "");
  EXPECT_NE((DifferentialDrive{0.1, 0.1, -0.4}.problem()), "");
  EXPECT_NE((OmniDrive{{0.1, test::nan, 0.1}, 0.2, 0.0}.problem()), "");
  EXPECT_NE((OmniDrive{{0.1, 0.1, 0.1}, 0.0, 0.0}.problem()), "");
  EXPECT_NE((OdometryScale{0.0, 1.0, 0.0}.problem()), "");
  EXPECT_NE((MotionNoise{-1.0, 0.0, 0.0, 0.0}.problem()), "");
  EXPECT_EQ(DifferentialDrive{}.problem() + OmniDrive{}.problem() + OdometryScale{}.problem() + MotionNoise{}.problem(),
            "");
}

}  // namespace
}  // namespace slamicp::odometry_model_test
