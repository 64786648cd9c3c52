// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace slamicp {

/// Gives each row at most one column and each column at most one row, so that the sum of their costs and of what rows
/// cost that are given none is least.
///
/// Rows and columns that no allowed pair connects are solved apart, most of them at sight; the others by shortest
/// augmenting paths (Jonker, Volgenant 1987; Crouse 2016, "On implementing 2D rectangular assignment algorithms"),
/// O(rows^2 (rows + columns)) of each group. Of equal sums, always the same one.
class Assignment {
 public:
  /// Room for so many rows and columns: up to these, nothing is allocated.
  void reserve(std::size_t rows, std::size_t columns);

  /// Forgets all pairs.
  void start(std::size_t rows, std::size_t columns);
  /// Row and column may be paired at that cost, which must be below `unpaired`. Each pair once.
  void allow(std::size_t row, std::size_t column, double cost);
  /// The column of each row, -1: none. Good until the next start().
  /// @param unpaired  what a row without a column costs
  std::span<const int> solve(double unpaired);

 private:
  struct Pair {
    int row;
    int column;
    double cost;
  };

  int root(int node) noexcept;
  void solve_group(std::span<const Pair> pairs, double unpaired);
  void augment(int row);

  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::vector<Pair> pairs_;
  std::vector<int> parents_;  // of rows, then of columns
  std::vector<int> column_of_;
  // Of one group:
  std::vector<int> group_rows_, group_columns_, index_;
  std::vector<double> costs_;  // rows x (columns + rows), the latter for rows without a column
  std::size_t width_ = 0;
  std::vector<double> row_price_, column_price_, reach_;
  std::vector<int> row_of_, came_from_;
  std::vector<std::size_t> held_;  // the column of each row
  std::vector<char> done_;
};

}  // namespace slamicp
