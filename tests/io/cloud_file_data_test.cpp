// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/relations_file.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::cloud_file_data_test {
namespace {

TEST(CloudFileData, PublicClouds) {
  struct Case {
    const char* name;
    std::size_t points;
    int dimension;
  };
  for (const auto& [name, points, dimension] :
       {Case{"registration/small_gicp_source.ply", 69792, 3}, Case{"registration/small_gicp_target.ply", 69088, 3},
        Case{"registration/bun0.pcd", 397, 3}, Case{"registration/bun4.pcd", 361, 3},
        Case{"registration/lpm_2D_oneBox.csv", 361, 2}, Case{"registration/lpm_2D_twoBoxes.csv", 361, 2},
        Case{"corridor/map.csv", 10402, 2}}) {
    SLAMICP_NEEDS_DATA(path, name);
    const Cloud cloud = load_cloud(path);
    EXPECT_EQ(cloud.size(), points) << name;
    EXPECT_EQ(cloud.dimension(), dimension) << name;
    EXPECT_TRUE(cloud.warnings.empty()) << name;
  }
}

TEST(CloudFileData, FirstPoints) {
  SLAMICP_NEEDS_DATA(bunny, "registration/bun0.pcd");
  EXPECT_EQ(load_cloud3(bunny).front(), Point3(0.0054215998, 0.11349, 0.040748999));
  SLAMICP_NEEDS_DATA(boxes, "registration/lpm_2D_twoBoxes.csv");
  EXPECT_EQ(load_cloud2(boxes).front(), Point2(0.286, 0.886));
}

TEST(CloudFileData, Relations) {
  SLAMICP_NEEDS_DATA(intel, "slam_benchmark/intel.relations");
  EXPECT_EQ(load_relations(intel).size(), 2984U);
  SLAMICP_NEEDS_DATA(fr079, "slam_benchmark/fr079.relations");
  const std::vector<Relation> relations = load_relations(fr079);
  ASSERT_EQ(relations.size(), 1685U);
  EXPECT_EQ(relations[0].stamp_b, 1217.490267);
  EXPECT_EQ(relations[0].T_a_b.theta, -0.06962);
}

}  // namespace
}  // namespace slamicp::cloud_file_data_test
