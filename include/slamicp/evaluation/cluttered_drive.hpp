// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <slamicp/map/point_map.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/scan/laser_scan.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/random.hpp>
#include <slamicp/simulation/wheel_odometry.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

struct ClutteredDriveOptions {
  double unmapped = 0.4;   ///< share of the rays that meet things the map does not know; a tenth more at most. [0, 0.8]
  bool moving = false;     ///< the things walk about, each straight on at 0.5 to 1.4 m/s, until it is near the robot
  int furniture_gone = 0;  ///< pieces that the map has and that are not there any more, at least 0
  double speed = 0.5;      ///< of the robot [m/s], > 0
  double scene_time = 1.0;  ///< after so long other things stand elsewhere [s], > 0
  OdometryNoise odometry{};

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// A robot that drives to and fro along a trial world's route, at its lidar's rate, among things that its map does not
/// know: a localizer that is given the first pose should neither lose it nor doubt it. The things keep 0.7 m off the
/// way of the scene.
class ClutteredDrive {
 public:
  /// Throws Error with options.problem(), or where there is no such trial world.
  ClutteredDrive(std::string_view world_name, std::uint64_t seed, const ClutteredDriveOptions& options = {});

  const PointMap2::Pointer& map() const noexcept { return map_; }
  /// Where the robot is: T_map_robot of the last scan, or of the first one to come.
  const Pose2& truth() const noexcept { return truth_; }

  /// The next scan, with odometry. Good until the next call.
  const LaserScan& next();

 private:
  Pose2 pose_at(int scan) const;
  void set_the_scene();
  bool is_fair(const World& scene) const;
  void let_things_walk();

  ClutteredDriveOptions options_;
  World world_;
  LidarModel lidar_;
  Random random_;
  PointMap2::Pointer map_;
  SplinePath path_;
  World now_;
  std::vector<Vector<2>> velocities_;  // of the things [m/s]
  Pose2 truth_;
  Pose2 odometry_;
  LaserScan scan_;
  int scans_ = 0;
  int scans_of_a_scene_;
};

}  // namespace slamicp
