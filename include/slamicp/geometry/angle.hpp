// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace slamicp {

inline constexpr double rad_per_deg = std::numbers::pi / 180.0;
inline constexpr double deg_per_rad = 180.0 / std::numbers::pi;

/// The direction of a line, which is the same after half a turn: in (-pi/2, pi/2] [rad].
inline double wrap_half_turn(double angle) noexcept {
  const double wrapped = std::remainder(angle, std::numbers::pi);
  return wrapped <= -std::numbers::pi / 2.0 ? wrapped + std::numbers::pi : wrapped;
}

}  // namespace slamicp
