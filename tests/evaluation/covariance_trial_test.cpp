// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/covariance_trial.hpp>
#include <slamicp/evaluation/trial_world.hpp>

namespace slamicp::covariance_trial_test {
namespace {

CovarianceScore score_of(std::string_view world, double unmapped, std::uint64_t maps) {
  CovarianceScore score;
  for (std::uint64_t seed = 1; seed <= maps; ++seed) {
    CovarianceTrials trials(world, seed);
    for (int k = 0; k < 10; ++k) score.add(trials.draw(unmapped));
  }
  return score;
}

// A reduced `scripts/measure honest --only calibration`: the mean NEES/3 of 100 runs is off by 0.08 (1 sigma) by
// chance.
TEST(CovarianceTrial, ACovarianceIsRightInAHall) {
  for (const double unmapped : {0.0, 0.3}) {
    const CovarianceScore score = score_of("hall", unmapped, 10);
    EXPECT_EQ(score.failed(), 0U);
    EXPECT_GT(score.nees(), 0.8);
    EXPECT_LT(score.nees(), 1.25);
    EXPECT_GE(score.inside(), 0.88);
    if (unmapped == 0.0) {
      EXPECT_LT(score.rmse(), 1.5 * score.bound());
    }
  }
}

TEST(CovarianceTrial, ABoundIsThatOfTheNoise) {
  const World hall = trial_world("hall");
  LidarModel lidar = hokuyo_utm30lx();
  const Pose2 pose{1.0, 0.5, 0.3};
  const Matrix<3, 3> plain = least_covariance(hall, hall, pose, lidar, 0.01, 0.0);
  const Matrix<3, 3> noisier = least_covariance(hall, hall, pose, lidar, 0.02, 0.0);
  EXPECT_LT((noisier - 4.0 * plain).norm(), 1e-6 * plain.norm());
  EXPECT_GT(least_covariance(hall, hall, pose, lidar, 0.01, 0.01)(0, 0), plain(0, 0));
}

TEST(CovarianceTrial, ThingsAreSetDownUntilTheyTakeTheirShare) {
  const World office = trial_world("office");
  Random random(3);
  const Pose2 pose = place_beside_route(office, random);
  const LidarModel lidar = hokuyo_utm30lx();
  const World crowded = with_unmapped_things(office, pose, lidar, 0.3, random);
  std::vector<double> bare, now;
  true_ranges(office, pose, lidar, bare);
  true_ranges(crowded, pose, lidar, now);
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < bare.size(); ++i) hidden += now[i] < bare[i] ? 1U : 0U;
  EXPECT_GE(static_cast<double>(hidden), 0.3 * static_cast<double>(bare.size()));
  EXPECT_LT(static_cast<double>(hidden), 0.7 * static_cast<double>(bare.size()));
}

TEST(CovarianceTrial, EveryWorldHasARouteToStandOn) {
  for (const std::string_view name : trial_world_names()) {
    const World world = trial_world(name);
    Random random(1);
    for (int k = 0; k < 20; ++k)
      EXPECT_GT(distance_to_walls(world, place_beside_route(world, random).translation()), 0.25) << name;
  }
  EXPECT_THROW(trial_world("nowhere"), Error);
}

}  // namespace
}  // namespace slamicp::covariance_trial_test
