// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <slamicp/localization/quality.hpp>
#include <slamicp/map/point_map.hpp>
#include <slamicp/registration/icp_result.hpp>
#include <slamicp/scan/scan_points.hpp>

namespace slamicp {

/// What a blind direction of a fix follows.
enum class Carrier {
  scan,      ///< there is none: the scan holds every direction
  odometry,  ///< the wheels
  velocity,  ///< the motion of before: nothing measured
};

/// "scan", "odometry", "velocity"
const char* to_string(Carrier carrier) noexcept;

/// What one scan told: where the robot is, and what stands there that the map does not know.
///
/// It keeps its map snapshot alive. A Localizer hands out a reference to its own Fix, good until the next update; copy
/// it to keep it.
struct Fix {
  double stamp = 0.0;  ///< of the scan [s]
  /// T_map_robot; where nothing matched (no_overlap, too_few_points) the prediction. A blind direction of a degenerate
  /// match keeps the prediction too.
  Pose2 pose;
  Pose2 predicted;  ///< T_map_robot before the match, by odometry or constant velocity
  ScanPoints scan;  ///< the returns that were used, in the robot's frame, and their beams
  /// Where the rays of each joined scan start, in the robot's frame [m].
  PointCloud2 ray_origins;
  IcpResult2 match;        ///< indices count scan.in_robot
  PointMap2::Pointer map;  ///< the snapshot that was matched against
  /// Of the pose, prediction and match fused; of the error as seen from the robot: T_map_robot = truth * exp(error),
  /// error = (x ahead, y to the left, theta) [m, m, rad]. Where Outputs::covariance was asked for, else zero. Scan to
  /// scan it is that of the match with the scan before.
  Matrix<3, 3> covariance = Matrix<3, 3>::Zero();
  /// What the direction is carried by that the scan does not hold. With Outputs::covariance.
  Carrier carried_by = Carrier::scan;
  Vector<2> blind_direction = Vector<2>::Zero();  ///< unit vector in the map; zero where there is none
  Quality quality;                                ///< whether the pose is right at all

  /// `degenerate` only where nothing measured carries a blind direction: with odometry it has converged.
  Stop stop() const noexcept { return match.stop; }
  /// True if the pose can be used: every direction is held by the scan or carried by odometry.
  bool usable() const noexcept { return match.usable(); }
  /// True where nothing tells where the robot is: its scan fits nothing, or its pose is lost. It had better stand.
  bool nowhere() const noexcept {
    return match.stop == Stop::no_overlap || match.stop == Stop::too_few_points || quality.state == TrackingState::lost;
  }
  /// The covariance along the map's axes: of (x, y) in the map [m] and the heading [rad].
  Matrix<3, 3> covariance_in_map() const noexcept;
  const std::vector<int>& outliers() const noexcept { return match.outlier_indices; }
  const PointCloud2& outliers_in_map() const noexcept { return match.outliers_in_map; }

  /// One line: stop reason, pose, inliers and outliers.
  std::string brief() const { return match.brief(); }
};

}  // namespace slamicp
