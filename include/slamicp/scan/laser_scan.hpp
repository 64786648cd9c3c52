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
/// counter-clockwise). A reading that is NaN, infinite, zero, below `range_min` or at or above `range_max` is
/// no return.
struct LaserScan {
  double stamp = 0.0;                 ///< when the scan was taken, in the clock of its log [s]
  double angle_min = 0.0;             ///< direction of beam 0 [rad]
  double angle_increment = 0.0;       ///< from one beam to the next [rad]
  double range_min = 0.0;             ///< readings below are no returns [m]
  double range_max = 1e9;             ///< readings at or above are no returns [m]
  std::vector<float> ranges;          ///< [m]
  Pose2 T_robot_laser;                ///< where the laser sits on the robot
  std::optional<Pose2> T_odom_robot;  ///< the robot's pose by its wheels when the scan was taken, if known
};

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
