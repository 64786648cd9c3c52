// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace slamicp {

/// What to say about many errors of one kind, in their unit. All zero where there are none.
struct ErrorStatistics {
  std::size_t count = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< around the mean, divided by the count
  double rmse = 0.0;                ///< square root of the mean square
  double p95 = 0.0;                 ///< the smallest error that 95 % do not exceed
  double max = 0.0;
};

/// Of errors >= 0. O(count).
ErrorStatistics statistics_of(std::vector<double> errors);

}  // namespace slamicp
