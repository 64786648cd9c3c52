// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/geometry/voxel_grid.hpp>

#include "support/random.hpp"

namespace slamicp::voxel_grid_test {
namespace {

TEST(VoxelGridTest, EachCubeLeavesTheMeanOfItsPointsInTheOrderOfTheFirst) {
  const PointCloud2 cloud{{1.2, 0.1}, {-0.1, 0.1}, {1.4, 0.3}, {test::nan, 0.0}, {0.1, 0.1}};
  const PointCloud2 thin = voxel_downsampled<2>(cloud, 0.5);
  ASSERT_EQ(thin.size(), 3U) << "cells on the two sides of zero are two";
  EXPECT_LT((thin[0] - Point2(1.3, 0.2)).norm(), 1e-12);
  EXPECT_EQ(thin[1], Point2(-0.1, 0.1));
  EXPECT_EQ(thin[2], Point2(0.1, 0.1));
}

TEST(VoxelGridTest, NoTwoPointsShareACubeAndAllCubesAreKept) {
  test::Random random(1);
  PointCloud3 cloud;
  for (int k = 0; k < 5000; ++k) cloud.push_back(random.point<3>(1.0));
  const PointCloud3 thin = voxel_downsampled<3>(cloud, 0.25);
  EXPECT_EQ(thin.size(), 512U);
  EXPECT_EQ(voxel_downsampled<3>(thin, 0.25), thin);
}

TEST(VoxelGridTest, AbsurdSizesAreRefused) {
  for (const double size : {0.0, -1.0, test::nan, test::infinity})
    EXPECT_THROW(voxel_downsampled<2>(PointCloud2{{0, 0}}, size), Error);
  EXPECT_THROW(voxel_downsampled<2>(PointCloud2{{1e300, 0}}, 0.1), Error);
  EXPECT_TRUE(voxel_downsampled<2>({}, 0.1).empty());
}

}  // namespace
}  // namespace slamicp::voxel_grid_test
