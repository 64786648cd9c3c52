// SPDX-License-Identifier: Apache-2.0
// A robot builder's program: a corner of a room, a scan of it, and where the robot stands.
#include <cstdio>
#include <cstdlib>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/version.hpp>
#ifdef USE_IO
#include <slamicp/io/scan_log.hpp>
#endif

int main() {
  slamicp::PointCloud2 map;
  for (double s = 0.0; s < 5.0; s += 0.05) {
    map.emplace_back(s, 2.0);
    map.emplace_back(5.0, 2.0 - s);
  }
  const slamicp::Pose2 T_map_robot{0.1, -0.05, 0.03};
  slamicp::PointCloud2 scan;
  for (const slamicp::Point2& point : map) scan.push_back(T_map_robot.inverse() * point);

  const auto result = slamicp::align<2>(scan, map);
  const auto [metres, radians] = slamicp::distance(result.pose, T_map_robot);
  std::printf("slamicp %s: %s, %.6f m and %.6f rad off\n", slamicp::version, slamicp::to_string(result.pose).c_str(),
              metres, radians);
  if (!(metres < 0.02 && radians < 0.01)) return EXIT_FAILURE;

#ifdef USE_IO
  slamicp::LaserScan sweep;
  sweep.ranges.assign(181, 2.0F);
  slamicp::save_scan_log("consumer_log.csv", {&sweep, 1});
  if (slamicp::open_scan_log("consumer_log.csv").size() != 1) return EXIT_FAILURE;
#endif
}
