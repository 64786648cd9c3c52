// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>

namespace slamicp::trajectory_error_test {
namespace {

Trajectory curve(int poses) {
  Trajectory trajectory;
  Pose2 pose{1.0, 2.0, 0.4};
  for (int i = 0; i < poses; ++i) {
    trajectory.push_back({1e9 + 0.025 * i, pose});
    pose = pose * Pose2::exp({0.1, 0.0, 0.05 * std::sin(0.3 * i)});
  }
  return trajectory;
}

Trajectory moved(const Pose2& T, Trajectory trajectory) {
  for (StampedPose& pose : trajectory) pose.pose = T * pose.pose;
  return trajectory;
}

TEST(ErrorStatistics, OfKnownNumbers) {
  std::vector<double> errors;
  for (int i = 100; i >= 1; --i) errors.push_back(i);
  const ErrorStatistics statistics = statistics_of(errors);
  EXPECT_EQ(statistics.count, 100U);
  EXPECT_DOUBLE_EQ(statistics.mean, 50.5);
  EXPECT_DOUBLE_EQ(statistics.rmse, std::sqrt(3383.5));
  EXPECT_NEAR(statistics.standard_deviation, std::sqrt(833.25), 1e-12);
  EXPECT_EQ(statistics.p95, 95.0);
  EXPECT_EQ(statistics.max, 100.0);
  EXPECT_EQ(statistics_of({}).count, 0U);
  EXPECT_EQ(statistics_of({2.0}).p95, 2.0);
}

TEST(AbsoluteError, OfAKnownOffset) {
  const Trajectory truth = curve(50);
  Trajectory estimate = truth;
  estimate[7].pose.x += 0.3;
  estimate[7].pose.y -= 0.4;
  estimate[9].pose.theta = wrap_angle(estimate[9].pose.theta - 0.2);
  const TrajectoryError error = absolute_error(estimate, truth);
  EXPECT_EQ(error.translation.count, 50U);
  EXPECT_NEAR(error.translation.max, 0.5, 1e-12);
  EXPECT_NEAR(error.translation.mean, 0.01, 1e-12);
  EXPECT_NEAR(error.rotation.max, 0.2, 1e-12);
  EXPECT_NEAR(error.rotation.rmse, 0.2 / std::sqrt(50.0), 1e-12);
}

TEST(AbsoluteError, AlignmentRemovesAnyRigidMotion) {
  const Trajectory truth = curve(80);
  const Pose2 T{-30.0, 12.0, 2.9};
  const Trajectory estimate = moved(T.inverse(), truth);
  EXPECT_GT(absolute_error(estimate, truth).translation.mean, 1.0);
  for (const Alignment alignment : {Alignment::first, Alignment::se2}) {
    const TrajectoryError error = absolute_error(estimate, truth, {.alignment = alignment});
    EXPECT_LT(error.translation.max, 1e-9);
    EXPECT_LT(error.rotation.max, 1e-9);
    EXPECT_LT(distance(error.T_truth_estimate, T).translation, 1e-9);
  }
}

TEST(AbsoluteError, LeastSquaresAlignmentIsBetterThanItsNeighbours) {
  const Trajectory truth = curve(60);
  Trajectory estimate = truth;
  for (std::size_t i = 0; i < estimate.size(); ++i) estimate[i].pose.x += 0.1 * std::sin(static_cast<double>(i * i));
  const TrajectoryErrorOptions se2{.alignment = Alignment::se2};
  const TrajectoryError best = absolute_error(estimate, truth, se2);
  for (const Pose2& nudge :
       {Pose2{1e-3, 0.0, 0.0}, Pose2{0.0, -1e-3, 0.0}, Pose2{0.0, 0.0, 1e-3}, Pose2{0, 0, -1e-3}}) {
    const Trajectory nudged = moved(nudge * best.T_truth_estimate, estimate);
    EXPECT_GT(absolute_error(nudged, truth).translation.rmse, best.translation.rmse);
  }
}

TEST(AbsoluteError, FindsStampsThatRunBackwardsAndStampsThatRepeat) {
  Trajectory truth = curve(40);
  truth[20].stamp = truth[5].stamp - 0.01;  // backwards, as in intel.clf
  truth[31].stamp = truth[30].stamp;        // the same stamp twice
  Trajectory rounded = truth;
  for (StampedPose& pose : rounded) pose.stamp += 2e-7;
  for (const Trajectory& estimate : {truth, rounded}) {
    const TrajectoryError error = absolute_error(estimate, truth);
    EXPECT_EQ(error.translation.count, 40U);
    EXPECT_EQ(error.translation.max, 0.0);
  }
  std::reverse(truth.begin(), truth.end() - 12);
  EXPECT_EQ(absolute_error(rounded, truth).translation.max, 0.0);
}

TEST(AbsoluteError, CountsWhatHasNoPartner) {
  const Trajectory truth = curve(40);
  Trajectory estimate = truth;
  estimate[3].stamp += 0.01;
  estimate.push_back({5.0, {}});
  const TrajectoryError error = absolute_error(estimate, truth);
  EXPECT_EQ(error.unmatched, 2U);
  EXPECT_EQ(error.translation.count, 39U);
  EXPECT_NE(error.brief().find("2 poses unmatched"), std::string::npos);
}

TEST(AbsoluteError, RefusesWhatCannotBeCompared) {
  const Trajectory truth = curve(5);
  Trajectory elsewhere = truth;
  for (StampedPose& pose : elsewhere) pose.stamp -= 1e9;
  Trajectory broken = truth;
  broken[2].pose.x = std::nan("");
  EXPECT_THROW(absolute_error({}, truth), Error);
  EXPECT_THROW(absolute_error(truth, {}), Error);
  EXPECT_THROW(absolute_error(elsewhere, truth), Error);
  EXPECT_THROW(absolute_error(broken, truth), Error);
  EXPECT_THROW(absolute_error(truth, truth, {.stamp_tolerance = -1.0}), Error);
}

TEST(RelativeError, OfWheelsThatCountTwoPercentTooMuch) {
  Trajectory truth;
  Trajectory estimate;
  for (int i = 0; i <= 100; ++i) {
    truth.push_back({0.1 * i, {0.1 * i, 0.0, 0.0}});
    estimate.push_back({0.1 * i, Pose2{5.0, 5.0, 1.0} * Pose2{0.102 * i, 0.0, 0.0}});
  }
  const TrajectoryError error = relative_error(estimate, truth, 1.0);
  EXPECT_EQ(error.translation.count, 91U);
  EXPECT_NEAR(error.translation.mean, 0.02, 1e-9);
  EXPECT_NEAR(error.translation.max, 0.02, 1e-9);
  EXPECT_NEAR(error.rotation.max, 0.0, 1e-9);
  EXPECT_THROW(relative_error(estimate, truth, 11.0), Error);
  EXPECT_THROW(relative_error(estimate, truth, 0.0), Error);
}

}  // namespace
}  // namespace slamicp::trajectory_error_test
