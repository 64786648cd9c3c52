// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"

#include <algorithm>

#include "field.hpp"
#include "oracle.hpp"

namespace slamicp::bench {
namespace {

Json to_json(const Spread& spread) { return {{"mean", spread.mean}, {"p95", spread.p95}, {"max", spread.max}}; }

Spread spread_from(const Json& json) {
  return {json.at("mean").get<double>(), json.at("p95").get<double>(), json.at("max").get<double>()};
}

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::optional<double> number_or_null(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return std::nullopt;
  return found->get<double>();
}

/// How many points one list has that the other has not.
std::size_t differences(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> only_one;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only_one));
  return only_one.size();
}

void judge_outliers(const Scene& scene, std::span<const Estimate> estimates, Row& row) {
  const OutlierOracle oracle(*scene.map, gate);
  std::size_t outliers = 0, points = 0, wrong = 0, exact_scans = 0;
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const PointCloud2& scan = scene.trials[k].scan;
    const std::size_t wrong_here = differences(*estimates[k].outliers, oracle.outliers(scan, estimates[k].pose));
    outliers += estimates[k].outliers->size();
    points += scan.size();
    wrong += wrong_here;
    exact_scans += wrong_here == 0 ? 1U : 0U;
  }
  const auto scans = static_cast<double>(estimates.size());
  row.outliers_mean = static_cast<double>(outliers) / scans;
  row.outlier_agreement = static_cast<double>(exact_scans) / scans;
  row.outlier_point_agreement =
      1.0 - static_cast<double>(wrong) / static_cast<double>(std::max<std::size_t>(points, 1));
}

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  return {measure::mean(values), measure::quantile(values, 0.95), measure::quantile(values, 1.0)};
}

bool is_failure(const PoseDistance& error) {
  return !(error.translation <= 0.1 && deg_per_rad * error.rotation <= 1.0);
}

void judge(const Scene& scene, std::span<const Estimate> estimates, Row& row) {
  std::vector<double> error_mm, rotation_deg, iterations;
  row.scans = estimates.size();
  row.failures = 0;
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const PoseDistance error = distance(estimates[k].pose, scene.trials[k].truth);
    error_mm.push_back(1e3 * error.translation);
    rotation_deg.push_back(deg_per_rad * error.rotation);
    iterations.push_back(estimates[k].iterations);
    row.failures += is_failure(error) ? 1U : 0U;
  }
  row.error_mm = spread_of(error_mm);
  row.rotation_deg = spread_of(rotation_deg);
  row.iterations = measure::mean(iterations);
  if (!estimates.empty() && estimates.front().outliers) judge_outliers(scene, estimates, row);
}

std::optional<double> reference_median(std::span<const Row> rows) {
  for (const Row& row : rows)
    if (row.name == reference_name) return row.median_us;
  return std::nullopt;
}

Json to_json(const Row& row, std::optional<double> reference_us) {
  return {{"name", row.name},
          {"what", row.what},
          {"process", row.in_this_process ? "this" : "another"},
          {"samples", row.samples},
          {"median_us", row.median_us},
          {"p99_us", row.p99_us},
          {"ratio_to_ours", reference_us ? Json(row.median_us / *reference_us) : Json(nullptr)},
          {"prepare_ms", row.prepare_ms},
          {"iterations", or_null(row.iterations)},
          {"scans", row.scans},
          {"failures", row.failures},
          {"error_mm", to_json(row.error_mm)},
          {"rotation_deg", to_json(row.rotation_deg)},
          {"outliers_mean", or_null(row.outliers_mean)},
          {"outlier_agreement", or_null(row.outlier_agreement)},
          {"outlier_point_agreement", or_null(row.outlier_point_agreement)}};
}

Row row_from(const Json& json) {
  Row row;
  row.name = json.at("name").get<std::string>();
  row.what = json.at("what").get<std::string>();
  row.in_this_process = false;
  row.samples = json.at("samples").get<std::size_t>();
  row.median_us = json.at("median_us").get<double>();
  row.p99_us = json.at("p99_us").get<double>();
  row.prepare_ms = json.at("prepare_ms").get<double>();
  row.iterations = number_or_null(json, "iterations");
  row.scans = json.at("scans").get<std::size_t>();
  row.failures = json.at("failures").get<std::size_t>();
  row.error_mm = spread_from(json.at("error_mm"));
  row.rotation_deg = spread_from(json.at("rotation_deg"));
  row.outliers_mean = number_or_null(json, "outliers_mean");
  row.outlier_agreement = number_or_null(json, "outlier_agreement");
  row.outlier_point_agreement = number_or_null(json, "outlier_point_agreement");
  return row;
}

}  // namespace slamicp::bench
