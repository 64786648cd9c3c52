// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <slamicp/agent/agent.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/robot.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

struct AgentDriveOptions {
  OmniRobotModel robot = apr02();
  LidarModel lidar = real_hokuyo_utm30lx();
  /// Its tracking.delay is that of robot and lidar, whatever it says here.
  AgentOptions agent = {};
  std::uint64_t seed = 1;        ///< of all noise; another seed is another drive
  double start = 0.0;            ///< where on the path it begins [m]
  double most_seconds = 3600.0;  ///< it ends then, if not at the end of the path [s], > 0

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// One control cycle of the drive; all of it good during the call only.
struct DriveMoment {
  const LaserScan& scan;     ///< with T_odom_robot and sweep_motion
  const Pose2& T_map_robot;  ///< where the robot really was at the scan's stamp
  const Cycle& cycle;        ///< what the agent made of it
};

/// How a drive ended.
struct AgentDriveResult {
  bool finished = false;  ///< at the end of the path
  double seconds = 0.0;   ///< that it took
};

/// A robot that drives a path by its agent, in a world where the agent's commands move it: what the laser sees depends
/// on what the agent decides. The agent starts where the robot really stands. A scan is swept while the robot moves,
/// and the command that follows from it is given once it is complete.
///
/// The same arguments give the same drive. Throws Error for options with a problem().
/// @param each  is called after every cycle; false ends the drive
AgentDriveResult drive_agent(const World& world, PointMap2::Pointer map, std::shared_ptr<const SplinePath> path,
                             const AgentDriveOptions& options, const std::function<bool(const DriveMoment&)>& each,
                             Clock clock = {});

}  // namespace slamicp
