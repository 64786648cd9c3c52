// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <thread>

#include <slamicp/error.hpp>
#include <slamicp/map/point_map.hpp>
#include <slamicp/registration/icp.hpp>

#include "support/clouds.hpp"

namespace slamicp::point_map_test {
namespace {

/// A scan of the mapped room with an unmapped shelf in it.
struct Scene {
  PointMap2::Pointer map = PointMap2::create(test::sharp_shape<2>());
  std::size_t shelf = 0;
  IcpResult2 result;

  Scene() {
    const PointCloud2 unmapped = test::wall({0.0, -0.1}, {0.6, 0.0}, 0.01);
    shelf = unmapped.size();
    PointCloud2 seen = to_cloud(map->points());
    test::append(seen, unmapped);
    const Pose2 truth{0.2, 0.1, 0.3};
    result =
        Icp<2>().align(map->indexed(), test::transformed(truth.inverse(), seen), {0.21, 0.09, 0.31}, Outputs::all());
  }
};

TEST(PointMapTest, ASnapshotNeverChangesWhileItsUpdatesCountVersions) {
  const Scene scene;
  const PointCloud2 before = to_cloud(scene.map->points());
  const PointMap2::Pointer second = update_with_outliers(scene.map, scene.result);
  const PointMap2::Pointer third = second->with_added(PointCloud2{{9, 9}});
  EXPECT_EQ(to_cloud(scene.map->points()), before);
  EXPECT_EQ(scene.map->version(), 0U);
  EXPECT_EQ(second->version(), 1U);
  EXPECT_EQ(third->version(), 2U);
  EXPECT_EQ(third->size(), second->size() + 1);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), third->points().begin())) << "numbers stay";
  EXPECT_EQ(third->indexed().nearest({9, 9.1}, 0.2).index, static_cast<int>(second->size()));
  EXPECT_FALSE(second->indexed().nearest({9, 9.1}, 0.2).found());
}

TEST(PointMapTest, OnlyTheOutliersAreAddedOrEveryPoint) {
  // Figures 8b and 7b of the paper: M + outliers, M + T.
  const Scene scene;
  ASSERT_EQ(scene.result.outliers_in_map.size(), scene.shelf);
  const std::size_t mapped = scene.map->size();
  EXPECT_EQ(update_with_outliers(scene.map, scene.result)->size(), mapped + scene.shelf);
  EXPECT_EQ(update_with_all_points(scene.map, scene.result)->size(), mapped + mapped + scene.shelf);
}

TEST(PointMapTest, TheUpdateIsTheResultsUpdatedMap) {
  const Scene scene;
  EXPECT_EQ(to_cloud(update_with_outliers(scene.map, scene.result)->points()), scene.result.updated_map);
}

TEST(PointMapTest, WhatWasAddedIsNoOutlierAnyMore) {
  const Scene scene;
  const PointMap2::Pointer map = update_with_outliers(scene.map, scene.result);
  IcpResult2 again = Icp<2>().align(map->indexed(), scene.result.transformed_scan, {}, Outputs::all());
  EXPECT_TRUE(again.outlier_indices.empty());
  EXPECT_EQ(update_with_outliers(map, again), map) << "nothing new: the same snapshot";
}

TEST(PointMapTest, AnOldSnapshotServesWhileANewOneIsMade) {
  const Scene scene;
  PointMap2::Pointer grown;
  IcpResult2 meanwhile;
  {
    const std::jthread maker([&] {
      grown = scene.map;
      for (int k = 0; k < 20; ++k) grown = grown->with_added(PointCloud2{{0.01 * k, 5.0}, {0.01 * k, 5.1}});
    });
    Icp<2> icp;
    for (int k = 0; k < 20; ++k)
      meanwhile = icp.align(scene.map->indexed(), scene.map->points(), {0.01, 0.02, 0.01}, Outputs::all());
  }
  EXPECT_EQ(meanwhile.stop, Stop::converged);
  EXPECT_EQ(meanwhile.inliers, scene.map->size());
  EXPECT_EQ(grown->size(), scene.map->size() + 40);
  EXPECT_EQ(grown->version(), 20U);
}

TEST(PointMapTest, AMapLivesAsLongAsSomebodyHoldsIt) {
  PointMap2::Pointer map = PointMap2::create(test::sharp_shape<2>());
  const std::weak_ptr<const PointMap2> old = map;
  map = map->with_added(PointCloud2{{1, 1}});
  EXPECT_TRUE(old.expired());
}

TEST(PointMapTest, AMapOfNothingIsRefused) {
  for (const PointCloud2& cloud : {PointCloud2{}, PointCloud2{{test::nan, 0}, {0, test::infinity}}}) {
    try {
      PointMap2::create(cloud);
      ADD_FAILURE() << "taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), "PointMap::create");
      EXPECT_FALSE(error.mend().empty());
    }
  }
  EXPECT_EQ(PointMap3::create({{0, 0, 0}})->size(), 1U);
}

}  // namespace
}  // namespace slamicp::point_map_test
