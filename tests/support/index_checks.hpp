// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "support/brute_force.hpp"
#include "support/random.hpp"

namespace slamicp::test {

/// Asks an index all that it can answer.
template <int D, typename Index>
void expect_brute_force(const Index& index, const PointCloud<D>& cloud, const Point<D>& query, double reach,
                        std::size_t k) {
  const std::vector<Neighbour> all = all_within<D>(cloud, query, reach);

  const Neighbour nearest = index.nearest(query, reach);
  ASSERT_EQ(nearest.index, all.empty() ? -1 : all[0].index);
  ASSERT_EQ(nearest.squared_distance, all.empty() ? infinity : all[0].squared_distance);

  const NearestTwo two = index.nearest_two(query, reach);
  ASSERT_EQ(two.nearest.index, nearest.index);
  ASSERT_EQ(two.nearest.squared_distance, nearest.squared_distance);
  // Valid, and as tight as it can be: the second nearest, or the reach.
  ASSERT_EQ(two.others_squared_distance, all.size() > 1 ? all[1].squared_distance : reach * reach);

  std::vector<Neighbour> found(k);
  ASSERT_EQ(index.nearest_k(query, reach, found), std::min(k, all.size()));
  for (std::size_t j = 0; j < std::min(k, all.size()); ++j) {
    ASSERT_EQ(found[j].index, all[j].index);
    ASSERT_EQ(found[j].squared_distance, all[j].squared_distance);
  }

  std::vector<int> within{-7};  // it appends
  index.within(query, reach, within);
  ASSERT_EQ(within[0], -7);
  std::sort(within.begin() + 1, within.end());
  std::vector<int> expected{-7};
  for (const Neighbour& one : all) expected.push_back(one.index);
  std::sort(expected.begin() + 1, expected.end());
  ASSERT_EQ(within, expected);
}

/// The nearest point alone: for queries by the thousand.
template <int D, typename Index>
void expect_nearest(const Index& index, const PointCloud<D>& cloud, const Point<D>& query, double reach) {
  const Neighbour expected = nearest_of_all<D>(cloud, query, reach);
  const Neighbour nearest = index.nearest(query, reach);
  ASSERT_EQ(nearest.index, expected.index) << "at " << query.transpose() << " within " << reach;
  ASSERT_EQ(nearest.squared_distance, expected.squared_distance);
}

}  // namespace slamicp::test
