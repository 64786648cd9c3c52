// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/simulation/random.hpp>

namespace slamicp {

/// What wheels get wrong. The variance of the random part grows with the way travelled, so it is the same whether a
/// metre is measured in one step or in a hundred; the systematic part is what a calibration would remove.
struct OdometryNoise {
  double translation_sigma = 0.01;          ///< ahead and sideways, after one metre [m]
  double rotation_sigma_per_metre = 0.005;  ///< after one metre [rad]
  double rotation_sigma_per_radian = 0.02;  ///< after turning one radian [rad]
  double translation_scale_error = 0.01;    ///< metres too many in a metre; negative: too few
  double rotation_scale_error = 0.01;       ///< radians too many in a radian; negative: too few
  double rotation_drift_per_metre = 0.003;  ///< veers to the left, unequal wheels [rad/m]; negative: to the right

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// Wheels that measure every motion exactly.
OdometryNoise no_odometry_noise();

/// What the wheels report for a small true motion T_before_after.
Pose2 measured_motion(const Pose2& T_before_after, const OdometryNoise& noise, Random& random) noexcept;

}  // namespace slamicp
