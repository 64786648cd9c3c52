// SPDX-License-Identifier: Apache-2.0
#include "geometry/symmetric_eigen.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace slamicp::symmetric_eigen_test {
namespace {

/// any * any^T, times a scale; its rank is that of `any`.
template <int N>
Eigen::Matrix<double, N, N> square_of(const Eigen::Matrix<double, N, N>& any, double scale) {
  Eigen::Matrix<double, N, N> square;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      square(i, j) = 0.0;
      for (int k = 0; k < N; ++k) square(i, j) += scale * any(i, k) * any(j, k);
    }
  return square;
}

template <int N>
void expect_parts_of(const Eigen::Matrix<double, N, N>& matrix) {
  const SymmetricEigen<N> eigen(matrix);
  const double trace = matrix.trace();
  double sum = 0.0;
  for (int i = 0; i < N; ++i) {
    sum += eigen.values[i];
    EXPECT_GT(eigen.values[i], -1e-14 * trace) << "squares have none below 0";
    for (int k = 0; k < N; ++k) {
      double length = 0.0, turned = 0.0;
      for (int j = 0; j < N; ++j) {
        length += eigen.vectors(j, i) * eigen.vectors(j, k);
        turned += matrix(i, j) * eigen.vectors(j, k);
      }
      EXPECT_NEAR(length, i == k ? 1.0 : 0.0, 1e-14);
      EXPECT_NEAR(turned, eigen.values[k] * eigen.vectors(i, k), 1e-14 * trace);
    }
  }
  EXPECT_NEAR(sum, trace, 1e-14 * trace);
}

template <int N>
void expect_parts_of_random_squares() {
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    Eigen::Matrix<double, N, N> any;
    for (int i = 0; i < N; ++i)
      for (int k = 0; k < N; ++k) any(i, k) = k < trial % N ? 0.0 : random.normal(1.0);
    expect_parts_of(square_of(any, std::pow(10.0, random.uniform(-6.0, 6.0))));
  }
}

TEST(SymmetricEigenTest, TakesSquaresOfAnyRankApart) {
  expect_parts_of_random_squares<3>();
  expect_parts_of_random_squares<6>();
}

TEST(SymmetricEigenTest, ADiagonalMatrixIsItsOwnAnswer) {
  const Eigen::Vector3d values(3.0, -1.0, 3.0);
  const SymmetricEigen<3> eigen(values.asDiagonal());
  EXPECT_EQ(eigen.values, values);
  EXPECT_EQ(eigen.vectors, Eigen::Matrix3d::Identity());
}

TEST(SymmetricEigenTest, ValuesThatAreFarApartAreAllRight) {
  // 1e6, 1 and 1e-6, scaled from a matrix of ones and halves: its determinant is 1/2.
  Eigen::Matrix3d matrix;
  matrix << 1e6, 500.0, 5e-1, 500.0, 1.0, 5e-4, 5e-1, 5e-4, 1e-6;
  const SymmetricEigen<3> eigen(matrix);
  EXPECT_NEAR(eigen.values.prod(), 0.5, 1e-9);
}

TEST(SymmetricEigenTest, WhatIsNoNumberGivesNone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(0, 0) = matrix(1, 2) = matrix(2, 1) = nan;
  EXPECT_FALSE(SymmetricEigen<3>(matrix).values.allFinite());
}

}  // namespace
}  // namespace slamicp::symmetric_eigen_test
