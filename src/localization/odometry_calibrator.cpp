// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/localization/odometry_calibrator.hpp>

namespace slamicp {

// Long enough that a fix's noise is small beside what the wheels get wrong.
constexpr double stretch_metres = 1.0;
constexpr double stretch_radians = 1.0;

void OdometryCalibrator::add(const LaserScan& scan, const Fix& fix) {
  if (!scan.T_odom_robot || !scan.T_odom_robot->is_finite() || fix.stop() != Stop::converged) {
    last_odometry_.reset();
    return;
  }
  if (!last_odometry_) return start_at(scan, fix);
  const Pose2 moved = last_odometry_->inverse() * *scan.T_odom_robot;
  last_odometry_ = scan.T_odom_robot;
  stretch_.readings.push_back(moved);
  metres_ += moved.translation().norm();
  radians_ += std::abs(moved.theta);
  if (metres_ < stretch_metres && radians_ < stretch_radians) return;
  stretch_.T_start_end = start_.inverse() * fix.pose;
  stretches_.push_back(stretch_);
  start_at(scan, fix);
}

void OdometryCalibrator::start_at(const LaserScan& scan, const Fix& fix) {
  stretch_ = {};
  metres_ = radians_ = 0.0;
  last_odometry_ = scan.T_odom_robot;
  start_ = fix.pose;
}

OdometryCalibration<OdometryScale> OdometryCalibrator::calibration() const {
  return calibrate(OdometryScale{}, stretches_);
}

}  // namespace slamicp
