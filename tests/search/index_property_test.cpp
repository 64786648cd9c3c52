// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/search/indexed_points.hpp>

#include "support/clouds.hpp"
#include "support/index_checks.hpp"

namespace slamicp::index_property_test {
namespace {

using test::Random;

/// A query near the cloud, on it, or no number.
template <int D>
Point<D> any_query(Random& random, const PointCloud<D>& cloud, const Point<D>& center) {
  Point<D> query = center + random.point<D>(2.5);
  const int kind = random.integer(0, 9);
  if (kind < 3 && !cloud.empty()) {
    const Point<D>& point = cloud[static_cast<std::size_t>(random.integer(0, static_cast<int>(cloud.size()) - 1))];
    query = kind == 0 ? point : point + random.point<D>(0.05);
  } else if (kind == 3) {
    query = center + (20.0 * random.point<D>(1.0)).array().round().matrix() * 0.05;  // between lattice points: ties
  } else if (kind == 4 && random.chance(0.1)) {
    query[0] = random.chance(0.5) ? test::nan : -test::infinity;
  }
  return query;
}

template <typename Dimension>
class IndexPropertyTest : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(IndexPropertyTest, Dimensions);

TYPED_TEST(IndexPropertyTest, KdTreeIsBruteForce) {
  constexpr int D = TypeParam::value;
  for (std::uint64_t seed = 0; seed < test::seeds(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Point<D> center = random.point<D>(random.chance(0.5) ? 0.0 : 500.0);
    const PointCloud<D> cloud = test::unkind_cloud<D>(random, random.integer(0, 300), center);
    const KdTree<D> tree(cloud);
    for (int k = 0; k < 60; ++k)
      ASSERT_NO_FATAL_FAILURE(test::expect_brute_force<D>(tree, cloud, any_query<D>(random, cloud, center),
                                                          random.chance(0.1) ? 1e9 : random.uniform(0.0, 1.5),
                                                          static_cast<std::size_t>(random.integer(0, 25))));
  }
}

TYPED_TEST(IndexPropertyTest, IndexedPointsAreBruteForceHoweverTheyGrew) {
  constexpr int D = TypeParam::value;
  for (std::uint64_t seed = 0; seed < test::seeds(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Point<D> center = random.point<D>(random.chance(0.5) ? 0.0 : 500.0);
    PointCloud<D> cloud = test::unkind_cloud<D>(random, random.integer(0, 100), center);
    IndexedPoints<D> index(cloud, {.neighbours = 0});
    const int growths = random.integer(0, 20);
    for (int growth = 0; growth < growths; ++growth) {
      const PointCloud<D> more = test::unkind_cloud<D>(random, random.integer(0, random.chance(0.2) ? 80 : 6), center);
      index = index.with_added(more);
      cloud.insert(cloud.end(), more.begin(), more.end());
      ASSERT_EQ(index.size(), cloud.size());
    }
    for (int k = 0; k < 60; ++k)
      ASSERT_NO_FATAL_FAILURE(test::expect_brute_force<D>(index, cloud, any_query<D>(random, cloud, center),
                                                          random.chance(0.1) ? 1e9 : random.uniform(0.0, 1.5),
                                                          static_cast<std::size_t>(random.integer(0, 25))));
  }
}

TYPED_TEST(IndexPropertyTest, TiesGoToTheLowerIndexWhateverTheRounding) {
  // Points on a line, coordinates and queries that do not square exactly: the box of a far subtree must never round to
  // beyond a point in it. Every coordinate stands there many times over.
  constexpr int D = TypeParam::value;
  for (std::uint64_t seed = 0; seed < test::seeds(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    PointCloud<D> cloud;
    std::vector<double> places;
    for (int k = 0; k < 6; ++k) places.push_back(random.uniform(-1.0, 1.0));
    for (int k = 0; k < 120; ++k) {
      Point<D> point = Point<D>::Constant(0.3);
      point[0] = places[static_cast<std::size_t>(random.integer(0, 5))];
      if (random.chance(0.3)) point[D - 1] = places[static_cast<std::size_t>(random.integer(0, 5))];
      cloud.push_back(point);
    }
    const KdTree<D> tree(cloud);
    for (int k = 0; k < 60; ++k) {
      Point<D> query = Point<D>::Constant(0.3);
      query[0] = random.uniform(-1.0, 1.0);
      ASSERT_NO_FATAL_FAILURE(
          test::expect_brute_force<D>(tree, cloud, query, 5.0, static_cast<std::size_t>(random.integer(1, 100))));
    }
  }
}

}  // namespace
}  // namespace slamicp::index_property_test
