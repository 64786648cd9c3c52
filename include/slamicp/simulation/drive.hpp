// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <slamicp/geometry/trajectory.hpp>
#include <slamicp/scan/laser_scan.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/robot.hpp>
#include <slamicp/simulation/wheel_odometry.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

struct DriveOptions {
  double speed = 0.35;                  ///< along the path [m/s], > 0; the paper drove at 0.15 to 0.55
  std::uint64_t seed = 1;               ///< of all noise; another seed is another run
  LidarModel lidar = hokuyo_utm30lx();  ///< its rate says how many scans there are
  OdometryNoise odometry = {};          ///< what the wheels get wrong

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// What a log of the drive would hold, and what really happened.
struct SimulatedRun {
  std::vector<LaserScan> scans;  ///< with `T_odom_robot`, which starts at (0, 0, 0) in a frame of its own
  Trajectory truth;              ///< T_map_robot, one a scan, with the scan's stamp
};

/// Drives a robot along the smooth curve through the waypoints, looking where it goes, at constant speed from the first
/// to the last, and scans on the way: scan i is stamped i / rate [s].
///
/// Where the lidar has a sweep time, the robot moves while it sweeps. People are where they are at each stamp. Lidar
/// and wheels draw from streams of their own, so another lidar leaves the odometry as it is. The same arguments give
/// the same bytes with every compiler and level of optimization; where they fuse multiplications with additions
/// (-march=native, ARM) they are others in the last bits. The robot has no body: keeping the path clear of walls is up
/// to the caller. Throws Error for options with a `problem()` and for waypoints that make no path.
SimulatedRun simulate_drive(const World& world, std::span<const Point2> waypoints, const DriveOptions& options = {});

/// The same on three wheels that slip: the robot steers by where it really is along the curve, slows down in bends and
/// before the end, and drives as PathTracker has it; its odometry is that of its wheels' encoders (options.odometry has
/// no say). Throws Error where a sweep takes longer than there is between two, too, and where the robot does not get to
/// the end in ten times what the way takes at full speed, and a minute.
SimulatedRun simulate_drive(const World& world, std::span<const Point2> waypoints, const OmniRobotModel& robot,
                            const DriveOptions& options = {});

}  // namespace slamicp
