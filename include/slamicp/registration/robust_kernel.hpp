// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace slamicp {

/// How much a residual counts as it grows (Zhang 1997, "Parameter estimation techniques", table 1).
enum class RobustKernel {
  none,           ///< w = 1: least squares
  huber,          ///< w = 1 up to the scale, then scale / |r|
  cauchy,         ///< w = 1 / (1 + (r/scale)^2)
  geman_mcclure,  ///< w = 1 / (1 + (r/scale)^2)^2
  tukey,          ///< w = (1 - (r/scale)^2)^2 up to the scale, then 0
};

/// The weight of a residual in iteratively reweighted least squares, in [0, 1].
/// @param residual  [m]
/// @param scale     [m], above 0: where the kernel begins to doubt
inline double kernel_weight(RobustKernel kernel, double residual, double scale) noexcept {
  const double ratio = residual / scale;
  const double square = ratio * ratio;
  switch (kernel) {
    case RobustKernel::none:
      return 1.0;
    case RobustKernel::huber:
      return square <= 1.0 ? 1.0 : 1.0 / std::abs(ratio);
    case RobustKernel::cauchy:
      return 1.0 / (1.0 + square);
    case RobustKernel::geman_mcclure:
      return 1.0 / ((1.0 + square) * (1.0 + square));
    case RobustKernel::tukey:
      return square < 1.0 ? (1.0 - square) * (1.0 - square) : 0.0;
  }
  return 1.0;
}

}  // namespace slamicp
