// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include <slamicp/evaluation/scan_pair.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/scan/scan_points.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>

namespace slamicp {
namespace {

World room() {
  World world;
  world.name = "room";
  const PointCloud2 corners = {{-2.0, -1.5}, {4.0, -1.5}, {4.0, 5.0},  {1.6, 5.0},
                               {1.6, 1.5},   {-2.0, 1.5}, {-2.0, -1.5}};
  for (std::size_t k = 1; k < corners.size(); ++k) world.walls.push_back({corners[k - 1], corners[k]});
  return world;
}

ScanPair look(const World& world, const Pose2& first, const Pose2& second, double noise, std::uint64_t seed) {
  const LidarModel lidar = hokuyo_utm30lx(noise);
  Random random(seed);
  ScanPair pair;
  pair.M = to_points(scan(world, first, lidar, random)).in_robot;
  pair.T = to_points(scan(world, second, lidar, random)).in_robot;
  pair.truth = first.inverse() * second;
  pair.guess = pair.truth * Pose2{0.05, -0.05, 2.0 * rad_per_deg};
  return pair;
}

}  // namespace

ScanPair ideal_scan_pair() { return look(room(), {}, {1.5, 0.3, 0.6}, 0.0, 1); }

ScanPair corridor_scan_pair(std::uint64_t seed) {
  return look(corridor_world(), {5.9, -1.5, 0.5 * std::numbers::pi}, {6.2, 0.4, 0.9}, 0.01, seed);
}

MatchedPair match(ScanPair scans) {
  MatchedPair pair{std::move(scans), {}, {}, {}};
  pair.result = align<2>(pair.scans.T, pair.scans.M, pair.scans.guess, IcpOptions{.max_correspondence_distance = 0.3});
  for (std::size_t i = 0; i < pair.scans.T.size(); ++i)
    if (is_inlier(pair.result.matches[i].point_class)) pair.inliers.push_back(pair.result.transformed_scan[i]);
  pair.all_points_map = pair.scans.M;
  pair.all_points_map.insert(pair.all_points_map.end(), pair.result.transformed_scan.begin(),
                             pair.result.transformed_scan.end());
  return pair;
}

}  // namespace slamicp
