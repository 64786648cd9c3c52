// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/registration/uncertainty.hpp>

namespace slamicp {

std::string PointNoise::problem() const {
  if (!(range >= 0.0 && range <= 1.0)) return "noise.range must lie between 0 m (from the residuals) and 1 m";
  if (!(map >= 0.0 && map <= 1.0)) return "noise.map must lie between 0 m (from the map) and 1 m";
  if (!(least_range >= 1e-5 && least_range <= 1.0)) return "noise.least_range must lie between 1e-5 m and 1 m";
  return {};
}

}  // namespace slamicp
