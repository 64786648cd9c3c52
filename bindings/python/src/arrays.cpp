// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"

#include <algorithm>
#include <memory>
#include <nanobind/stl/string.h>

namespace slamicp::python {
namespace {

// NumPy takes no null for an array of nothing.
constexpr double nothing[1] = {0.0};
constexpr int no_index[1] = {0};

std::string text_of(nb::handle object) { return nb::str(object).c_str(); }

/// A copy in C order of an array of other floats; anything else is refused.
nb::object as_floats(nb::handle given, const char* name, const char* shape, const char* type) {
  const auto refuse = [&](const std::string& what) {
    throw nb::type_error(
        (std::string(name) + " must be a NumPy array of floats of shape " + shape + ", not " + what).c_str());
  };
  const nb::object numpy = nb::module_::import_("numpy");
  const nb::object array = numpy.attr("ndarray");
  if (!nb::isinstance(given, array)) refuse(text_of(nb::object(given.type().attr("__name__"))));
  const nb::object dtype = given.attr("dtype");
  const nb::object kind = dtype.attr("kind");
  if (text_of(kind) != "f") refuse("of " + text_of(dtype));
  return numpy.attr("ascontiguousarray")(given, nb::arg("dtype") = type);
}

}  // namespace

PointArray::PointArray(nb::handle given, const char* name) : name_(name) {
  if (!nb::try_cast(given, array_, false)) {
    const nb::object converted = as_floats(given, name, "(K, 2) or (K, 3)", "float64");
    if (!nb::try_cast(converted, array_, false))
      throw Refusal(SLAMICP_BAD_POINTS, std::string(name) + " must have the shape (K, 2) or (K, 3), a point a row");
  }
  dimension_ = static_cast<int>(array_.shape(1));
  if (dimension_ != 2 && dimension_ != 3)
    throw Refusal(SLAMICP_BAD_POINTS, std::string(name) + " must have the shape (K, 2) or (K, 3), a point a row");
}

void PointArray::need_dimension(int dimension) const {
  if (dimension_ != dimension)
    throw Refusal(SLAMICP_BAD_POINTS, std::string(name_) + " must have the shape (K, " + std::to_string(dimension) +
                                          "), not (K, " + std::to_string(dimension_) + ")");
}

nb::ndarray<const float, nb::ndim<1>, nb::c_contig, nb::device::cpu> range_array(nb::handle given, const char* name) {
  nb::ndarray<const float, nb::ndim<1>, nb::c_contig, nb::device::cpu> array;
  if (nb::try_cast(given, array, false)) return array;
  const nb::object converted = as_floats(given, name, "(N,)", "float32");
  if (!nb::try_cast(converted, array, false))
    throw Refusal(SLAMICP_BAD_SCAN, std::string(name) + " must have the shape (N,), a range a beam");
  return array;
}

Array2 view_rows(const double* data, std::size_t rows, std::size_t columns, nb::handle owner) {
  return Array2(data == nullptr ? nothing : data, {rows, columns}, owner);
}

Indices view_indices(const std::vector<int>& values, nb::handle owner) {
  return Indices(values.empty() ? no_index : values.data(), {values.size()}, owner);
}

Array1 copy_numbers(const double* data, std::size_t count) {
  auto values = std::make_unique<double[]>(count);
  std::copy(data, data + count, values.get());
  return owned<Array1>(std::move(values), {count});
}

Array2 copy_rows(const double* data, std::size_t rows, std::size_t columns) {
  auto values = std::make_unique<double[]>(rows * columns);
  std::copy(data, data + rows * columns, values.get());
  return owned<Array2>(std::move(values), {rows, columns});
}

Array1 copy_pose(const Pose2& pose) {
  Pose2Numbers numbers;
  c::write_pose(pose, numbers.data());
  return copy_numbers(numbers.data(), numbers.size());
}

Array1 copy_pose(const Pose3& pose) {
  Pose3Numbers numbers;
  c::write_pose(pose, numbers.data());
  return copy_numbers(numbers.data(), numbers.size());
}

Array2 copy_covariance(const Matrix<3, 3>& covariance) {
  double numbers[9];
  c::write_covariance(covariance, numbers);
  return copy_rows(numbers, 3, 3);
}

Array2 copy_trajectory(const Trajectory& trajectory) {
  auto values = std::make_unique<double[]>(4 * trajectory.size());
  double* next = values.get();
  for (const StampedPose& at : trajectory)
    for (const double value : {at.stamp, at.pose.x, at.pose.y, at.pose.theta}) *next++ = value;
  return owned<Array2>(std::move(values), {trajectory.size(), 4});
}

Trajectory trajectory_from(nb::handle given) {
  nb::ndarray<const double, nb::shape<-1, 4>, nb::c_contig, nb::device::cpu> rows;
  if (!nb::try_cast(given, rows, false) &&
      !nb::try_cast(as_floats(given, "trajectory", "(N, 4)", "float64"), rows, false))
    throw Refusal(SLAMICP_BAD_POINTS, "trajectory must have the shape (N, 4): stamp, x, y, heading a row");
  Trajectory trajectory(rows.shape(0));
  for (std::size_t k = 0; k < trajectory.size(); ++k)
    trajectory[k] = {rows(k, 0), {rows(k, 1), rows(k, 2), rows(k, 3)}};
  return trajectory;
}

Pose2 pose_from(const Pose2Numbers& numbers, const char* name) { return c::pose_from<2>(numbers.data(), name); }

std::optional<Pose2> pose_from(const std::optional<Pose2Numbers>& numbers, const char* name) {
  if (!numbers) return std::nullopt;
  return pose_from(*numbers, name);
}

}  // namespace slamicp::python
