// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <slamicp.h>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/registration/icp_options.hpp>
#include <slamicp/registration/icp_result.hpp>

namespace slamicp::c {

/// Points that the caller owns, as they lie there. Throws Refusal where there are too many, or one is too far out for
/// the map's index, which counts in whole 1/65536 m.
template <int D>
PointView<D> view_of(const double* points, std::size_t count, const char* name);

/// The same, where at least one must be finite.
template <int D>
PointView<D> view_of_some(const double* points, std::size_t count, const char* name);

/// x, y, heading; or x, y, z, roll, pitch, yaw. Throws Refusal where a number is not finite, or too far out.
template <int D>
Pose<D> pose_from(const double* numbers, const char* name);

void write_pose(const Pose2& pose, double* numbers) noexcept;
void write_pose(const Pose3& pose, double* numbers) noexcept;

/// As a homogeneous matrix, row by row.
template <int D>
void write_transform(const Pose<D>& pose, double* numbers) noexcept;

void write_covariance(const Matrix<3, 3>& covariance, double* numbers) noexcept;

IcpOptions icp_options_from(const slamicp_icp_options& options);
Method method_from(int32_t method);
RobustKernel kernel_from(int32_t kernel);
std::optional<double> distance_or_default(double distance) noexcept;
Outputs outputs_from(uint32_t outputs);
uint32_t bits_of(const Outputs& outputs) noexcept;

void copy_matches(const std::vector<Match>& from, std::vector<slamicp_match>& to);

template <class T>
auto pointer_or_null(const std::vector<T>& values) noexcept {
  return values.empty() ? nullptr : values.data();
}
template <int D>
const double* numbers_or_null(const PointCloud<D>& points) noexcept {
  return points.empty() ? nullptr : points.front().data();
}

}  // namespace slamicp::c
