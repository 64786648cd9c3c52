// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/registration/icp.hpp>

#include "support/brute_force.hpp"
#include "support/clouds.hpp"

namespace slamicp::matches_property_test {
namespace {

using test::Random;

IcpOptions any_options(Random& random) {
  IcpOptions options;
  options.method = random.chance(0.5) ? Method::point_to_point : Method::point_to_line;
  options.max_correspondence_distance = random.uniform(0.05, 0.6);
  switch (random.integer(0, 3)) {
    case 0:
      options.outlier_distance = options.max_correspondence_distance * random.uniform(0.1, 1.0);
      break;
    case 1:
      options.outlier_distance = options.max_correspondence_distance * random.uniform(1.0, 3.0);
      break;
    case 2:
      options.outlier_distance = options.max_correspondence_distance;
      break;
    default:
      break;
  }
  options.max_iterations = random.integer(1, 20);
  options.kernel = static_cast<RobustKernel>(random.integer(0, 4));
  options.kernel_scale = random.uniform(0.01, 0.2);
  options.final_gate = random.chance(0.5) ? 0.0 : options.max_correspondence_distance * random.uniform(0.1, 1.0);
  return options;
}

/// Map points with noise, clutter, and points that are no numbers, in the robot's frame.
template <int D>
PointCloud<D> any_scan(Random& random, const PointCloud<D>& map, const Point<D>& center, const Pose<D>& pose) {
  PointCloud<D> in_map;
  const int size = random.integer(0, 60);
  for (int k = 0; k < size; ++k) {
    if (random.chance(0.7) && !map.empty())
      in_map.push_back(map[static_cast<std::size_t>(random.integer(0, static_cast<int>(map.size()) - 1))] +
                       random.point<D>(0.03));
    else
      in_map.push_back(center + random.point<D>(3.0));
  }
  PointCloud<D> in_robot = test::transformed(pose.inverse(), in_map);
  for (Point<D>& point : in_robot)
    if (random.chance(0.03)) point[random.integer(0, D - 1)] = random.chance(0.5) ? test::nan : test::infinity;
  return in_robot;
}

template <int D>
void expect_outputs_of_brute_force(std::uint64_t seed) {
  Random random(seed);
  const Point<D> center = random.point<D>(random.chance(0.8) ? 0.0 : 500.0);
  const PointCloud<D> cloud = test::unkind_cloud<D>(random, random.integer(0, 120), center);
  const Pose<D> truth = Pose<D>::from(Pose<D>{}.rotation(), center) * random.pose<D>(1.0, 1.5);
  const PointCloud<D> scan = any_scan<D>(random, cloud, center, truth);
  const IcpOptions options = any_options(random);
  const IndexedPoints<D> map(cloud);

  Icp<D> icp(options);
  const IcpResult<D>& result = icp.align(map, scan, truth * random.pose<D>(0.1, 0.1), Outputs::all());

  ASSERT_TRUE(result.pose.is_finite());
  ASSERT_LE(result.iterations, options.max_iterations);
  ASSERT_EQ(result.transformed_scan.size(), scan.size());
  ASSERT_EQ(result.matches.size(), scan.size());
  const double limit = options.max_correspondence_distance;
  const double threshold = options.outlier_threshold();
  std::vector<int> outliers;
  PointCloud<D> outliers_in_map;
  std::size_t inliers = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Match& match = result.matches[i];
    if (!is_finite<D>(scan[i])) {
      ASSERT_EQ(match.point_class, PointClass::neither);
      ASSERT_EQ(match.map_index, -1);
      continue;
    }
    const Point<D>& in_map = result.transformed_scan[i];
    ASSERT_LT((in_map - result.pose * scan[i]).norm(), 1e-9) << "not at the final pose";
    const Neighbour nearest = test::nearest_of_all<D>(cloud, in_map, test::infinity);
    const bool inlier = nearest.squared_distance < limit * limit;
    const bool outlier = !(nearest.squared_distance < threshold * threshold);
    ASSERT_EQ(is_inlier(match.point_class), inlier);
    ASSERT_EQ(is_outlier(match.point_class), outlier);
    const bool reached = nearest.squared_distance < std::max(limit * limit, threshold * threshold);
    ASSERT_EQ(match.map_index, reached ? nearest.index : -1);
    ASSERT_EQ(match.distance, reached ? std::sqrt(nearest.squared_distance) : test::infinity);
    if (outlier) {
      outliers.push_back(static_cast<int>(i));
      outliers_in_map.push_back(in_map);
    }
    if (inlier) {
      ++inliers;
      sum += std::sqrt(nearest.squared_distance);
    }
  }
  ASSERT_EQ(result.outlier_indices, outliers);
  ASSERT_EQ(result.outliers_in_map, outliers_in_map);
  ASSERT_EQ(result.inliers, inliers);
  ASSERT_NEAR(result.mean_inlier_distance, inliers > 0 ? sum / static_cast<double>(inliers) : 0.0, 1e-12);

  // Equation (10): the updated map is the map, then the outliers.
  ASSERT_EQ(result.updated_map.size(), cloud.size() + outliers.size());
  for (std::size_t k = 0; k < result.updated_map.size(); ++k) {
    const Point<D>& expected = k < cloud.size() ? cloud[k] : outliers_in_map[k - cloud.size()];
    for (int axis = 0; axis < D; ++axis)
      ASSERT_TRUE(result.updated_map[k][axis] == expected[axis] || std::isnan(expected[axis]));
  }

  // Outliers asked for alone take another way through the code.
  const Outputs only_outliers{.outlier_indices = true};
  const std::vector<int> first = icp.align(map, scan, truth, only_outliers).outlier_indices;
  ASSERT_EQ(icp.align(map, scan, truth, Outputs::all()).outlier_indices, first);
}

TEST(MatchesPropertyTest, TenThousandScansInThePlaneAreClassifiedAsBruteForceDoes) {
  for (std::uint64_t seed = 0; seed < test::seeds(10000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(expect_outputs_of_brute_force<2>(seed));
  }
}

TEST(MatchesPropertyTest, TenThousandScansInSpaceAreClassifiedAsBruteForceDoes) {
  for (std::uint64_t seed = 0; seed < test::seeds(10000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(expect_outputs_of_brute_force<3>(seed));
  }
}

}  // namespace
}  // namespace slamicp::matches_property_test
