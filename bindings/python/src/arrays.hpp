// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <optional>
#include <string>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/geometry/trajectory.hpp>

#include "conversion.hpp"
#include "refusal.hpp"

namespace slamicp::python {

namespace nb = nanobind;
using c::Refusal;

using Array1 = nb::ndarray<nb::numpy, const double, nb::ndim<1>>;
using Array2 = nb::ndarray<nb::numpy, const double, nb::ndim<2>>;
using Indices = nb::ndarray<nb::numpy, const int, nb::ndim<1>>;
using Floats = nb::ndarray<nb::numpy, const float, nb::ndim<1>>;

/// Numbers for as many as a pose has, from a tuple, a list, an array.
using Pose2Numbers = std::array<double, 3>;
using Pose3Numbers = std::array<double, 6>;

/// Points as NumPy has them: float64, a point a row, C order, at no cost; other floats and orders are copied. What is
/// no such array is refused, integers too, as they are mostly something else (pixels, grid cells).
class PointArray {
 public:
  PointArray(nb::handle given, const char* name);

  int dimension() const noexcept { return dimension_; }
  std::size_t size() const noexcept { return array_.shape(0); }
  const double* data() const noexcept { return array_.data(); }
  const char* name() const noexcept { return name_; }

  template <int D>
  PointView<D> view() const {
    need_dimension(D);
    return c::view_of<D>(data(), size(), name_);
  }
  template <int D>
  PointView<D> view_of_some() const {
    need_dimension(D);
    return c::view_of_some<D>(data(), size(), name_);
  }
  void need_dimension(int dimension) const;

 private:
  nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu> array_;
  const char* name_;
  int dimension_ = 0;
};

/// The same for one dimension, of ranges: float32 at no cost.
nb::ndarray<const float, nb::ndim<1>, nb::c_contig, nb::device::cpu> range_array(nb::handle given, const char* name);

/// Read-only arrays that look into what `owner` holds, and keep it alive.
Array2 view_rows(const double* data, std::size_t rows, std::size_t columns, nb::handle owner);
Indices view_indices(const std::vector<int>& values, nb::handle owner);
template <int D>
Array2 view_points(PointView<D> points, nb::handle owner) {
  return view_rows(points.empty() ? nullptr : points.front().data(), points.size(), D, owner);
}

/// Arrays of their own.
template <class Array, class T>
Array owned(std::unique_ptr<T[]> values, std::initializer_list<std::size_t> shape) {
  T* const data = values.get();
  const nb::capsule owner(data, [](void* memory) noexcept { delete[] static_cast<T*>(memory); });
  values.release();
  return Array(data, shape, owner);
}
Array1 copy_numbers(const double* data, std::size_t count);
Array2 copy_rows(const double* data, std::size_t rows, std::size_t columns);
Array1 copy_pose(const Pose2& pose);
Array1 copy_pose(const Pose3& pose);
Array2 copy_covariance(const Matrix<3, 3>& covariance);
template <int D>
Array2 copy_points(const PointCloud<D>& points) {
  return copy_rows(points.empty() ? nullptr : points.front().data(), points.size(), D);
}
/// Rows of stamp, x, y, heading.
Array2 copy_trajectory(const Trajectory& trajectory);
Trajectory trajectory_from(nb::handle given);

Pose2 pose_from(const Pose2Numbers& numbers, const char* name);
std::optional<Pose2> pose_from(const std::optional<Pose2Numbers>& numbers, const char* name);

/// Throws Refusal with the problem of options, where they have one.
template <class Options>
const Options& checked(const Options& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Refusal(SLAMICP_BAD_OPTIONS, problem);
  return options;
}

}  // namespace slamicp::python
