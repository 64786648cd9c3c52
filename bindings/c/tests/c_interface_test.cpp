// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <slamicp.h>
#include <string>
#include <thread>
#include <vector>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>
#include <slamicp/version.hpp>

#include "malformed_calls.h"

namespace slamicp::c_interface_test {
namespace {

void expect_same_bits(double c, double cpp) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(c), std::bit_cast<std::uint64_t>(cpp)) << c << " and " << cpp;
}

void expect_same_pose(const double* c, const Pose2& cpp) {
  expect_same_bits(c[0], cpp.x);
  expect_same_bits(c[1], cpp.y);
  expect_same_bits(c[2], cpp.theta);
}

void expect_same_points(const double* c, const PointCloud2& cpp) {
  for (std::size_t k = 0; k < cpp.size(); ++k)
    for (const int axis : {0, 1}) expect_same_bits(c[2 * k + static_cast<std::size_t>(axis)], cpp[k][axis]);
}

void expect_same_indices(const std::int32_t* c, std::size_t count, const std::vector<int>& cpp) {
  EXPECT_EQ(std::vector<int>(c, c + count), cpp);
}

/// The corridor's map, and scans of it with something new in it.
struct Scene {
  Scene() {
    Random random(5);
    map = sample_map(corridor_world(), 0.03, 0.01, random);
    LidarModel lidar = hokuyo_utm30lx();
    lidar.beams = 541;
    lidar.angle_increment = -2.0 * lidar.angle_min / 540.0;
    const World world = corridor_world_with("A2");
    for (int k = 0; k < 20; ++k)
      scans.push_back(slamicp::scan(world, start * Pose2{0.02 * k, 0.0, 0.005 * k}, lidar, random, 0.025 * k));
  }

  Pose2 start{9.0, 0.2, 0.1};
  Pose2 guess{9.05, 0.17, 0.13};
  PointCloud2 map;
  std::vector<LaserScan> scans;
};

slamicp_scan in_c(const LaserScan& scan) {
  slamicp_scan made;
  EXPECT_EQ(slamicp_scan_init(&made, sizeof made), SLAMICP_OK);
  made.stamp = scan.stamp;
  made.angle_min = scan.angle_min;
  made.angle_increment = scan.angle_increment;
  made.range_min = scan.range_min;
  made.range_max = scan.range_max;
  made.ranges = scan.ranges.data();
  made.count = scan.ranges.size();
  return made;
}

TEST(CInterfaceTest, MalformedCallsAreRefusedWithWords) {
  const malformed_calls calls = make_malformed_calls();
  EXPECT_GE(calls.made, 200);
  EXPECT_EQ(calls.wrong, 0) << calls.first_wrong;
}

