// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace slamicp {

/// A fixed-size matrix without alignment demands: it lies in a std::vector, crosses a library border and
/// survives a change of compiler flags as a plain array of doubles does.
template <int Rows, int Cols>
using Matrix = Eigen::Matrix<double, Rows, Cols, Eigen::DontAlign>;

template <int Rows>
using Vector = Matrix<Rows, 1>;

/// A point in D dimensions [m]. D doubles side by side, nothing else.
template <int D>
using Point = Vector<D>;

/// A set of points, eq. (1), (2), (4), (5) of the paper: point k is the column (x_k, y_k) of its matrix.
/// In memory the same as the paper's D x K matrix in column-major order.
template <int D>
using PointCloud = std::vector<Point<D>>;

/// A cloud that somebody else owns.
template <int D>
using PointView = std::span<const Point<D>>;

/// A copy of one's own.
template <int D>
PointCloud<D> to_cloud(PointView<D> points) {
  return PointCloud<D>(points.begin(), points.end());
}

using Point2 = Point<2>;
using Point3 = Point<3>;
using PointCloud2 = PointCloud<2>;
using PointCloud3 = PointCloud<3>;

static_assert(sizeof(Point2) == 2 * sizeof(double) && sizeof(Point3) == 3 * sizeof(double));

/// Of two vectors of the plane, the area between them: above 0 where b is to the left of a.
inline double cross(const Vector<2>& a, const Vector<2>& b) noexcept { return a.x() * b.y() - a.y() * b.x(); }

/// Which of `size` points is number k of `count` that are chosen evenly.
inline std::size_t evenly_chosen(std::size_t k, std::size_t count, std::size_t size) noexcept {
  return (2 * k + 1) * size / (2 * count);
}

/// True if every coordinate is a number: neither NaN nor infinite.
template <int D>
bool is_finite(const Point<D>& point) noexcept {
  return point.allFinite();
}

/// An axis-aligned box [m]; `lower > upper` where it holds nothing.
template <int D>
struct Bounds {
  Point<D> lower = Point<D>::Constant(1e300);
  Point<D> upper = Point<D>::Constant(-1e300);

  bool empty() const noexcept { return lower[0] > upper[0]; }
  void include(const Point<D>& point) noexcept {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
};

/// The bounds of the finite points. O(K).
template <int D>
Bounds<D> bounds_of(const PointCloud<D>& cloud) noexcept {
  Bounds<D> bounds;
  for (const Point<D>& point : cloud)
    if (is_finite<D>(point)) bounds.include(point);
  return bounds;
}

}  // namespace slamicp
