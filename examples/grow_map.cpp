// SPDX-License-Identifier: Apache-2.0
// A map that grows by outliers only, beside one that takes every point (the paper, sections 3.1 and 3.2, Figures 7b,
// 8b).
#include <cstdio>

#include <slamicp/map/point_map.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/scan/scan_points.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>

int main() {
  const slamicp::World world = slamicp::corridor_world();
  const slamicp::LidarModel lidar = slamicp::hokuyo_utm30lx();
  slamicp::Random random(1);
  const slamicp::Pose2 first{5.9, -2.5, 1.57};
  const slamicp::Pose2 second{6.3, -0.6, 1.2};
  const auto see = [&](const slamicp::Pose2& from) { return to_points(scan(world, from, lidar, random)).in_robot; };

  slamicp::PointCloud2 reference;  // M: the first scan, placed where it was taken
  for (const slamicp::Point2& point : see(first)) reference.push_back(first * point);
  const slamicp::PointMap2::Pointer map = slamicp::PointMap2::create(reference);

  slamicp::Icp<2> icp;  // T: the second scan, from about there
  const slamicp::IcpResult2& match =
      icp.align(map->indexed(), see(second), {6.2, -0.7, 1.25}, {.outliers_in_map = true, .transformed_scan = true});

  const auto thin = slamicp::update_with_outliers<2>(map, match);
  const auto thick = slamicp::update_with_all_points<2>(map, match);
  std::printf("%s\nM has %zu points; with all of T %zu, with its outliers only %zu\n", match.brief().c_str(),
              map->size(), thick->size(), thin->size());
  return thin->size() < thick->size() ? 0 : 1;
}
