// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/scan/odometry_calibration.hpp>

#include "support/random.hpp"

namespace slamicp::odometry_calibration_test {
namespace {

/// A stretch of some twenty steps that turns to one side, by what `really` does with what its wheels turn.
template <class Model, class Reading>
DriveStretch<Reading> drive(const Model& really, test::Random& random, double noise,
                            const std::function<Reading(const Pose2&)>& reading_of) {
  DriveStretch<Reading> stretch;
  const double turn = random.uniform(-0.08, 0.08);
  const double side = Model{}.turns({0.0, 0.05, 0.0})[0] == 0.0 ? 0.0 : random.uniform(-0.02, 0.02);
  for (int step = 0; step < 20; ++step) {
    stretch.readings.push_back(reading_of({random.uniform(0.02, 0.06), side, turn}));
    stretch.T_start_end = stretch.T_start_end * really.motion(stretch.readings.back());
  }
  stretch.T_start_end =
      stretch.T_start_end * Pose2{random.normal(noise), random.normal(noise), random.normal(0.3 * noise)};
  return stretch;
}

template <class Model, class Reading>
std::vector<DriveStretch<Reading>> drives(const Model& really, const Model& nominal, double noise, int count = 60) {
  test::Random random(5);
  std::vector<DriveStretch<Reading>> stretches;
  for (int k = 0; k < count; ++k)
    stretches.push_back(
        drive<Model, Reading>(really, random, noise, [&](const Pose2& motion) { return nominal.turns(motion); }));
  return stretches;
}

TEST(OdometryCalibrationTest, FindsTheWheelsOfADifferentialDrive) {
  const DifferentialDrive nominal{0.10, 0.10, 0.40};
  const DifferentialDrive really{0.102, 0.099, 0.43};
  const auto found = calibrate(nominal, drives<DifferentialDrive, WheelTurns<2>>(really, nominal, 0.003));
  ASSERT_TRUE(found.determined);
  const double errors[] = {found.model.left_radius - 0.102, found.model.right_radius - 0.099,
                           found.model.wheel_distance - 0.43};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(found.sigmas[k], 0.002);
    EXPECT_LT(std::abs(errors[k]), 4.0 * found.sigmas[k]) << k;
  }
  EXPECT_LT(found.rms_after, 0.2 * found.rms_before);
}

TEST(OdometryCalibrationTest, FindsTheWheelsOfAnOmniDrive) {
  const OmniDrive nominal{{0.10, 0.10, 0.10}, 0.20, 0.3};
  const OmniDrive really{{0.101, 0.099, 0.102}, 0.21, 0.3};
  const auto found = calibrate(nominal, drives<OmniDrive, WheelTurns<3>>(really, nominal, 0.003));
  ASSERT_TRUE(found.determined);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT(std::abs(found.model.radii[k] - really.radii[k]), 4.0 * found.sigmas[k]) << k;
  EXPECT_LT(std::abs(found.model.base_radius - 0.21), 4.0 * found.sigmas[3]);
  EXPECT_LT(found.rms_after, 0.5 * found.rms_before);
}

TEST(OdometryCalibrationTest, FindsTheScalesOfAnyOdometry) {
  const OdometryScale really{1.03, 0.97, -0.01};
  test::Random random(6);
  std::vector<DriveStretch<Pose2>> stretches;
  for (int k = 0; k < 60; ++k) {
    DriveStretch<Pose2> stretch;
    const double turn = k % 3 == 0 ? 0.0 : random.uniform(-0.1, 0.1);
    for (int step = 0; step < 20; ++step) {
      stretch.readings.push_back({random.uniform(0.02, 0.06), 0.0, turn});
      stretch.T_start_end = stretch.T_start_end * really.motion(stretch.readings.back());
    }
    stretches.push_back(stretch);
  }
  const auto found = calibrate(OdometryScale{}, stretches);
  ASSERT_TRUE(found.determined);
  EXPECT_NEAR(found.model.translation, 1.03, 1e-6);
  EXPECT_NEAR(found.model.rotation, 0.97, 1e-6);
  EXPECT_NEAR(found.model.drift_per_metre, -0.01, 1e-6);
}

TEST(OdometryCalibrationTest, SaysWhereTheDriveDoesNotTell) {
  const DifferentialDrive nominal;
  std::vector<DriveStretch<WheelTurns<2>>> standing(10);
  for (auto& stretch : standing) stretch.readings.push_back({0.0, 0.0});
  const auto found = calibrate(nominal, standing);
  EXPECT_FALSE(found.determined);
  EXPECT_EQ(found.model.wheel_distance, nominal.wheel_distance);
  EXPECT_TRUE(std::isinf(found.sigmas[0]));
  EXPECT_FALSE(calibrate(nominal, {}).determined);

  // Straight ahead only: the distance of the wheels never shows.
  std::vector<DriveStretch<WheelTurns<2>>> straight(10);
  for (auto& stretch : straight) {
    stretch.readings.assign(10, {1.0, 1.0});
    for (int k = 0; k < 10; ++k) stretch.T_start_end = stretch.T_start_end * nominal.motion({1.0, 1.0});
  }
  EXPECT_FALSE(calibrate(nominal, straight).determined);
}

TEST(OdometryCalibrationTest, RefusesAbsurdModels) {
  EXPECT_THROW(calibrate(DifferentialDrive{0.0, 0.1, 0.4}, {}), Error);
  EXPECT_THROW(calibrate(OmniDrive{}, {}, {.fix_translation = 0.0}), Error);
}

}  // namespace
}  // namespace slamicp::odometry_calibration_test
