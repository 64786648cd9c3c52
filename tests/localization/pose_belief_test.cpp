// SPDX-License-Identifier: Apache-2.0
#include "localization/pose_belief.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace slamicp::pose_belief_test {
namespace {

Eigen::Matrix3d diagonal(double x, double y, double theta) {
  return Eigen::Vector3d(x * x, y * y, theta * theta).asDiagonal();
}

/// A match with so much white and so much systematic error in every direction.
Uncertainty match_with(double white, double systematic) {
  Uncertainty match;
  match.known = true;
  match.systematic = diagonal(systematic, systematic, 0.2 * systematic);
  match.covariance = diagonal(white, white, 0.2 * white) + Eigen::Matrix3d(match.systematic);
  match.information = Eigen::Matrix3d(match.covariance).inverse();
  return match;
}

/// The same, blind ahead.
Uncertainty blind_match(double white) {
  Uncertainty match = match_with(white, 0.0);
  match.blind = true;
  match.information.row(0).setZero();
  match.information.col(0).setZero();
  match.unheld(0, 0) = Uncertainty::unheld_variance;
  match.covariance(0, 0) = Uncertainty::unheld_variance;
  return match;
}

double sigma(const PoseBelief& belief, int k) { return std::sqrt(belief.covariance()(k, k)); }

TEST(PoseBeliefTest, ARobotAtRestIsNoSurerThanAScansSystematicPart) {
  PoseBelief belief{PredictionNoise{}};
  belief.forget(0.1, 0.1);
  for (int k = 0; k < 500; ++k) {
    belief.move_by_odometry({});
    belief.fuse(match_with(0.001, 0.002), belief.prior({}), 0.7);
  }
  EXPECT_GT(sigma(belief, 0), 0.002 * 0.999);
  EXPECT_LT(sigma(belief, 0), std::sqrt(0.002 * 0.002 + 0.001 * 0.001 + 0.001 * 0.001)) << "and surer than one scan is";
}

TEST(PoseBeliefTest, WhiteNoiseAveragesOut) {
  PoseBelief belief{PredictionNoise{.least_translation = 1e-9, .least_rotation = 1e-9}};
  belief.forget(0.1, 0.1);
  for (int k = 0; k < 100; ++k) {
    belief.move_by_odometry({});
    belief.fuse(match_with(0.001, 0.0), belief.prior({}), 0.0);
  }
  EXPECT_NEAR(sigma(belief, 0), 0.0001, 1e-6);
}

TEST(PoseBeliefTest, ABlindDirectionGrowsWithTheWayAsOdometrysScaleDoes) {
  PoseBelief belief{PredictionNoise{.odometry = {0.0, 0.0, 0.0, 0.0}, .odometry_scale = 0.02}};
  belief.forget(0.001, 0.001);
  for (int k = 0; k < 1000; ++k) {
    belief.move_by_odometry({0.1, 0.0, 0.0});
    belief.fuse(blind_match(0.001), belief.prior({}), 0.0);
  }
  EXPECT_NEAR(sigma(belief, 0), 0.02 * 100.0, 0.05);
  EXPECT_LT(sigma(belief, 1), 0.002);
  belief.fuse(match_with(0.001, 0.0), belief.prior({}), 0.0);
  EXPECT_LT(sigma(belief, 0), 0.002) << "until something is seen";
}

TEST(PoseBeliefTest, AMatchOfNothingTeachesNothing) {
  PoseBelief belief{PredictionNoise{}};
  belief.forget(0.1, 0.2);
  belief.fuse({}, belief.prior({}), 0.0);
  EXPECT_NEAR(sigma(belief, 0), 0.1, 1e-12);
  EXPECT_NEAR(sigma(belief, 2), 0.2, 1e-12);
}

TEST(PoseBeliefTest, OptionsAreChecked) {
  EXPECT_EQ(PredictionNoise{}.problem(), "");
  EXPECT_NE(PredictionNoise{.odometry_scale = -0.1}.problem(), "");
  EXPECT_NE(PredictionNoise{.least_translation = 0.0}.problem(), "");
  EXPECT_NE((PredictionNoise{.odometry = {.rotation_per_metre = -1.0}}).problem(), "");
}

}  // namespace
}  // namespace slamicp::pose_belief_test
