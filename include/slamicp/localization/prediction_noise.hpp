// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <slamicp/scan/odometry_model.hpp>

namespace slamicp {

/// How unsure it is where a robot has got to since its last fix.
struct PredictionNoise {
  /// The random part of odometry.
  MotionNoise odometry{};
  /// The systematic part: the share by which odometry's metres and radians are wrong all the time, 1 sigma. Where
  /// nothing holds the pose this error grows with the way, not with its root. In [0, 1].
  double odometry_scale = 0.03;
  /// From scan to scan, however little the robot moved: stamps, slip at rest, a push. 1 sigma, [m] and [rad], > 0.
  double least_translation = 0.001;
  double least_rotation = 0.0005;
  /// Without odometry, from scan to scan, by constant velocity. Large, so that it is a start for the match and no more,
  /// but in a direction that the match does not hold. 1 sigma, [m] and [rad], > 0.
  double velocity_translation = 0.05;
  double velocity_rotation = 0.05;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

}  // namespace slamicp
