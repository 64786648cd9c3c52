// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Jacobi>
#include <cmath>
#include <limits>

namespace slamicp {

/// Eigenvalues and eigenvectors of a small symmetric matrix, by cyclic Jacobi rotations (Golub, Van Loan, "Matrix
/// Computations", 8.5). Beyond three rows Eigen's own solver takes eight seconds to compile for each size.
template <int N>
struct SymmetricEigen {
  using Square = Eigen::Matrix<double, N, N>;
  using Column = Eigen::Matrix<double, N, 1>;

  Column values;   ///< in no order
  Square vectors;  ///< value k belongs to column k

  /// What is no number gives values that are none.
  explicit SymmetricEigen(Square matrix) noexcept : vectors(Square::Identity()) {
    constexpr int most_sweeps = 20;  // five or six do
    for (int sweep = 0; sweep < most_sweeps && !is_diagonal(matrix); ++sweep)
      for (int p = 0; p + 1 < N; ++p)
        for (int q = p + 1; q < N; ++q) {
          Eigen::JacobiRotation<double> turn;
          if (!turn.makeJacobi(matrix, p, q)) continue;
          matrix.applyOnTheLeft(p, q, turn.adjoint());
          matrix.applyOnTheRight(p, q, turn);
          vectors.applyOnTheRight(p, q, turn);
        }
    values = matrix.diagonal();
  }

 private:
  static bool is_diagonal(const Square& matrix) noexcept {
    const double least = 1e-3 * std::numeric_limits<double>::epsilon() * matrix.diagonal().cwiseAbs().maxCoeff();
    for (int p = 0; p + 1 < N; ++p)
      for (int q = p + 1; q < N; ++q)
        if (std::abs(matrix(p, q)) > least) return false;
    return true;
  }
};

}  // namespace slamicp
