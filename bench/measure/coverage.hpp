// SPDX-License-Identifier: Apache-2.0
// How many truths are inside the ellipses of any share: what a calibration plot shows.
#pragma once

#include <cmath>

#include "support.hpp"

namespace slamicp::measure {

/// Chi-squared with three degrees of freedom: which share of errors has a NEES of at most this.
inline double share_below(double nees) {
  return std::erf(std::sqrt(0.5 * nees)) - std::sqrt(2.0 * nees / std::numbers::pi) * std::exp(-0.5 * nees);
}

/// For each share told, 5 % to 95 % and 99 %, the share that is really inside: [[told, inside], ...].
inline Json coverage(const std::vector<double>& nees) {
  Json curve = Json::array();
  for (int percent = 5; percent <= 100; percent += 5) {
    const double told = percent == 100 ? 0.99 : 0.01 * percent;
    const auto inside = std::count_if(nees.begin(), nees.end(), [&](double one) { return share_below(one) <= told; });
    const double all = std::max(1.0, static_cast<double>(nees.size()));
    curve.push_back({told, static_cast<double>(inside) / all});
  }
  return curve;
}

}  // namespace slamicp::measure
