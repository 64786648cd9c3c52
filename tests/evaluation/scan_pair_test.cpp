// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/evaluation/scan_pair.hpp>

namespace slamicp::scan_pair_test {
namespace {

TEST(ScanPair, TwoScansGiveTheMapsOfThePapersFigures7And8) {
  const MatchedPair pair = match(corridor_scan_pair(1));
  EXPECT_EQ(pair.scans.M.size(), 1081U);
  EXPECT_EQ(pair.scans.T.size(), 1081U);
  EXPECT_EQ(pair.all_points_map.size(), 2162U);  // the paper's number: all of both
  EXPECT_EQ(pair.result.updated_map.size(), 1081U + pair.result.outlier_indices.size());
  EXPECT_NEAR(static_cast<double>(pair.result.updated_map.size()), 1617.0, 150.0);
  EXPECT_EQ(pair.inliers.size(), pair.result.inliers);
  EXPECT_LT(distance(pair.result.pose, pair.scans.truth).translation, 0.005);
}

TEST(ScanPair, IdealScansMatchClosely) {
  const MatchedPair pair = match(ideal_scan_pair());
  EXPECT_TRUE(pair.result.usable());
  EXPECT_LT(distance(pair.result.pose, pair.scans.truth).translation, 0.002);
  EXPECT_GT(distance(pair.scans.guess, pair.scans.truth).translation, 0.05);
}

TEST(ScanPair, AnotherSeedIsOtherNoise) {
  EXPECT_EQ(corridor_scan_pair(2).T, corridor_scan_pair(2).T);
  EXPECT_NE(corridor_scan_pair(2).T, corridor_scan_pair(3).T);
}

}  // namespace
}  // namespace slamicp::scan_pair_test
