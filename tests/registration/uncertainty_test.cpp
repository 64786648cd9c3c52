// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <slamicp/registration/icp.hpp>

#include "support/room.hpp"

namespace slamicp::uncertainty_test {
namespace {

using test::Random;
using test::Room;

constexpr double noise = 0.01;  // [m]

Room corridor_of(double length, bool has_end) {
  Room room;
  room.walls = {{{-length, -1.25}, {length, -1.25}}, {{-length, 1.25}, {length, 1.25}}};
  if (has_end) room.walls.push_back({{length, -1.25}, {length, 1.25}});
  return room;
}

struct Seen {
  PointCloud2 map;
  PointCloud2 scan;
  Pose2 truth;

  explicit Seen(const Room& room, const Pose2& where = {1.5, 1.2, 0.4}, double with_noise = noise) : truth(where) {
    Random random(5);
    map = room.map(0.0086, with_noise, &random);
    const LaserScan swept = room.scan(truth, 0.0, with_noise, &random);
    for (std::size_t i = 0; i < swept.ranges.size(); ++i) {
      const double angle = swept.angle_min + static_cast<double>(i) * swept.angle_increment;
      const double range = static_cast<double>(swept.ranges[i]);
      if (is_return(swept, swept.ranges[i])) scan.push_back({range * std::cos(angle), range * std::sin(angle)});
    }
  }
};

IcpResult2 match(const Seen& seen, const IcpOptions& options = {}, const PosePrior& prior = {}) {
  Icp<2> icp(options);
  icp.set_rays({Point2::Zero(), 1.5 * test::pi / 540.0});
  return icp.align(IndexedPoints<2>(seen.map), seen.scan, seen.truth * Pose2{0.02, 0.01, 0.004}, {.covariance = true},
                   prior);
}

PosePrior prior_at(const Pose2& mean, double sigma) {
  return {mean, Eigen::Matrix3d(Eigen::Vector3d::Constant(1.0 / (sigma * sigma)).asDiagonal())};
}

TEST(UncertaintyTest, IsComputedOnlyWhenAskedFor) {
  const Seen seen(test::simple_room());
  const IndexedPoints<2> map(seen.map);
  Icp<2> icp;
  EXPECT_TRUE(icp.align(map, seen.scan, seen.truth, {.covariance = true}).uncertainty.known);
  EXPECT_FALSE(icp.align(map, seen.scan, seen.truth).uncertainty.known);
}

TEST(UncertaintyTest, AMatchIsSurprisingWhereThePriorCannotBeRight) {
  const Seen seen(test::simple_room());
  const IcpResult2 expected = match(seen, {}, prior_at(seen.truth, 0.01));
  EXPECT_LT(expected.uncertainty.surprise, Uncertainty::credible);
  EXPECT_EQ(expected.uncertainty.trust_in_prior(), 1.0);
  const Pose2 elsewhere = seen.truth * Pose2{0.1, 0.0, 0.0};
  const IcpResult2 surprising = match(seen, {}, prior_at(elsewhere, 0.002));
  EXPECT_GT(surprising.uncertainty.surprise, 100.0);
  EXPECT_LT(surprising.uncertainty.trust_in_prior(), 0.1);
  // The pairs agree with each other: the prior gives way.
  EXPECT_LT(distance(surprising.pose, seen.truth).translation, 0.01);
}

TEST(UncertaintyTest, PairsThatAreFewGiveWayToThePriorTheyContradict) {
  Seen seen(test::simple_room());
  // Most of what is seen is a crowd in front of the walls.
  for (std::size_t k = 0; k < seen.scan.size(); ++k)
    if (k % 3 != 0) seen.scan[k] *= 0.5;
  const Pose2 elsewhere = seen.truth * Pose2{0.06, 0.0, 0.0};
  const IcpResult2 result = match(seen, {}, prior_at(elsewhere, 0.002));
  EXPECT_LT(distance(result.pose, elsewhere).translation, 0.01);
  EXPECT_LE(result.uncertainty.surprise, Uncertainty::credible);
}

TEST(UncertaintyTest, AFirstGateKeepsTheMatchNear) {
  const Seen seen(test::simple_room());
  PosePrior near = prior_at(seen.truth * Pose2{0.5, 0.2, 0.0}, 10.0);
  Icp<2> icp;
  const IndexedPoints<2> map(seen.map);
  EXPECT_LT(distance(icp.align(map, seen.scan, near.mean, {}, near).pose, seen.truth).translation, 0.01);
  near.first_gate = 0.05;
  EXPECT_GT(distance(icp.align(map, seen.scan, near.mean, {}, near).pose, seen.truth).translation, 0.05);
}

TEST(UncertaintyTest, ARoomHoldsEveryDirection) {
  const IcpResult2 result = match(Seen(test::simple_room()));
  const Uncertainty& told = result.uncertainty;
  ASSERT_TRUE(told.known);
  EXPECT_FALSE(told.blind);
  EXPECT_EQ(result.stop, Stop::converged);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(told.covariance);
  EXPECT_GT(eigen.eigenvalues()[0], 0.0);
  EXPECT_LT(std::sqrt(eigen.eigenvalues()[2]), 0.005);
  EXPECT_NEAR(told.range_noise, noise, 0.15 * noise);
  EXPECT_LE(told.weakest_sigma, std::sqrt(eigen.eigenvalues()[2]) * 1.0001);
  const Eigen::Matrix3d white = told.covariance - told.systematic;
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(white).eigenvalues()[0], 0.0)
      << "systematic is a part of it";
  EXPECT_LT((Eigen::Matrix3d(told.covariance) * told.information - Eigen::Matrix3d::Identity()).norm(), 1e-6);
}

TEST(UncertaintyTest, ANoisyCorridorIsBlindAlongItself) {
  const Seen seen(corridor_of(40.0, false), {0.4, 0.2, 0.1});
  const IcpResult2 result = match(seen);
  EXPECT_TRUE(result.uncertainty.blind) << "the normals' noise holds nothing";
  EXPECT_EQ(result.uncertainty.weakest_sigma, std::numeric_limits<double>::infinity());
  const Vector<2> in_map = result.pose.rotation() * result.uncertainty.weakest;
  EXPECT_GT(std::abs(in_map.x()), 0.999);
  EXPECT_NEAR(result.pose.y, seen.truth.y, 0.004);
}

TEST(UncertaintyTest, AFarEndHoldsTheCorridor) {
  const IcpResult2 result = match(Seen(corridor_of(20.0, true), {0.4, 0.2, 0.1}));
  EXPECT_FALSE(result.uncertainty.blind);
  EXPECT_NEAR(result.pose.x, 0.4, 0.02);
  EXPECT_LT(result.uncertainty.weakest_sigma, 0.01);
  EXPECT_GT(result.uncertainty.weakest_sigma, 0.001);
}

TEST(UncertaintyTest, ABlindDirectionFollowsThePrior) {
  const Seen seen(corridor_of(40.0, false), {0.4, 0.2, 0.1});
  const Pose2 mean{0.47, 0.21, 0.1};
  const IcpResult2 result = match(seen, {}, prior_at(mean, 0.1));
  EXPECT_TRUE(result.uncertainty.blind);
  EXPECT_EQ(result.stop, Stop::degenerate);
  EXPECT_NEAR(result.pose.x, mean.x, 0.003);
  EXPECT_NEAR(result.pose.y, seen.truth.y, 0.004);
}

TEST(UncertaintyTest, APriorHardlyMovesWhatThePairsHold) {
  const Seen seen(test::simple_room());
  const Pose2 alone = match(seen).pose;
  const Pose2 wrong = seen.truth * Pose2{0.03, -0.03, 0.01};
  EXPECT_LT(distance(match(seen, {}, prior_at(wrong, 0.03)).pose, alone).translation, 2e-4);
  const Pose2 sure = match(seen, {}, prior_at(wrong, 1e-5)).pose;
  EXPECT_LT(distance(sure, wrong).translation, 1e-3) << "but a sure one does";
}

TEST(UncertaintyTest, EveryInstructionSetTellsTheSame) {
  const Seen seen(test::simple_room());
  const Uncertainty scalar = match(seen, {.instruction_set = InstructionSet::scalar}).uncertainty;
  for (const InstructionSet set : {InstructionSet::portable, InstructionSet::sse4, InstructionSet::avx2,
                                   InstructionSet::avx512, InstructionSet::neon}) {
    if (!is_available(set)) continue;
    const Uncertainty told = match(seen, {.instruction_set = set}).uncertainty;
    EXPECT_NEAR(std::sqrt(told.covariance(0, 0) / scalar.covariance(0, 0)), 1.0, 0.1) << to_string(set);
    EXPECT_NEAR(std::sqrt(told.covariance(2, 2) / scalar.covariance(2, 2)), 1.0, 0.1) << to_string(set);
    EXPECT_NEAR(told.range_noise / scalar.range_noise, 1.0, 0.02) << to_string(set);
  }
}

TEST(UncertaintyTest, NoiseAsToldIsUsed) {
  const Seen seen(test::simple_room());
  EXPECT_EQ(match(seen, {.noise = {.range = 0.02}}).uncertainty.range_noise, 0.02);
  const double twice = match(seen, {.noise = {.range = 0.02, .map = 0.02}}).uncertainty.covariance(0, 0);
  const double once = match(seen, {.noise = {.range = 0.01, .map = 0.01}}).uncertainty.covariance(0, 0);
  EXPECT_NEAR(std::sqrt(twice / once), 2.0, 0.3);
  EXPECT_NE(IcpOptions{.noise = {.range = -1.0}}.problem(), "");
  EXPECT_NE(IcpOptions{.noise = {.least_range = 0.0}}.problem(), "");
  EXPECT_NE(IcpOptions{.noise = {.map = 2.0}}.problem(), "");
}

TEST(UncertaintyTest, ThingsThatDoNotFitMakeItLarger) {
  Room room = test::simple_room();
  const Seen plain(room);
  Seen shifted = plain;
  for (std::size_t i = 100; i < 200; ++i) shifted.scan[i] *= 1.012;  // a piece of wall that moved by some 3 cm
  EXPECT_GT(match(shifted).uncertainty.misfit, 2.0 * match(plain).uncertainty.misfit);
  EXPECT_GT(match(shifted).uncertainty.covariance.trace(), 1.5 * match(plain).uncertainty.covariance.trace());
}

}  // namespace
}  // namespace slamicp::uncertainty_test
