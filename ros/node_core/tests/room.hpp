// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <vector>

#include <slamicp/simulation/drive.hpp>

namespace slamicp::node {

/// A room of 12 m x 8 m with a thing or two in it, so that a scan holds every direction: the fronts' tests have it too.
inline World room() {
  World world;
  const auto wall = [&](double ax, double ay, double bx, double by) { world.walls.push_back({{ax, ay}, {bx, by}}); };
  wall(0, 0, 12, 0), wall(12, 0, 12, 8), wall(12, 8, 0, 8), wall(0, 8, 0, 0);
  wall(4, 0, 4, 2), wall(8, 8, 8, 6.5), wall(8, 6.5, 10, 6.5);
  world.pillars.push_back({{3.0, 6.0}, 0.3});
  return world;
}

/// Through the room with a lidar of 541 beams, ten scans a second, stamped from 1000 s on.
/// @param sweep_time  of the lidar [s]
inline SimulatedRun drive_through(const World& world, double sweep_time) {
  DriveOptions options;
  options.speed = 0.5;
  options.lidar.beams = 541;
  options.lidar.angle_increment = 270.0 / 540.0 * std::numbers::pi / 180.0;
  options.lidar.angle_min = -135.0 * std::numbers::pi / 180.0;
  options.lidar.rate = 10.0;
  options.lidar.sweep_time = sweep_time;
  SimulatedRun run =
      simulate_drive(world, std::vector<Point2>{{2.0, 3.0}, {5.0, 4.0}, {9.5, 4.0}, {10.5, 2.5}}, options);
  for (LaserScan& scan : run.scans) scan.stamp += 1000.0;
  for (StampedPose& pose : run.truth) pose.stamp += 1000.0;
  return run;
}

}  // namespace slamicp::node
