// SPDX-License-Identifier: Apache-2.0
// Localizes a log in a map and lists what stands there that the map does not know.
//   localize_log MAP LOG X Y THETA
#include <cstdio>
#include <cstdlib>

#include <slamicp/error.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>

int main(int argc, char** argv) try {
  if (argc != 6) return std::puts("localize_log MAP LOG X Y THETA"), 2;
  slamicp::Localizer localizer(slamicp::load_map(argv[1]), {.max_correspondence_distance = 0.3});
  localizer.set_pose({std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5])});  // x [m], y [m], heading [rad]

  for (const slamicp::LaserScan& scan : slamicp::open_scan_log(argv[2])) {
    const slamicp::Fix& fix = localizer.update(scan);  // noexcept, no allocation after the first
    if (!fix.usable()) continue;                       // fix.stop() says why
    for (const slamicp::Obstacle& obstacle : slamicp::find_obstacles(fix, scan))
      std::printf("%.3f s  %s\n", scan.stamp, obstacle.brief().c_str());
  }
  std::printf("ends at %s\n", to_string(localizer.fix().pose).c_str());
} catch (const slamicp::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
