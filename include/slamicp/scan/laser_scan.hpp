// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// One sweep of a planar lidar.
///
/// Beam i points to `angle_min + i * angle_increment` in the laser's frame (x ahead, y to the left,
/// counter-clockwise; a laser that turns clockwise has a negative increment), and was measured at
/// `stamp + i * time_increment`: the stamp is that of the first beam, as in ROS. A reading that is NaN, infinite, zero,
/// below `range_min` or at or above `range_max` is no return.
struct LaserScan {
  double stamp = 0.0;                 ///< when beam 0 was measured, in the clock of its log [s]
  double time_increment = 0.0;        ///< from one beam to the next [s]; 0: all at once, or not known
  double angle_min = 0.0;             ///< direction of beam 0 [rad]
  double angle_increment = 0.0;       ///< from one beam to the next [rad]
  double range_min = 0.0;             ///< readings below are no returns [m]
  double range_max = 1e9;             ///< readings at or above are no returns [m]
  std::vector<float> ranges;          ///< [m]
  Pose2 T_robot_laser;                ///< where the laser sits on the robot
  std::optional<Pose2> T_odom_robot;  ///< the robot's pose by its wheels at `stamp`, if known
  /// How far the robot moved, by its wheels, from the first beam to the last: T_first_last, if known.
  std::optional<Pose2> sweep_motion;
  int laser = 0;  ///< which of the robot's lasers, counted from 0
};

/// From the first beam to the last [s].
inline double sweep_time(const LaserScan& scan) noexcept {
  return scan.ranges.empty() ? 0.0 : scan.time_increment * static_cast<double>(scan.ranges.size() - 1);
}

/// Field of view, first beam to last [rad].
inline double field_of_view(const LaserScan& scan) noexcept {
  return scan.ranges.empty() ? 0.0 : scan.angle_increment * static_cast<double>(scan.ranges.size() - 1);
}

/// True where beam i came back.
inline bool is_return(const LaserScan& scan, float range) noexcept {
  // Limits as floats, as the readings are: a reading of 5.6 m must not pass below a limit of 5.6 m by its rounding.
  const auto limit = [](double metres) {
    return static_cast<float>(std::min<double>(metres, std::numeric_limits<float>::max()));
  };
  return range > 0.0F && range >= limit(scan.range_min) && range < limit(scan.range_max);
}

}  // namespace slamicp
