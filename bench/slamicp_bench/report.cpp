// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include <algorithm>

namespace slamicp::bench {
namespace {

using measure::text;

std::string ratio(const Row& row, std::optional<double> reference_us) {
  return reference_us ? text("%.2f", row.median_us / *reference_us) : "-";
}

std::vector<std::string> cells(const Row& row, std::optional<double> reference_us) {
  return {row.name + (row.in_this_process ? "" : " *"),
          text("%.1f", row.median_us),
          text("%.1f", row.p99_us),
          ratio(row, reference_us),
          row.iterations ? text("%.1f", *row.iterations) : "-",
          text("%.2f / %.2f / %.2f", row.error_mm.mean, row.error_mm.p95, row.error_mm.max),
          text("%zu of %zu", row.failures, row.scans),
          row.outliers_mean ? text("%.1f", *row.outliers_mean) : "-",
          row.outlier_agreement ? text("%.4g %%", 100.0 * *row.outlier_agreement) : "-",
          text("%.1f", row.prepare_ms),
          row.what};
}

}  // namespace

void AlignedTable::add(std::vector<std::string> row) {
  row.resize(rows_.front().size(), "-");
  rows_.push_back(std::move(row));
}

void AlignedTable::print(std::FILE* out) const {
  std::vector<int> width(rows_.front().size(), 0);
  for (const auto& row : rows_)
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], static_cast<int>(row[k].size()));
  for (const auto& row : rows_) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool words = k == 0 || k + 1 == row.size();
      const bool last = k + 1 == row.size();
      std::fprintf(out, "%s%*s", k == 0 ? "" : "  ", last ? 0 : words ? -width[k] : width[k], row[k].c_str());
    }
    std::fprintf(out, "\n");
  }
}

void print_rows(std::span<const Row> rows, std::FILE* out) {
  AlignedTable table({"contender", "median us", "p99 us", "x ours", "iterations", "error mm mean / p95 / max", "failed",
                      "outliers", "exact sets", "prepare ms", "what"});
  const std::optional<double> reference_us = reference_median(rows);
  for (const Row& row : rows) table.add(cells(row, reference_us));
  table.print(out);
  if (std::any_of(rows.begin(), rows.end(), [](const Row& row) { return !row.in_this_process; }))
    std::fprintf(out, "* measured in another process\n");
}

void print_missing(std::span<const Missing> missing, std::FILE* out) {
  for (const Missing& peer : missing)
    std::fprintf(out, "missing: %s: %s; %s\n", peer.name.c_str(), peer.why.c_str(), peer.mend.c_str());
}

Json to_json(std::span<const Row> rows) {
  const std::optional<double> reference_us = reference_median(rows);
  Json all = Json::array();
  for (const Row& row : rows) all.push_back(to_json(row, reference_us));
  return all;
}

Json to_json(std::span<const Missing> missing) {
  Json all = Json::array();
  for (const Missing& peer : missing) all.push_back({{"name", peer.name}, {"why", peer.why}, {"mend", peer.mend}});
  return all;
}

}  // namespace slamicp::bench
