// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "measure/support.hpp"
#include "scene.hpp"

namespace slamicp::bench {

using measure::Json;

struct Spread {
  double mean = 0.0;
  double p95 = 0.0;
  double max = 0.0;
};
Spread spread_of(const std::vector<double>& values);

/// A contender's line of the table, and its entry in the JSON.
struct Row {
  std::string name;
  std::string what;
  bool in_this_process = true;
  std::size_t samples = 0;  ///< times measured
  double median_us = 0.0;
  double p99_us = 0.0;
  double prepare_ms = 0.0;           ///< all that is built once
  std::optional<double> iterations;  ///< mean
  std::size_t scans = 0;             ///< judged
  std::size_t failures = 0;
  Spread error_mm;
  Spread rotation_deg;
  std::optional<double> outliers_mean;
  std::optional<double> outlier_agreement;        ///< share of scans whose outliers are exactly those at its own pose
  std::optional<double> outlier_point_agreement;  ///< share of points
};

/// Lost is who ends farther from the truth than 0.1 m or 1 deg.
bool is_failure(const PoseDistance& error);

/// Errors, failures, iterations and outliers of the estimates, one for each of the first trials.
void judge(const Scene& scene, std::span<const Estimate> estimates, Row& row);

/// The median of the contender that all times are compared with; none where it did not run.
std::optional<double> reference_median(std::span<const Row> rows);

Json to_json(const Row& row, std::optional<double> reference_us);
/// Throws nlohmann::json::exception where something is absent or of the wrong kind.
Row row_from(const Json& json);

}  // namespace slamicp::bench
