// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/search/indexed_points.hpp>

#include "support/clouds.hpp"

namespace slamicp::line_trust_test {
namespace {

using test::Random;

/// A wall along y = 0 and, from `leaf` on, both faces of something 4 cm thick, a centimetre of noise on all.
struct WallAndLeaf {
  PointCloud2 points;
  std::size_t leaf = 0;

  explicit WallAndLeaf(double noise = 0.01) {
    Random random(3);
    for (int k = 0; k < 800; ++k) points.emplace_back(0.0086 * k, random.normal(noise));
    leaf = points.size();
    for (int k = 0; k < 100; ++k)
      for (const double face : {2.0, 2.04}) points.emplace_back(0.0086 * k, face + random.normal(noise));
  }

  double mean_trust(const IndexedPoints<2>& map, std::size_t begin, std::size_t end) const {
    double sum = 0.0;
    std::size_t lines = 0;
    for (std::size_t k = begin; k < end; ++k) {
      if (!map.surface(k).valid()) continue;
      sum += map.surface(k).trust;
      ++lines;
    }
    return sum / static_cast<double>(lines);
  }
};

TEST(LineTrustTest, WhatIsNoWallCountsLittle) {
  const WallAndLeaf world;
  const IndexedPoints<2> map(world.points);
  EXPECT_GT(world.mean_trust(map, 0, world.leaf), 0.9);
  EXPECT_LT(world.mean_trust(map, world.leaf, world.points.size()), 0.4);
  for (std::size_t k = 0; k < world.points.size(); ++k) {
    EXPECT_GT(map.surface(k).trust, 0.0);
    EXPECT_LE(map.surface(k).trust, 1.0);
    EXPECT_NEAR(map.surface(k).normal.norm(), map.surface(k).valid() ? 1.0 : 0.0, 1e-5);
  }
}

TEST(LineTrustTest, ASparseMapTrustsAll) {
  const WallAndLeaf world;
  const IndexedPoints<2> map(world.points, SurfaceOptions::sparse());
  EXPECT_EQ(world.mean_trust(map, 0, world.points.size()), 1.0);
}

TEST(LineTrustTest, WhatIsAddedIsTrusted) {
  const WallAndLeaf world;
  const IndexedPoints<2> wall(PointCloud2(world.points.begin(), world.points.begin() + 800));
  const IndexedPoints<2> grown = wall.with_added(PointCloud2(world.points.begin() + 800, world.points.end()));
  EXPECT_EQ(world.mean_trust(grown, world.leaf, world.points.size()), 1.0);
  for (std::size_t k = 0; k < world.leaf; ++k) EXPECT_EQ(grown.surface(k).trust, wall.surface(k).trust);
}

TEST(LineTrustTest, WallsThinnerThanACentimetreAreNoMeasureForTheOthers) {
  WallAndLeaf world(1e-4);
  const IndexedPoints<2> map(world.points);
  Random random(4);
  PointCloud2 with_a_real_one = world.points;
  for (int k = 0; k < 100; ++k) with_a_real_one.emplace_back(0.0086 * k, 4.0 + random.normal(0.007));
  const IndexedPoints<2> mixed(with_a_real_one);
  EXPECT_GT(world.mean_trust(mixed, world.points.size(), with_a_real_one.size()), 0.99);
}

TEST(LineTrustTest, AnAbsurdScatterIsRefused) {
  SurfaceOptions options;
  options.scatter = 0.0;
  EXPECT_THROW(IndexedPoints<2>(PointCloud2{{0, 0}}, options), Error);
}

}  // namespace
}  // namespace slamicp::line_trust_test
