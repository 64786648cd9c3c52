// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/along_path.hpp>
#include <slamicp/simulation/random.hpp>

namespace slamicp::along_path_test {
namespace {

double outliers_of(const DriveSample& sample) { return static_cast<double>(sample.outliers); }

TEST(AlongPath, TakesTheNearestSampleWhateverTheSpeed) {
  RecordedDrive drive;
  // It stands, swings back a little, goes on.
  for (const double travelled : {0.0, 0.0, 0.02, 0.01, 0.09, 0.16, 0.31}) {
    DriveSample sample;
    sample.travelled = travelled;
    sample.outliers = drive.samples.size();
    drive.samples.push_back(sample);
  }
  EXPECT_EQ(along_path(drive, outliers_of, 1.0, 0.1), (std::vector<double>{0.0, 4.0, 5.0, 6.0}));
  EXPECT_EQ(along_path(drive, outliers_of, 0.15, 0.1).size(), 2U);
  EXPECT_TRUE(along_path({}, outliers_of, 1.0, 0.1).empty());
  EXPECT_THROW(along_path(drive, outliers_of, 1.0, 0.0), Error);
}

TEST(CurveSpread, TellsGroupsFromRuns) {
  // Two groups, 2 apart; runs 1 to either side of their group's mean.
  const CurveSpread spread = spread_of({{{0.0, 0.0}, {2.0, 2.0}}, {{2.0, 2.0}, {4.0, 4.0}}});
  EXPECT_NEAR(spread.between_groups, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(spread.within_groups, std::sqrt(2.0), 1e-12);
}

TEST(CurveSpread, OfGroupsThatDoNotDifferIsTheRunsOverTheRootOfTheirNumber) {
  Random random(3);
  std::vector<std::vector<std::vector<double>>> groups(5, std::vector<std::vector<double>>(3));
  for (auto& group : groups)
    for (auto& run : group)
      for (int k = 0; k < 2000; ++k) run.push_back(random.normal());
  const CurveSpread spread = spread_of(groups);
  EXPECT_NEAR(spread.within_groups, 1.0, 0.03);
  EXPECT_NEAR(spread.between_groups, 1.0 / std::sqrt(3.0), 0.03);
}

TEST(CurveSpread, LeavesOutPlacesThatSomeRunDoesNotReach) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const CurveSpread spread = spread_of({{{1.0, nan, 7.0}}, {{3.0, 1.0}}});
  EXPECT_NEAR(spread.between_groups, std::sqrt(2.0), 1e-12);
  EXPECT_EQ(spread.within_groups, 0.0);
  EXPECT_THROW(spread_of({}), Error);
  EXPECT_THROW(spread_of({{{1.0}}, {}}), Error);
}

}  // namespace
}  // namespace slamicp::along_path_test
