// SPDX-License-Identifier: Apache-2.0
#include "obstacles/assignment.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace slamicp {
namespace {

constexpr double out_of_reach = std::numeric_limits<double>::infinity();

}  // namespace

void Assignment::reserve(std::size_t rows, std::size_t columns) {
  pairs_.reserve(rows * columns);
  parents_.reserve(rows + columns);
  column_of_.reserve(rows);
  group_rows_.reserve(rows);
  group_columns_.reserve(columns);
  index_.reserve(rows + columns);
  costs_.reserve(rows * (rows + columns));
  row_price_.reserve(rows);
  column_price_.reserve(rows + columns);
  reach_.reserve(rows + columns);
  row_of_.reserve(rows + columns);
  held_.reserve(rows);
  came_from_.reserve(rows + columns);
  done_.reserve(rows + columns);
}

void Assignment::start(std::size_t rows, std::size_t columns) {
  rows_ = rows;
  columns_ = columns;
  pairs_.clear();
  parents_.resize(rows + columns);
  for (std::size_t k = 0; k < parents_.size(); ++k) parents_[k] = static_cast<int>(k);
  column_of_.assign(rows, -1);
}

/// Of the group that a row or column belongs to.
int Assignment::root(int node) noexcept {
  while (parents_[static_cast<std::size_t>(node)] != node) {
    int& parent = parents_[static_cast<std::size_t>(node)];
    parent = parents_[static_cast<std::size_t>(parent)];
    node = parent;
  }
  return node;
}

void Assignment::allow(std::size_t row, std::size_t column, double cost) {
  pairs_.push_back({static_cast<int>(row), static_cast<int>(column), cost});
  const int a = root(static_cast<int>(row));
  const int b = root(static_cast<int>(rows_ + column));
  parents_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

std::span<const int> Assignment::solve(double unpaired) {
  for (Pair& pair : pairs_) pair.row = root(pair.row) * static_cast<int>(rows_) + pair.row;  // by groups, then rows
  std::sort(pairs_.begin(), pairs_.end(),
            [](const Pair& a, const Pair& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
  const int rows = static_cast<int>(rows_);
  for (std::size_t first = 0; first < pairs_.size();) {
    std::size_t last = first;
    while (last < pairs_.size() && pairs_[last].row / rows == pairs_[first].row / rows) ++last;
    const auto group = std::span(pairs_).subspan(first, last - first);
    for (Pair& pair : group) pair.row %= rows;
    if (group.size() == 1)
      column_of_[static_cast<std::size_t>(group[0].row)] = group[0].column;
    else
      solve_group(group, unpaired);
    first = last;
  }
  return column_of_;
}

void Assignment::solve_group(std::span<const Pair> pairs, double unpaired) {
  group_rows_.clear();
  group_columns_.clear();
  for (const Pair& pair : pairs) {
    if (group_rows_.empty() || group_rows_.back() != pair.row) group_rows_.push_back(pair.row);
    group_columns_.push_back(pair.column);
  }
  std::sort(group_columns_.begin(), group_columns_.end());
  group_columns_.erase(std::unique(group_columns_.begin(), group_columns_.end()), group_columns_.end());
  index_.resize(columns_);
  for (std::size_t k = 0; k < group_columns_.size(); ++k)
    index_[static_cast<std::size_t>(group_columns_[k])] = static_cast<int>(k);

  const std::size_t rows = group_rows_.size();
  const std::size_t columns = group_columns_.size();
  width_ = rows + columns;
  costs_.assign(rows * width_, out_of_reach);
  std::size_t row = 0;
  for (const Pair& pair : pairs) {
    while (group_rows_[row] != pair.row) ++row;
    costs_[row * width_ + static_cast<std::size_t>(index_[static_cast<std::size_t>(pair.column)])] = pair.cost;
  }
  for (std::size_t k = 0; k < rows; ++k) costs_[k * width_ + columns + k] = unpaired;

  row_price_.assign(rows, 0.0);
  column_price_.assign(width_, 0.0);
  row_of_.assign(width_, -1);
  held_.assign(rows, width_);
  for (std::size_t k = 0; k < rows; ++k) augment(static_cast<int>(k));
  for (std::size_t k = 0; k < columns; ++k)
    if (row_of_[k] >= 0)
      column_of_[static_cast<std::size_t>(group_rows_[static_cast<std::size_t>(row_of_[k])])] = group_columns_[k];
}

/// Finds the cheapest way to give one more row a column, others making room, and goes it (Dijkstra on reduced costs).
void Assignment::augment(int row) {
  reach_.assign(width_, out_of_reach);
  came_from_.assign(width_, -1);
  done_.assign(width_, 0);
  int from = row;
  std::size_t column = width_;
  double length = 0.0;
  while (true) {
    const double* costs = &costs_[static_cast<std::size_t>(from) * width_];
    std::size_t nearest = width_;
    for (std::size_t k = 0; k < width_; ++k) {
      if (done_[k] != 0) continue;
      const double here = length + costs[k] - row_price_[static_cast<std::size_t>(from)] - column_price_[k];
      if (here < reach_[k]) {
        reach_[k] = here;
        came_from_[k] = from;
      }
      if (reach_[k] < out_of_reach && (nearest == width_ || reach_[k] < reach_[nearest])) nearest = k;
    }
    column = nearest;  // there always is one: each row may stay without
    length = reach_[column];
    done_[column] = 1;
    if (row_of_[column] < 0) break;
    from = row_of_[column];
  }
  row_price_[static_cast<std::size_t>(row)] += length;
  for (std::size_t k = 0; k < width_; ++k)
    if (done_[k] != 0 && k != column) {
      row_price_[static_cast<std::size_t>(row_of_[k])] += length - reach_[k];
      column_price_[k] -= length - reach_[k];
    }
  for (int taker = -1; taker != row;) {
    taker = came_from_[column];
    row_of_[column] = taker;
    std::swap(column, held_[static_cast<std::size_t>(taker)]);  // on with the one that it leaves
  }
}

}  // namespace slamicp
