// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <slamicp/localization/fix.hpp>
#include <slamicp/scan/laser_scan.hpp>
#include <slamicp/scan/odometry_calibration.hpp>

namespace slamicp {

/// Compares what the wheels told with where the fixes were, along a run: what odometry gets wrong all the time.
class OdometryCalibrator {
 public:
  /// Takes a scan, which must carry T_odom_robot to count, and its fix. A fix that is not converged ends the stretch.
  void add(const LaserScan& scan, const Fix& fix);

  /// How odometry should be scaled, see OdometryScale; not determined where the run was too short or never turned.
  OdometryCalibration<OdometryScale> calibration() const;

 private:
  void start_at(const LaserScan& scan, const Fix& fix);

  std::vector<DriveStretch<Pose2>> stretches_;
  DriveStretch<Pose2> stretch_;
  double metres_ = 0.0;   // of the stretch, by the wheels
  double radians_ = 0.0;  // turned to either side
  std::optional<Pose2> last_odometry_;
  Pose2 start_;  // T_map_robot where the stretch began
};

}  // namespace slamicp
