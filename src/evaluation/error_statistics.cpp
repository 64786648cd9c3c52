// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/evaluation/error_statistics.hpp>

namespace slamicp {

ErrorStatistics statistics_of(std::vector<double> errors) {
  ErrorStatistics statistics;
  statistics.count = errors.size();
  if (errors.empty()) return statistics;

  const auto count = static_cast<double>(errors.size());
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (const double error : errors) {
    sum += error;
    sum_of_squares += error * error;
    statistics.max = std::max(statistics.max, error);
  }
  statistics.mean = sum / count;
  statistics.rmse = std::sqrt(sum_of_squares / count);
  double sum_of_deviations = 0.0;
  for (const double error : errors) sum_of_deviations += (error - statistics.mean) * (error - statistics.mean);
  statistics.standard_deviation = std::sqrt(sum_of_deviations / count);

  const auto rank = (errors.size() * 95 + 99) / 100;  // rounded up: the nearest-rank definition
  const auto p95 = errors.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(errors.begin(), p95, errors.end());
  statistics.p95 = *p95;
  return statistics;
}

}  // namespace slamicp