TEST(CInterfaceTest, AMatchIsTheSameBitForBit) {
  const Scene scene;
  const PointCloud2 scan = to_points(scene.scans.front()).in_robot;
  const double guess[3] = {scene.guess.x, scene.guess.y, scene.guess.theta};
  for (const std::int32_t method : {SLAMICP_POINT_TO_POINT, SLAMICP_POINT_TO_LINE}) {
    slamicp_icp_options options;
    ASSERT_EQ(slamicp_icp_options_init(&options, sizeof options), SLAMICP_OK);
    options.method = method;
    options.outlier_distance = 0.1;
    slamicp_icp* icp = nullptr;
    ASSERT_EQ(slamicp_icp_create(&options, &icp), SLAMICP_OK) << slamicp_last_error();
    slamicp_result result;
    slamicp_result_init(&result, sizeof result);
    ASSERT_EQ(slamicp_icp_align_points(icp, 2, scene.map.front().data(), scene.map.size(), scan.front().data(),
                                       scan.size(), guess, SLAMICP_ALL_OUTPUTS, &result),
              SLAMICP_OK)
        << slamicp_last_error();

    const IcpResult2 expected =
        align(scan, scene.map, scene.guess, {.method = static_cast<Method>(method), .outlier_distance = 0.1});
    ASSERT_TRUE(expected.usable());
    ASSERT_GT(expected.outlier_indices.size(), 10U);
    EXPECT_EQ(result.usable, 1);
    expect_same_pose(result.pose, expected.pose);
    expect_same_bits(result.transform[2], expected.pose.x);
    expect_same_bits(result.transform[3], expected.pose.rotation()(1, 0));
    expect_same_bits(result.mean_inlier_distance, expected.mean_inlier_distance);
    EXPECT_EQ(result.iterations, expected.iterations);
    EXPECT_EQ(result.inliers, expected.inliers);
    ASSERT_EQ(result.outliers, expected.outlier_indices.size());
    expect_same_indices(result.outlier_indices, result.outliers, expected.outlier_indices);
    expect_same_points(result.outliers_in_map, expected.outliers_in_map);
    ASSERT_EQ(result.points, expected.transformed_scan.size());
    expect_same_points(result.transformed_scan, expected.transformed_scan);
    ASSERT_EQ(result.updated_map_points, expected.updated_map.size());
    expect_same_points(result.updated_map, expected.updated_map);
    for (std::size_t k = 0; k < result.points; ++k) {
      EXPECT_EQ(result.matches[k].map_index, expected.matches[k].map_index);
      EXPECT_EQ(result.matches[k].point_class, static_cast<std::int32_t>(expected.matches[k].point_class));
    }
    slamicp_icp_free(icp);
  }
}

TEST(CInterfaceTest, ALocalizerIsTheSameBitForBit) {
  const Scene scene;
  slamicp_map* map = nullptr;
  ASSERT_EQ(slamicp_map_create(2, scene.map.front().data(), scene.map.size(), nullptr, &map), SLAMICP_OK);
  slamicp_localizer_options options;
  slamicp_localizer_options_init(&options, sizeof options);
  options.outlier_distance = 0.1;
  slamicp_localizer* localizer = nullptr;
  ASSERT_EQ(slamicp_localizer_create(map, &options, &localizer), SLAMICP_OK) << slamicp_last_error();
  slamicp_map_free(map);  // the localizer keeps it
  const double start[3] = {scene.start.x, scene.start.y, scene.start.theta};
  ASSERT_EQ(slamicp_localizer_set_pose(localizer, start), SLAMICP_OK);

  Localizer expected(PointMap2::create(scene.map), {.outlier_distance = 0.1});
  expected.set_pose(scene.start);
  slamicp_fix fix;
  slamicp_fix_init(&fix, sizeof fix);
  std::size_t obstacles_seen = 0;
  for (const LaserScan& scan : scene.scans) {
    const slamicp_scan given = in_c(scan);
    ASSERT_EQ(slamicp_localizer_update(localizer, &given, &fix), SLAMICP_OK) << slamicp_last_error();
    const Fix& found = expected.update(scan);
    EXPECT_EQ(fix.usable, 1);
    expect_same_pose(fix.pose, found.pose);
    expect_same_bits(fix.covariance[4], found.covariance(1, 1));
    expect_same_bits(fix.probability, found.quality.probability);
    expect_same_indices(fix.outlier_indices, fix.outliers, found.outliers());
    expect_same_indices(fix.beams, fix.points, found.scan.beams);
    expect_same_points(fix.outliers_in_map, found.outliers_in_map());

    std::size_t count = 0;
    ASSERT_EQ(slamicp_localizer_find_obstacles(localizer, nullptr, &count), SLAMICP_OK);
    const std::vector<Obstacle> obstacles = find_obstacles(found, scan);
    ASSERT_EQ(count, obstacles.size());
    obstacles_seen += count;
    for (std::size_t k = 0; k < count; ++k) {
      slamicp_obstacle obstacle;
      slamicp_obstacle_init(&obstacle, sizeof obstacle);
      ASSERT_EQ(slamicp_localizer_obstacle(localizer, k, &obstacle), SLAMICP_OK);
      expect_same_bits(obstacle.width, obstacles[k].box.width);
      expect_same_indices(obstacle.point_indices, obstacle.points, obstacles[k].points);
      expect_same_bits(obstacle.nearest[0], obstacles[k].nearest.x());
      expect_same_bits(obstacle.shape_centre[1], obstacles[k].shape.centre.y());
      expect_same_bits(obstacle.shape_width, obstacles[k].shape.width);
      expect_same_bits(obstacle.radius, obstacles[k].shape.radius);
      EXPECT_STREQ(slamicp_shape_name(obstacle.shape), to_string(obstacles[k].shape.kind));
      EXPECT_STREQ(slamicp_ray_class_name(obstacle.ray_class), to_string(obstacles[k].ray_class));
      EXPECT_EQ(obstacle.width_seen != 0, obstacles[k].shape.width_seen);
    }
  }
  EXPECT_GT(obstacles_seen, 0U);
  slamicp_localizer_free(localizer);
}

