// SPDX-License-Identifier: Apache-2.0
// Accuracy on real and generated data (shared/data/MANIFEST.md), beside what others reach on the same.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/geometry/voxel_grid.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/scan/scan_points.hpp>

#include "support/clouds.hpp"
#include "support/data.hpp"

namespace slamicp::icp_data_test {
namespace {

using IcpDataTest = test::DataTest;

/// The errors of 300 scans in the corridor map, each matched from a guess of its own.
struct CorridorErrors {
  double mean = 0.0;
  double p95 = 0.0;
  int failures = 0;

  explicit CorridorErrors(const std::string& obstacle, const IcpOptions& options = {}) {
    const auto folder = test::data_dir() / "corridor";
    PointCloud2 points;
    for (const auto& row : test::read_numbers(folder / "map.csv")) points.emplace_back(row[0], row[1]);
    const IndexedPoints<2> map(points);
    const auto poses = test::read_numbers(folder / ("poses_" + obstacle + ".csv"));
    const auto ranges = test::read_numbers(folder / ("ranges_" + obstacle + ".csv"));
    EXPECT_EQ(poses.size(), 300U);
    EXPECT_EQ(ranges.size(), poses.size());

    LaserScan scan;
    scan.angle_min = -0.75 * test::pi;
    scan.angle_increment = 1.5 * test::pi / 1080.0;
    Icp<2> icp(options);
    std::vector<double> errors;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      scan.ranges.assign(ranges[k].begin(), ranges[k].end());
      const Pose2 truth{poses[k][0], poses[k][1], poses[k][2]};
      const Pose2 guess{poses[k][3], poses[k][4], poses[k][5]};
      const PoseDistance error = distance(icp.align(map, to_points(scan).in_robot, guess).pose, truth);
      errors.push_back(error.translation);
      failures += error.translation > 0.1 || error.rotation > test::pi / 180.0 ? 1 : 0;
      mean += error.translation / static_cast<double>(poses.size());
    }
    std::sort(errors.begin(), errors.end());
    p95 = errors[errors.size() * 95 / 100];
    std::printf("corridor, %s: mean %.2f mm, p95 %.2f mm, max %.2f mm, %d failed\n", obstacle.c_str(), 1e3 * mean,
                1e3 * p95, 1e3 * errors.back(), failures);
  }
};

TEST_F(IcpDataTest, CorridorIsLocalizedToAMillimetreWithAndWithoutTheBox) {
  for (const char* obstacle : {"none", "box"}) {
    const CorridorErrors errors(obstacle);
    EXPECT_LE(errors.mean, 0.0010);
    EXPECT_LE(errors.p95, 0.0022);
    EXPECT_EQ(errors.failures, 0);
  }
}

TEST_F(IcpDataTest, AConstantGateLetsTheBoxPullAsItDoesInOthers) {
  const CorridorErrors errors("box", {.final_gate = 0.3});
  EXPECT_GT(errors.p95, 0.008) << "else the shrinking gate would be for nothing";
}

PointCloud3 load(const char* name) { return load_cloud3((test::data_dir() / "registration" / name).string()); }

TEST_F(IcpDataTest, SmallGicpsPairIsAlignedAtThePeersAccuracyFromTheIdentity) {
  const PointCloud3 source = voxel_downsampled<3>(load("small_gicp_source.ply"), 0.25);
  const PointCloud3 target = voxel_downsampled<3>(load("small_gicp_target.ply"), 0.25);
  const auto rows = test::read_numbers(test::data_dir() / "registration" / "small_gicp_T_target_source.txt");
  Matrix<3, 3> rotation;
  Point3 translation;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) rotation(static_cast<int>(r), static_cast<int>(c)) = rows[r][c];
    translation[static_cast<int>(r)] = rows[r][3];
  }
  const Pose3 truth = Pose3::from(rotation, translation);
  const IndexedPoints<3> map(target, {.radius = 2.0});
  const auto error = [&](Method method) {
    const IcpOptions options{.method = method, .max_correspondence_distance = 1.0, .max_iterations = 100};
    const IcpResult3 result = Icp<3>(options).align(map, source, {}, {.mean_inlier_distance = true});
    EXPECT_TRUE(result.usable());
    const PoseDistance off = distance(result.pose, truth);
    std::printf("small_gicp's pair: %.1f mm, %.3f deg, %s\n", 1e3 * off.translation, off.rotation * 180.0 / test::pi,
                result.brief().c_str());
    EXPECT_LE(off.rotation, 0.35 * test::pi / 180.0);
    return off.translation;
  };
  EXPECT_LE(error(Method::point_to_point), 0.035);  // small_gicp 33 mm
  EXPECT_LE(error(Method::point_to_plane), 0.020);  // small_gicp 15 mm
}

TEST_F(IcpDataTest, BunnyPairIsAlignedFromTheIdentityAsPclDoesAndBothMethodsAgree) {
  const IndexedPoints<3> map(load("bun4.pcd"));
  const PointCloud3 source = load("bun0.pcd");
  const auto match = [&](Method method) {
    const IcpOptions options{.method = method, .max_correspondence_distance = 0.05, .max_iterations = 100};
    IcpResult3 result = Icp<3>(options).align(map, source, {}, {.mean_inlier_distance = true});
    EXPECT_TRUE(result.usable()) << "point-to-plane may end going to and fro between two sets of pairs, 0.3 mm apart";
    EXPECT_EQ(result.inliers, source.size());
    std::printf("bunny: %s\n", result.brief().c_str());
    return result;
  };
  const IcpResult3 point = match(Method::point_to_point);
  const IcpResult3 plane = match(Method::point_to_plane);
  EXPECT_LT(point.mean_inlier_distance, 0.006);
  EXPECT_LT(plane.mean_inlier_distance, 0.006);
  // What PCL's own test of its ICP notes for the same pair and the same distance, to three digits.
  EXPECT_LT((point.pose.position - Point3(0.03453, -0.001519, 0.04116)).norm(), 0.001);
  EXPECT_NEAR(point.pose.rotation()(0, 0), 0.8806, 0.002);
  EXPECT_NEAR(point.pose.rotation()(0, 2), -0.4724, 0.002);
  EXPECT_LT(distance(point.pose, plane.pose).translation, 0.005);
  EXPECT_LT(distance(point.pose, plane.pose).rotation, 3.0 * test::pi / 180.0);
}

}  // namespace
}  // namespace slamicp::icp_data_test
