// SPDX-License-Identifier: Apache-2.0
#include "geometry/symmetric_eigen.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "support/random.hpp"

namespace slamicp::symmetric_eigen_test {
namespace {

template <int N>
void expect_parts_of_random_matrices() {
  using Square = Eigen::Matrix<double, N, N>;
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    Square any;
    for (double& each : any.reshaped()) each = random.normal(1.0);
    // Of rank N, N - 1, ..., 1: what is not held has the value 0.
    any.rightCols(trial % N).setZero();
    const Square matrix = any * any.transpose() * std::pow(10.0, random.uniform(-6.0, 6.0));
    const SymmetricEigen<N> eigen(matrix);
    const double size = matrix.norm();
    EXPECT_LT((eigen.vectors.transpose() * eigen.vectors - Square::Identity()).norm(), 1e-13);
    EXPECT_LT((matrix * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm(), 1e-13 * size);
    EXPECT_NEAR(eigen.values.sum(), matrix.trace(), 1e-13 * size);
    EXPECT_GT(eigen.values.minCoeff(), -1e-14 * size);
  }
}

TEST(SymmetricEigenTest, TakesMatricesApart) {
  expect_parts_of_random_matrices<2>();
  expect_parts_of_random_matrices<3>();
  expect_parts_of_random_matrices<4>();
  expect_parts_of_random_matrices<6>();
}

TEST(SymmetricEigenTest, ADiagonalMatrixIsItsOwnAnswer) {
  const Eigen::Vector4d values(3.0, -1.0, 0.0, 3.0);
  const SymmetricEigen<4> eigen(values.asDiagonal());
  EXPECT_EQ(eigen.values, values);
  EXPECT_EQ(eigen.vectors, Eigen::Matrix4d::Identity());
}

TEST(SymmetricEigenTest, ValuesThatAreFarApartAreAllRight) {
  Eigen::Matrix3d turn;
  turn << 2.0, -2.0, 1.0, 1.0, 2.0, 2.0, 2.0, 1.0, -2.0;
  turn /= 3.0;
  // 1e-9 beside 1e6: less than a double's last bit of the largest, but the rows are scaled alike.
  const Eigen::Vector3d root(1e3, 1.0, 1e-3);
  const Eigen::Matrix3d scaled =
      root.asDiagonal() * (turn * Eigen::Vector3d(1.0, 2.0, 3.0).asDiagonal() * turn.transpose()) * root.asDiagonal();
  const SymmetricEigen<3> eigen(scaled);
  EXPECT_NEAR(eigen.values.prod(), scaled.determinant(), 1e-9 * scaled.determinant());
}

TEST(SymmetricEigenTest, WhatIsNoNumberGivesNone) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(1, 2) = matrix(2, 1) = std::numeric_limits<double>::quiet_NaN();
  matrix(0, 0) = std::numeric_limits<double>::quiet_NaN();
  const SymmetricEigen<3> eigen(matrix);
  EXPECT_FALSE(eigen.values.allFinite());
}

}  // namespace
}  // namespace slamicp::symmetric_eigen_test