Pose3 in_space(const double* pose) {
  Pose3 made;
  made.position = {pose[0], pose[1], pose[2]};
  made.orientation = Eigen::AngleAxisd(pose[5], Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(pose[4], Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(pose[3], Eigen::Vector3d::UnitX());
  return made;
}

TEST(CInterfaceTest, InSpacePosesAreRollPitchYaw) {
  Random random(3);
  const double truth[6] = {0.05, -0.04, 0.03, 0.03, -0.02, 0.05};
  const Pose3 T_map_robot = in_space(truth);
  PointCloud3 corner, seen;
  for (int k = 0; k < 4000; ++k) {
    Point3 point(random.uniform(0.0, 3.0), random.uniform(0.0, 3.0), random.uniform(0.0, 3.0));
    point[k % 3] = 0.0;  // on the floor or one of two walls
    corner.push_back(point);
    seen.push_back(T_map_robot.inverse() * point);
  }
  slamicp_map* map = nullptr;
  slamicp_icp* icp = nullptr;
  slamicp_result result;
  slamicp_result_init(&result, sizeof result);
  ASSERT_EQ(slamicp_map_create(3, corner.front().data(), corner.size(), nullptr, &map), SLAMICP_OK);
  ASSERT_EQ(slamicp_icp_create(nullptr, &icp), SLAMICP_OK);
  const double guess[6] = {0.0, 0.0, 0.0, 0.01, 0.0, 0.02};
  ASSERT_EQ(slamicp_icp_align(icp, map, seen.front().data(), seen.size(), guess, 0, &result), SLAMICP_OK)
      << slamicp_last_error();
  EXPECT_EQ(result.dimension, 3);
  EXPECT_EQ(result.stop, SLAMICP_CONVERGED);
  EXPECT_EQ(result.outlier_indices, nullptr);
  const IcpResult3 expected = align(seen, corner, in_space(guess));
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      expect_same_bits(result.transform[4 * row + column], expected.pose.rotation()(row, column));
      EXPECT_NEAR(in_space(result.pose).rotation()(row, column), expected.pose.rotation()(row, column), 1e-12);
    }
    expect_same_bits(result.transform[4 * row + 3], expected.pose.position[row]);
    expect_same_bits(result.pose[row], expected.pose.position[row]);
  }
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(result.pose[k], truth[k], 0.005) << k;  // planes bend at the edges
  EXPECT_EQ(result.transform[15], 1.0);
  slamicp_icp_free(icp);
  slamicp_map_free(map);
}

