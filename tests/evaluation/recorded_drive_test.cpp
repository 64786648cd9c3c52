// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/recorded_drive.hpp>

#include "sampled_site.hpp"

namespace slamicp::recorded_drive_test {
namespace {

/// The stretch beside B1.
DrivePlan beside_b1() {
  DrivePlan plan;
  plan.obstacle = "B1";
  plan.start = 5.0;
  plan.most_seconds = 10.0;
  return plan;
}

TEST(RecordedDrive, KeepsScansSamplesAndViews) {
  const ExperimentSite site = sampled_site();
  DrivePlan plan = beside_b1();
  plan.views = {6.0, 7.0, 100.0};
  const RecordedDrive drive = record_drive(site, plan);
  EXPECT_FALSE(drive.finished);
  ASSERT_EQ(drive.scans.size(), drive.samples.size());
  EXPECT_NEAR(static_cast<double>(drive.scans.size()), 400.0, 2.0);
  ASSERT_EQ(drive.views.size(), 2U);
  EXPECT_NEAR(drive.views[0].travelled, 6.0, 0.02);
  EXPECT_GT(drive.views[1].inliers.size(), 900U);
  std::size_t outliers = 0;
  for (const DriveSample& sample : drive.samples) {
    outliers += sample.outliers;
    EXPECT_LT(distance(sample.truth, sample.estimate).translation, 0.03);
  }
  EXPECT_EQ(drive.outliers.size(), outliers);
  EXPECT_GT(drive.mean_inlier_distance(), 0.002);
  EXPECT_LT(drive.mean_inlier_distance(), 0.02);

  plan.keeps_scans = false;
  const RecordedDrive lean = record_drive(site, plan);
  EXPECT_TRUE(lean.scans.empty());
  EXPECT_TRUE(lean.outliers.empty());
  ASSERT_EQ(lean.samples.size(), drive.samples.size());
  EXPECT_EQ(lean.samples.back().truth.x, drive.samples.back().truth.x);
  EXPECT_EQ(lean.most_outliers(), drive.most_outliers());
}

TEST(RecordedDrive, FindsTheObstacleInTime) {
  const Sighting sighting = sighting_of(record_drive(sampled_site(), beside_b1()));
  ASSERT_TRUE(sighting.was_due());
  ASSERT_TRUE(sighting.was_found());
  EXPECT_LE(sighting.delay(), 0.5);
  EXPECT_GT(sighting.found_at_range, 0.3);
}

TEST(RecordedDrive, WithoutAnObstacleThereIsNothingToSee) {
  DrivePlan plan;
  plan.most_seconds = 2.0;
  const RecordedDrive drive = record_drive(sampled_site(), plan);
  const Sighting sighting = sighting_of(drive);
  EXPECT_FALSE(sighting.was_due());
  EXPECT_FALSE(sighting.was_found());
  for (const DriveSample& sample : drive.samples) EXPECT_EQ(sample.beams_on_it, 0);
  EXPECT_LE(drive.most_outliers(), 10U);
}

TEST(RecordedDrive, ASightingIsDueAtTheFifthBeamAndFoundOnce) {
  RecordedDrive drive;
  drive.plan.obstacle = "A1";
  const auto sample = [](double stamp, int beams, bool found) {
    DriveSample made;
    made.stamp = stamp;
    made.beams_on_it = beams;
    made.found = found;
    return made;
  };
  drive.samples = {sample(0.0, 4, false), sample(1.0, 5, false), sample(2.0, 9, true), sample(3.0, 9, false)};
  const Sighting sighting = sighting_of(drive);
  EXPECT_EQ(sighting.due, 1.0);
  EXPECT_EQ(sighting.found, 2.0);
  EXPECT_EQ(sighting.delay(), 1.0);
}

TEST(RecordedDrive, RefusesWhatIsNoDrive) {
  const ExperimentSite site = sampled_site();
  DrivePlan plan;
  plan.obstacle = "E1";
  EXPECT_THROW(record_drive(site, plan), Error);
  plan = {};
  plan.speed = -1.0;
  EXPECT_THROW(record_drive(site, plan), Error);
}

}  // namespace
}  // namespace slamicp::recorded_drive_test
