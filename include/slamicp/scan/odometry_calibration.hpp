// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <slamicp/scan/odometry_model.hpp>

namespace slamicp {

/// A stretch of a drive: what the wheels told step by step, and how far the robot really got, by fixes at both ends.
template <class Reading>
struct DriveStretch {
  std::vector<Reading> readings;  ///< one after the other
  Pose2 T_start_end;              ///< inverse(fix at the start) * fix at the end
};

/// How well fixes are known, which weighs metres against radians.
struct CalibrationOptions {
  double fix_translation = 0.005;  ///< of a stretch's ends, 1 sigma [m], > 0
  double fix_rotation = 0.002;     ///< [rad], > 0

  /// The first rule broken, in words; empty if none is.
  std::string problem() const;
};

/// What a calibration found. Parameters, in this order: of a DifferentialDrive left and right radius and wheel
/// distance; of an OmniDrive the three radii and the base radius; of an OdometryScale as they are declared.
template <class Model>
struct OdometryCalibration {
  Model model;                 ///< that fits best; the nominal one where it is not determined
  std::vector<double> sigmas;  ///< of each parameter, 1 sigma, by the residuals
  double rms_before = 0.0;     ///< what the stretches' ends are off by the nominal model [m]
  double rms_after = 0.0;      ///< and by the calibrated one [m]
  /// False where the drive does not tell all parameters: too few stretches, never turned, never drove straight.
  bool determined = false;
};

/// Fits a model's parameters to a drive by least squares over the ends of its stretches, as Censi, Franchi,
/// Marchionni, Oriolo 2013 ("Simultaneous calibration of odometry and sensor parameters for mobile robots") do for two
/// wheels; by Gauss-Newton steps, so that it holds for any model. Stretches of 0.5 m to 2 m, some of them turning to
/// either side, serve best. O(readings). Throws Error for a nominal model or options with a problem().
OdometryCalibration<DifferentialDrive> calibrate(const DifferentialDrive& nominal,
                                                 std::span<const DriveStretch<WheelTurns<2>>> stretches,
                                                 const CalibrationOptions& options = {});
OdometryCalibration<OmniDrive> calibrate(const OmniDrive& nominal,
                                         std::span<const DriveStretch<WheelTurns<3>>> stretches,
                                         const CalibrationOptions& options = {});
/// Readings are the motions T_before_after that odometry reported.
OdometryCalibration<OdometryScale> calibrate(const OdometryScale& nominal,
                                             std::span<const DriveStretch<Pose2>> stretches,
                                             const CalibrationOptions& options = {});

}  // namespace slamicp
