// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/obstacles/reconstruction.hpp>

#include "support/room.hpp"

namespace slamicp::reconstruction_test {
namespace {

/// The outline of a box as many scans of a run leave it.
PointCloud2 noisy_box(const Point2& centre, double width, double depth, double heading, double noise,
                      test::Random& random) {
  test::Room room;
  room.add_box(centre, width, depth, heading);
  return room.map(0.004, noise, &random);
}

TEST(ReconstructionTest, OutliersOfManyScansAddUpToTheBox) {
  test::Random random(1);
  PointCloud2 outliers = noisy_box({11.0, 0.5}, 0.480, 0.215, 0.17, 0.005, random);
  for (int k = 0; k < 60; ++k) outliers.push_back(Point2(11.0, 0.5) + random.point<2>(3.0));  // noise comes alone
  const std::vector<Obstacle> obstacles = reconstruct_obstacles(outliers);
  ASSERT_EQ(obstacles.size(), 1U);
  const OrientedBox& box = obstacles[0].box;
  EXPECT_LT((box.centre - Point2(11.0, 0.5)).norm(), 0.02);
  EXPECT_NEAR(box.width, 0.480, 0.05);
  EXPECT_NEAR(box.depth, 0.215, 0.05);
  EXPECT_NEAR(box.heading, 0.17, 0.1);
  EXPECT_EQ(obstacles[0].distance, 0.0);
}

TEST(ReconstructionTest, TwoThingsAreTwoLargestFirstAndTheirPointsCountTheOutliers) {
  test::Random random(2);
  PointCloud2 outliers = noisy_box({1, 1}, 0.3, 0.2, 0.0, 0.003, random);
  const std::size_t small = outliers.size();
  test::append(outliers, noisy_box({2, 1}, 0.8, 0.4, 0.5, 0.003, random));
  const std::vector<Obstacle> obstacles = reconstruct_obstacles(outliers);
  ASSERT_EQ(obstacles.size(), 2U);
  EXPECT_GT(obstacles[0].points.size(), obstacles[1].points.size());
  EXPECT_GE(obstacles[0].points.front(), static_cast<int>(small));
  EXPECT_LT(obstacles[1].points.back(), static_cast<int>(small));
  EXPECT_TRUE(std::is_sorted(obstacles[0].points.begin(), obstacles[0].points.end()));
}

TEST(ReconstructionTest, TheGapDecidesWhatBelongsTogether) {
  PointCloud2 outliers = test::wall({0, 0}, {1, 0}, 0.005);
  test::append(outliers, test::wall({1.1, 0}, {2, 0}, 0.005));
  EXPECT_EQ(reconstruct_obstacles(outliers, {.gap = 0.11}).size(), 1U);
  EXPECT_EQ(reconstruct_obstacles(outliers, {.gap = 0.09}).size(), 2U);
}

TEST(ReconstructionTest, SmallGroupsAreDropped) {
  const PointCloud2 outliers = test::wall({0, 0}, {0.1, 0}, 0.01);
  const int points = static_cast<int>(outliers.size());
  EXPECT_EQ(reconstruct_obstacles(outliers, {.min_points = points, .filter_neighbours = 0}).size(), 1U);
  EXPECT_EQ(reconstruct_obstacles(outliers, {.min_points = points + 1, .filter_neighbours = 0}).size(), 0U);
}

TEST(ReconstructionTest, NothingAndNonsenseGiveNothing) {
  EXPECT_TRUE(reconstruct_obstacles({}).empty());
  EXPECT_TRUE(reconstruct_obstacles(PointCloud2(100, Point2(test::nan, 0)), {.filter_neighbours = 0}).empty());
}

TEST(ReconstructionTest, AbsurdOptionsAreRefused) {
  const ReconstructionOptions absurd[] = {
      {.gap = 0.0},  {.gap = test::nan},     {.min_points = 0},        {.trim = -0.1},
      {.trim = 0.3}, {.filter_radius = 0.0}, {.filter_neighbours = -1}};
  for (const ReconstructionOptions& options : absurd) {
    EXPECT_FALSE(options.problem().empty());
    EXPECT_THROW(reconstruct_obstacles({}, options), Error);
  }
}

}  // namespace
}  // namespace slamicp::reconstruction_test
