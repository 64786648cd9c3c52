// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <slamicp/map/point_map.hpp>
#include <slamicp/registration/icp_result.hpp>
#include <slamicp/scan/scan_points.hpp>

namespace slamicp {

/// What one scan told: where the robot is, and what stands there that the map does not know.
///
/// It keeps its map snapshot alive. A Localizer hands out a reference to its own Fix, good until the next update; copy
/// it to keep it.
struct Fix {
  double stamp = 0.0;  ///< of the scan [s]
  /// T_map_robot; where nothing matched (no_overlap, too_few_points) the prediction. A blind direction of a degenerate
  /// match keeps the prediction too.
  Pose2 pose;
  Pose2 predicted;         ///< T_map_robot before the match, by odometry or constant velocity
  ScanPoints scan;         ///< the returns that were used, in the robot's frame, and their beams
  IcpResult2 match;        ///< indices count scan.in_robot
  PointMap2::Pointer map;  ///< the snapshot that was matched against

  Stop stop() const noexcept { return match.stop; }
  bool usable() const noexcept { return match.usable(); }
  const std::vector<int>& outliers() const noexcept { return match.outlier_indices; }
  const PointCloud2& outliers_in_map() const noexcept { return match.outliers_in_map; }

  /// One line: stop reason, pose, inliers and outliers.
  std::string brief() const { return match.brief(); }
};

}  // namespace slamicp
