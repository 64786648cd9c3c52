// SPDX-License-Identifier: Apache-2.0
#include "simulated.hpp"

#include <numbers>
#include <slamicp_node/marker.hpp>

#include <slamicp/map/occupancy_grid.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "room.hpp"

namespace slamicp::dds_peer {

using node::room;
using node::Stamp;

SimulatedRun drive() {
  World world = room();
  world.pillars.push_back({{6.0, 2.5}, 0.2});
  DriveOptions options;
  options.speed = 0.5;
  options.lidar.beams = 541;
  options.lidar.angle_increment = 270.0 / 540.0 * std::numbers::pi / 180.0;
  options.lidar.angle_min = -135.0 * std::numbers::pi / 180.0;
  options.lidar.rate = 10.0;
  options.lidar.sweep_time = 0.025;
  const std::vector<Point2> way{{2.0, 3.0}, {5.0, 4.0}, {9.5, 4.0}, {10.5, 2.5}};
  SimulatedRun run = simulate_drive(world, way, options);
  for (LaserScan& scan : run.scans) scan.stamp += 1000.0;
  return run;
}

PointCloud2 wall_samples() {
  Random random(1);
  return sample_map(room(), 0.02, 0.0, random);
}

node::Grid map_grid() {
  const OccupancyGrid cells = to_occupancy_grid(wall_samples(), {.resolution = 0.05, .origin = {0.025, 0.025, 0.0}});
  node::Grid grid;
  grid.frame = "map";
  grid.resolution = static_cast<double>(0.05F);  // as the message has it
  grid.width = cells.width;
  grid.height = cells.height;
  grid.origin = {cells.T_map_grid.x, cells.T_map_grid.y, 0.0};
  for (const CellState cell : cells.cells)
    grid.cells.push_back(cell == CellState::occupied ? std::int8_t{100}
                         : cell == CellState::free   ? std::int8_t{0}
                                                     : std::int8_t{-1});
  return grid;
}

node::Transform transform(double stamp, const std::string& frame, const std::string& child, const Pose2& pose) {
  return {Stamp::from_seconds(stamp), frame, child, {pose.x, pose.y, 0.0}, node::turn_by(pose.theta)};
}

node::Scan message_of(const LaserScan& scan, const Laser& laser) {
  node::Scan message;
  message.stamp = Stamp::from_seconds(scan.stamp);
  message.frame = laser.frame;
  message.angle_min = static_cast<float>(scan.angle_min - laser.turn);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  message.time_increment = static_cast<float>(scan.time_increment);
  message.range_min = 0.1F;
  message.range_max = 30.0F;
  message.ranges = scan.ranges.data();
  message.count = scan.ranges.size();
  return message;
}

}  // namespace slamicp::dds_peer
