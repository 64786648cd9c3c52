// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include "../../src/registration/correspondences.hpp"
#include "support/brute_force.hpp"
#include "support/clouds.hpp"

namespace slamicp::correspondences_property_test {
namespace {

using test::Random;

/// What was known about a scan point when it was last searched.
template <int D>
struct Known {
  bool searched = false;
  Point<D> at = Point<D>::Zero();
  int neighbour = -1;
  double second = 0.0;  // distance of the nearest map point but `neighbour`, not above the slack
};

/// Walks scan points through a map: every answer must be brute force's, and a search may only be made where the
/// neighbour is not certain without.
template <int D>
void walk(std::uint64_t seed) {
  Random random(seed);
  const Point<D> center = random.point<D>(random.chance(0.5) ? 0.0 : 500.0);
  const PointCloud<D> cloud = test::unkind_cloud<D>(random, random.integer(0, 60), center);
  const IndexedPoints<D> map(cloud, {.neighbours = 0});
  const double reach = random.uniform(0.05, 0.8);
  constexpr std::size_t points = 10;
  PointCloud<D> positions(points);
  for (Point<D>& position : positions) position = center + random.point<D>(2.2);
  positions[3][0] = test::nan;

  Correspondences<D> correspondences;
  correspondences.reset(map, positions, reach);
  EXPECT_EQ(correspondences.usable_points(), points - 1);
  EXPECT_FALSE(correspondences.finite(3));

  std::vector<Known<D>> known(points);
  for (int step = 0; step < 30; ++step) {
    const double size = std::pow(10.0, random.uniform(-6.0, -0.5));
    for (std::size_t i = 0; i < points; ++i) {
      if (i == 3) continue;
      positions[i] += random.point<D>(size);
      const bool classify = random.chance(0.3);
      const double threshold = random.uniform(0.01, reach);

      Known<D>& before = known[i];
      const double others = before.second - (positions[i] - before.at).norm();
      const double kept = before.neighbour < 0
                              ? test::infinity
                              : (cloud[static_cast<std::size_t>(before.neighbour)] - positions[i]).norm();
      constexpr double rounding = 1e-8;
      const bool surely_known =
          before.searched && (kept < others - rounding || std::min(kept, others) > reach + rounding);

      const std::size_t searches = correspondences.searches();
      if (classify) {
        ASSERT_EQ(correspondences.closer_than(i, positions[i], threshold),
                  test::nearest_of_all<D>(cloud, positions[i], threshold).found());
      } else {
        const Neighbour expected = test::nearest_of_all<D>(cloud, positions[i], reach);
        const Neighbour found = correspondences.nearest(i, positions[i]);
        ASSERT_EQ(found.index, expected.index);
        ASSERT_EQ(found.squared_distance, expected.squared_distance);
      }
      const std::size_t made = correspondences.searches() - searches;
      ASSERT_LE(made, surely_known ? 0U : 1U) << "kept " << kept << " others " << others << " reach " << reach;
      if (made == 0) continue;
      const auto all = test::all_within<D>(cloud, positions[i], 1.1 * reach);
      before = {true, positions[i], all.empty() ? -1 : all[0].index,
                all.size() > 1 ? std::sqrt(all[1].squared_distance) : 1.1 * reach};
    }
  }
}

TEST(CorrespondencesPropertyTest, AreBruteForceAndSearchOnlyWhereTheNeighbourMayHaveChanged2D) {
  for (std::uint64_t seed = 0; seed < test::seeds(600); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(walk<2>(seed));
  }
}

TEST(CorrespondencesPropertyTest, AreBruteForceAndSearchOnlyWhereTheNeighbourMayHaveChanged3D) {
  for (std::uint64_t seed = 0; seed < test::seeds(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(walk<3>(seed));
  }
}

TEST(CorrespondencesPropertyTest, APointThatStandsStillIsSearchedOnce) {
  const IndexedPoints<2> map(test::sharp_shape<2>());
  const PointCloud2 scan{{0.1, 0.2}, {50.0, 50.0}};
  Correspondences<2> correspondences;
  correspondences.reset(map, scan, 0.3);
  for (int k = 0; k < 10; ++k)
    for (std::size_t i = 0; i < 2; ++i) correspondences.nearest(i, scan[i]);
  EXPECT_EQ(correspondences.searches(), 2U);
}

}  // namespace
}  // namespace slamicp::correspondences_property_test
