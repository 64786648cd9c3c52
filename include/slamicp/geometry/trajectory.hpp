// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// Where the robot was, and when.
struct StampedPose {
  double stamp = 0.0;  ///< in the clock of the log [s]
  Pose2 pose;          ///< T_map_robot
};

/// Poses in the order of their log: stamps usually rise, but need not.
using Trajectory = std::vector<StampedPose>;

/// The way from pose to pose [m].
inline double path_length(const Trajectory& trajectory) noexcept {
  double length = 0.0;
  for (std::size_t k = 1; k < trajectory.size(); ++k)
    length += distance(trajectory[k - 1].pose, trajectory[k].pose).translation;
  return length;
}

/// What a surveyor says about two moments of a log: the pose at `stamp_b` as seen from the pose at `stamp_a`
/// (Kuemmerle et al. 2009, "On measuring the accuracy of SLAM algorithms").
struct Relation {
  double stamp_a = 0.0;  ///< [s]
  double stamp_b = 0.0;  ///< [s]
  Pose2 T_a_b;           ///< inverse(T_map_a) * T_map_b
};

}  // namespace slamicp
