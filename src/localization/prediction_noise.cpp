// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/localization/prediction_noise.hpp>

namespace slamicp {

std::string PredictionNoise::problem() const {
  if (const std::string in_odometry = odometry.problem(); !in_odometry.empty()) return in_odometry;
  if (!(odometry_scale >= 0.0 && odometry_scale <= 1.0)) return "odometry_scale must lie between 0 and 1";
  for (const double sigma : {least_translation, least_rotation, velocity_translation, velocity_rotation})
    if (!(sigma > 0.0 && std::isfinite(sigma))) return "what is added from scan to scan must be above 0";
  return {};
}

}  // namespace slamicp
