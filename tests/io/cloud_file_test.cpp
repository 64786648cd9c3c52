// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/io/cloud_file.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::cloud_file_test {
namespace {

using io_test::expect_error;
using io_test::put;
using io_test::TemporaryFolder;

const PointCloud3 three_d{{1.0 / 3.0, 2.0, -3.0}, {10000.000001, 1e-7, 0.5}};
const PointCloud2 two_d{{1.0 / 3.0, 2.0}, {10000.000001, -1e-7}};

TEST(CloudFile, RoundTripsEveryFormat) {
  const TemporaryFolder folder;
  for (const char* name : {"a.csv", "a.xyz", "a.txt", "a.pcd", "a.PLY"})
    for (const CloudEncoding encoding : {CloudEncoding::ascii, CloudEncoding::binary}) {
      save_cloud(folder / name, three_d, encoding);
      EXPECT_EQ(load_cloud(folder / name).dimension(), 3) << name;
      const PointCloud3 back = load_cloud3(folder / name);
      ASSERT_EQ(back.size(), 2U) << name;
      for (std::size_t i = 0; i < 2; ++i) EXPECT_LT((back[i] - three_d[i]).norm(), 2e-8) << name;
      expect_error([&] { load_cloud2(folder / name); }, (folder / name).string(), "is a 3D cloud");

      save_cloud(folder / name, two_d, encoding);
      EXPECT_EQ(load_cloud(folder / name).dimension(), 2) << name;
      const PointCloud2 flat = load_cloud2(folder / name);
      ASSERT_EQ(flat.size(), 2U) << name;
      for (std::size_t i = 0; i < 2; ++i) EXPECT_LT((flat[i] - two_d[i]).norm(), 2e-8) << name;
      EXPECT_EQ(load_cloud3(folder / name)[0].z(), 0.0);
    }
}

TEST(CloudFile, BinaryKeepsEveryBit) {
  const TemporaryFolder folder;
  for (const char* name : {"a.pcd", "a.ply"}) {
    save_cloud(folder / name, three_d, CloudEncoding::binary);
    EXPECT_EQ(load_cloud3(folder / name), three_d);
  }
}

TEST(CloudFile, LeavesOutWhatIsNotFiniteAndSaysSo) {
  const TemporaryFolder folder;
  for (const char* name : {"a.csv", "a.pcd", "a.ply"}) {
    PointCloud3 points = three_d;
    points.insert(points.begin(), {NAN, 0, 1});
    points.push_back({INFINITY, 0, 1});
    save_cloud(folder / name, points);
    const Cloud cloud = load_cloud(folder / name);
    EXPECT_EQ(cloud.size(), 2U);
    ASSERT_EQ(cloud.warnings.size(), 1U);
    EXPECT_EQ(cloud.warnings[0], "2 points with NaN or infinite coordinates: left out");
  }
}

TEST(CloudFile, AFlatCloudIs2DWhateverItsHeight) {
  const TemporaryFolder folder;
  put(folder / "a.csv", "1,2,1.5\n3,4,1.5\n");
  const Cloud cloud = load_cloud(folder / "a.csv");
  EXPECT_EQ(cloud.dimension(), 2);
  EXPECT_EQ(cloud.warnings.at(0), "z is the same in every point: taken as 2D");
  EXPECT_EQ(load_cloud3(folder / "a.csv")[1].z(), 1.5);
}

TEST(CloudFile, UnknownEndings) {
  expect_error([] { load_cloud("a.las"); }, "a.las", "ending '.las'");
  expect_error([] { save_cloud("a.las", two_d); }, "a.las", "ending '.las'");
}

}  // namespace
}  // namespace slamicp::cloud_file_test
