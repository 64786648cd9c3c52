// SPDX-License-Identifier: Apache-2.0
#include "simulated.hpp"

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
  return node::drive_through(world, 0.025);
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
