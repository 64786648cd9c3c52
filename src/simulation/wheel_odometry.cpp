// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/simulation/wheel_odometry.hpp>

namespace slamicp {

std::string OdometryNoise::problem() const {
  for (const double sigma : {translation_sigma, rotation_sigma_per_metre, rotation_sigma_per_radian})
    if (!(sigma >= 0.0 && std::isfinite(sigma))) return "a standard deviation must be 0 or more";
  for (const double error : {translation_scale_error, rotation_scale_error, rotation_drift_per_metre})
    if (!std::isfinite(error)) return "a systematic error is not a finite number";
  return {};
}

OdometryNoise no_odometry_noise() { return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }

Pose2 measured_motion(const Pose2& T_before_after, const OdometryNoise& noise, Random& random) noexcept {
  Pose2::Tangent motion = T_before_after.log();
  const double distance = std::hypot(motion[0], motion[1]);
  const double turned = std::abs(motion[2]);
  const double translation_sigma = noise.translation_sigma * std::sqrt(distance);
  const double rotation_sigma = std::sqrt(noise.rotation_sigma_per_metre * noise.rotation_sigma_per_metre * distance +
                                          noise.rotation_sigma_per_radian * noise.rotation_sigma_per_radian * turned);
  // One statement each: the order of the draws is part of what a seed means.
  const double ahead = translation_sigma * random.normal();
  const double sideways = translation_sigma * random.normal();
  const double turn = rotation_sigma * random.normal();
  motion[0] += noise.translation_scale_error * motion[0] + ahead;
  motion[1] += noise.translation_scale_error * motion[1] + sideways;
  motion[2] += noise.rotation_scale_error * motion[2] + noise.rotation_drift_per_metre * distance + turn;
  return Pose2::exp(motion);
}

}  // namespace slamicp