TEST(CInterfaceTest, MapsGrowAndAnswer) {
  const double square[8] = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0};
  slamicp_map *map = nullptr, *grown = nullptr;
  ASSERT_EQ(slamicp_map_create(2, square, 4, nullptr, &map), SLAMICP_OK);
  const double more[2] = {0.5, 0.5};
  ASSERT_EQ(slamicp_map_with_added(map, more, 1, &grown), SLAMICP_OK);
  EXPECT_EQ(slamicp_map_size(map), 4U);
  EXPECT_EQ(slamicp_map_size(grown), 5U);
  EXPECT_EQ(slamicp_map_dimension(grown), 2);
  EXPECT_EQ(slamicp_map_points(grown)[8], 0.5);
  std::int32_t index = 0;
  double distance = 0.0;
  const double query[2] = {0.55, 0.5};
  ASSERT_EQ(slamicp_map_nearest(grown, query, 0.3, &index, &distance), SLAMICP_OK);
  EXPECT_EQ(index, 4);
  EXPECT_NEAR(distance, 0.05, 1e-12);
  ASSERT_EQ(slamicp_map_nearest(map, query, 0.3, &index, &distance), SLAMICP_OK);
  EXPECT_EQ(index, -1);
  EXPECT_EQ(distance, std::numeric_limits<double>::infinity());
  slamicp_map_free(map);
  slamicp_map_free(grown);
  slamicp_map_free(nullptr);
  EXPECT_EQ(slamicp_map_size(nullptr), 0U);
}

TEST(CInterfaceTest, PointsAsFarAsAllowedAreNoTrouble) {
  const double corners[8] = {-1e6, -1e6, 1e6, 1e6, 1e6, -1e6, 0.0, 0.0};
  slamicp_map* map = nullptr;
  ASSERT_EQ(slamicp_map_create(2, corners, 4, nullptr, &map), SLAMICP_OK) << slamicp_last_error();
  std::int32_t index = 0;
  double distance = 0.0;
  ASSERT_EQ(slamicp_map_nearest(map, corners + 2, 0.3, &index, &distance), SLAMICP_OK);
  EXPECT_EQ(index, 1);
  slamicp_map_free(map);
}

TEST(CInterfaceTest, EachThreadHasItsOwnLastError) {
  EXPECT_EQ(slamicp_icp_create(nullptr, nullptr), SLAMICP_NULL_POINTER);
  const std::string mine = slamicp_last_error();
  std::string others = "not empty";
  std::thread([&] { others = slamicp_last_error(); }).join();
  EXPECT_EQ(others, "");
  EXPECT_EQ(slamicp_last_error(), mine);
  EXPECT_NE(mine, "");
}

TEST(CInterfaceTest, AStructOfANewerHeaderMayBeLarger) {
  struct Newer {
    slamicp_icp_options known;
    double more;
  } newer;
  ASSERT_EQ(slamicp_icp_options_init(&newer.known, sizeof newer), SLAMICP_OK);
  EXPECT_EQ(newer.more, 0.0);
  slamicp_icp* icp = nullptr;
  EXPECT_EQ(slamicp_icp_create(&newer.known, &icp), SLAMICP_OK) << slamicp_last_error();
  slamicp_icp_free(icp);
}

TEST(CInterfaceTest, NamesAndVersion) {
  EXPECT_STREQ(slamicp_version(), slamicp::version);
  EXPECT_STREQ(slamicp_status_name(SLAMICP_BAD_POSE), "bad_pose");
  EXPECT_STREQ(slamicp_status_name(static_cast<slamicp_status>(10)), "unknown");
  EXPECT_STREQ(slamicp_stop_name(SLAMICP_NO_OVERLAP), "no_overlap");
  EXPECT_STREQ(slamicp_stop_name(-1), "unknown");
  EXPECT_STREQ(slamicp_state_name(SLAMICP_LOST), "lost");
  EXPECT_STREQ(slamicp_state_name(4), "unknown");
  EXPECT_STREQ(slamicp_shape_name(SLAMICP_SHAPE_CIRCLE), "circle");
  EXPECT_STREQ(slamicp_shape_name(4), "unknown");
  EXPECT_STREQ(slamicp_ray_class_name(SLAMICP_RAY_GONE), "gone");
  EXPECT_STREQ(slamicp_ray_class_name(-1), "unknown");
}

}  // namespace
}  // namespace slamicp::c_interface_test
