// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slamicp {

/// How well a map of the plane knows its lines: medians over a sample of them.
struct LineNoise {
  double across = 0.0;         ///< of a point from its line, 1 sigma [m]
  double window = 0.0;         ///< length of wall that a line is made from [m]
  double points = 1.0;         ///< that a line is made from
  double turn_variance = 0.0;  ///< of a line's direction by the points' noise [rad^2]

  /// The same with another noise of the points.
  LineNoise with(double sigma) const noexcept {
    LineNoise scaled = *this;
    scaled.across = sigma;
    scaled.turn_variance *= across > 0.0 ? sigma * sigma / (across * across) : 0.0;
    return scaled;
  }
};

}  // namespace slamicp
