// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp_node/messages.hpp>
#include <string>

#include <slamicp/simulation/drive.hpp>

/// What the simulated robot gives: its room, its way through it, and the messages of its sensors.
namespace slamicp::dds_peer {

constexpr node::Stamp before{999500000000};  // the first scan

/// What the map does not have stands beside the way.
SimulatedRun drive();
PointCloud2 wall_samples();
node::Grid map_grid();
node::Transform transform(double stamp, const std::string& frame, const std::string& child, const Pose2& pose);

/// Of a laser that sits turned by so much in the robot's middle, and sees what the simulated one sees.
struct Laser {
  std::string topic, frame;
  double turn = 0.0;  // [rad]
};

node::Scan message_of(const LaserScan& scan, const Laser& laser);

}  // namespace slamicp::dds_peer
