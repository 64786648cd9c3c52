// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "obstacles/assignment.hpp"
#include "support/random.hpp"

namespace slamicp::assignment_property_test {
namespace {

constexpr double unpaired = 10.0;

struct Problem {
  std::size_t rows, columns;
  std::vector<double> costs;  // negative: not allowed
};

double cost_of(const Problem& problem, std::span<const int> columns) {
  double sum = 0.0;
  for (std::size_t row = 0; row < problem.rows; ++row)
    sum += columns[row] < 0 ? unpaired : problem.costs[row * problem.columns + static_cast<std::size_t>(columns[row])];
  return sum;
}

/// Tries all ways.
double least_cost(const Problem& problem, std::size_t row, std::vector<char>& taken) {
  if (row == problem.rows) return 0.0;
  double least = unpaired + least_cost(problem, row + 1, taken);
  for (std::size_t column = 0; column < problem.columns; ++column) {
    const double cost = problem.costs[row * problem.columns + column];
    if (taken[column] != 0 || cost < 0.0) continue;
    taken[column] = 1;
    least = std::min(least, cost + least_cost(problem, row + 1, taken));
    taken[column] = 0;
  }
  return least;
}

TEST(AssignmentProperty, IsTheCheapestOfAllWays) {
  test::Random random(1);
  Assignment assignment;
  for (int run = 0; run < 2000; ++run) {
    Problem problem{
        static_cast<std::size_t>(random.uniform(0.0, 5.99)), static_cast<std::size_t>(random.uniform(0.0, 5.99)), {}};
    const double allowed = random.uniform(0.1, 1.0);
    for (std::size_t k = 0; k < problem.rows * problem.columns; ++k)
      problem.costs.push_back(random.uniform(0.0, 1.0) < allowed ? random.uniform(0.0, 9.9) : -1.0);
    assignment.start(problem.rows, problem.columns);
    for (std::size_t row = 0; row < problem.rows; ++row)
      for (std::size_t column = 0; column < problem.columns; ++column)
        if (const double cost = problem.costs[row * problem.columns + column]; cost >= 0.0)
          assignment.allow(row, column, cost);
    const std::span<const int> columns = assignment.solve(unpaired);
    ASSERT_EQ(columns.size(), problem.rows);
    std::vector<char> taken(problem.columns, 0);
    for (std::size_t row = 0; row < problem.rows; ++row) {
      if (columns[row] < 0) continue;
      const auto column = static_cast<std::size_t>(columns[row]);
      ASSERT_GE(problem.costs[row * problem.columns + column], 0.0) << "a pair that was not allowed";
      ASSERT_EQ(taken[column], 0) << "a column given twice";
      taken[column] = 1;
    }
    std::fill(taken.begin(), taken.end(), 0);
    ASSERT_NEAR(cost_of(problem, columns), least_cost(problem, 0, taken), 1e-9);
  }
}

}  // namespace
}  // namespace slamicp::assignment_property_test
