// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <slamicp/scan/laser_scan.hpp>
#include <slamicp/simulation/random.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// A planar lidar, as its data sheet has it. Beam i points to `angle_min + i * angle_increment` in the laser's frame.
struct LidarModel {
  int beams = 1081;              ///< a sweep
  double angle_min = 0.0;        ///< direction of beam 0 [rad]
  double angle_increment = 0.0;  ///< > 0 [rad]; all beams together at most one turn
  double range_min = 0.1;        ///< nearer things give no return [m]
  double range_max = 30.0;       ///< so do things at this range and beyond [m]
  double rate = 40.0;            ///< sweeps a second [Hz]
  double sweep_time = 0.0;       ///< from the first beam to the last [s]; 0: all beams at one instant
  double range_noise = 0.01;     ///< standard deviation of a reading [m], the same at all ranges; 0 for exact ranges
  Pose2 T_robot_laser = {};      ///< where it sits on the robot
  double noise_per_metre = 0.0;  ///< what is added to range_noise for each metre of range [m/m]
  double bias = 0.0;             ///< largest systematic error [m], >= 0: the readings swing around the truth ...
  double bias_period = 7.0;      ///< ... once in so many metres of range [m], > 0
  double dropouts = 0.0;         ///< share of readings that are lost, in [0, 1]
  double mixed_pixels = 0.0;     ///< share of readings beside an edge that fall between near and far, in [0, 1]

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// The Hokuyo UTM-30LX of the paper's robot: 1,081 beams over 270 deg, 0.1 to 30 m, 40 Hz.
LidarModel hokuyo_utm30lx(double range_noise = 0.01);

/// The same as it really is: noise that grows from 10 mm with the range, 10 mm of systematic error, readings lost and
/// mixed at edges, and a sweep that takes 25 ms. Of the size that its data sheet and users report.
LidarModel real_hokuyo_utm30lx();

/// The exact distance that each beam travels to what it meets first: walls, pillars, doors as they stand, obstacles and
/// people [m]; infinity where it meets nothing. `ranges` keeps its memory from scan to scan.
///
/// People are where they are when each beam is measured: along a straight line, and with constant velocity, from where
/// they are at the first beam to where they are at the last, `sweep_time` later.
/// @param stamp  of the first beam [s]
///
/// A thing costs the beams that point at it, hidden or not, so a scan costs O(beams + things) for a usual world.
/// Throws Error for a model with a `problem()`.
void true_ranges(const World& world, const Pose2& T_map_laser, const LidarModel& lidar, std::vector<double>& ranges,
                 double stamp = 0.0);

/// The same for a laser that moves with constant velocity while it sweeps.
/// @param T_map_laser   at the first beam
/// @param T_first_last  its motion until the last beam: less than 1 m and 1 rad, and it turns by less than half of what
///                      it sweeps
void true_ranges(const World& world, const Pose2& T_map_laser, const Pose2& T_first_last, const LidarModel& lidar,
                 std::vector<double>& ranges, double stamp = 0.0);

/// One sweep with noise, the robot standing still meanwhile. No return is 0. Draws as many numbers a beam whatever it
/// meets, so the same seed gives the same noise with and without an obstacle.
/// @param stamp  of the first beam [s], where people are then; the scan has it
LaserScan scan(const World& world, const Pose2& T_map_robot, const LidarModel& lidar, Random& random,
               double stamp = 0.0);

/// The same while the robot moves.
/// @param T_map_robot   at the first beam
/// @param sweep_motion  the robot's motion until the last beam, as LaserScan has it; the scan is not told
LaserScan scan(const World& world, const Pose2& T_map_robot, const Pose2& sweep_motion, const LidarModel& lidar,
               Random& random, double stamp = 0.0);

}  // namespace slamicp
