// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "field.hpp"
#include "row.hpp"

namespace slamicp::bench {

/// Cells under a header, the first column to the left and numbers to the right.
class AlignedTable {
 public:
  explicit AlignedTable(std::vector<std::string> header) : rows_{std::move(header)} {}
  void add(std::vector<std::string> row);
  void print(std::FILE* out) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// The table of a race, and a line for each peer that is missing.
void print_rows(std::span<const Row> rows, std::FILE* out);
void print_missing(std::span<const Missing> missing, std::FILE* out);

Json to_json(std::span<const Row> rows);
Json to_json(std::span<const Missing> missing);

}  // namespace slamicp::bench
