// SPDX-License-Identifier: Apache-2.0
#include "conversion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "refusal.hpp"

namespace slamicp::c {
namespace {

constexpr std::size_t most_points = 100'000'000;
constexpr double farthest = 1e6;  // [m]

template <int D>
bool is_too_far(const Point<D>& point) noexcept {
  return is_finite<D>(point) && point.cwiseAbs().maxCoeff() > farthest;
}

}  // namespace

template <int D>
PointView<D> view_of(const double* points, std::size_t count, const char* name) {
  if (count > most_points)
    throw Refusal(SLAMICP_BAD_POINTS, std::string(name) + " has more than 10^8 points; thin it out");
  if (count == 0) return {};
  need(points, name);
  // Point<D> is D doubles side by side, nothing else.
  const PointView<D> view(reinterpret_cast<const Point<D>*>(points), count);
  if (std::any_of(view.begin(), view.end(), is_too_far<D>))
    throw Refusal(SLAMICP_BAD_POINTS,
                  std::string(name) + " has a point more than 10^6 m from the origin; are these metres?");
  return view;
}

template <int D>
PointView<D> view_of_some(const double* points, std::size_t count, const char* name) {
  const PointView<D> view = view_of<D>(points, count, name);
  if (std::none_of(view.begin(), view.end(), is_finite<D>))
    throw Refusal(SLAMICP_BAD_POINTS, std::string(name) + " has no point with finite coordinates");
  return view;
}

template <>
Pose2 pose_from<2>(const double* numbers, const char* name) {
  need(numbers, name);
  const Pose2 pose{numbers[0], numbers[1], numbers[2]};
  if (!pose.is_finite()) throw Refusal(SLAMICP_BAD_POSE, std::string(name) + " is not finite; give x, y, heading");
  if (std::max({std::abs(pose.x), std::abs(pose.y), std::abs(pose.theta)}) > farthest)
    throw Refusal(SLAMICP_BAD_POSE, std::string(name) + " is more than 10^6 m (or rad) from the origin");
  return pose;
}

template <>
Pose3 pose_from<3>(const double* numbers, const char* name) {
  need(numbers, name);
  for (int k = 0; k < 6; ++k)
    if (!(std::abs(numbers[k]) <= farthest))
      throw Refusal(SLAMICP_BAD_POSE, std::string(name) +
                                          " is not finite, or more than 10^6 m (or rad) from the origin; give x, y, z, "
                                          "roll, pitch, yaw");
  Pose3 pose;
  pose.position = {numbers[0], numbers[1], numbers[2]};
  pose.orientation = Eigen::AngleAxisd(numbers[5], Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(numbers[4], Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(numbers[3], Eigen::Vector3d::UnitX());
  return pose;
}

void write_pose(const Pose2& pose, double* numbers) noexcept {
  numbers[0] = pose.x;
  numbers[1] = pose.y;
  numbers[2] = pose.theta;
}

void write_pose(const Pose3& pose, double* numbers) noexcept {
  const Matrix<3, 3> r = pose.rotation();
  for (int k = 0; k < 3; ++k) numbers[k] = pose.position[k];
  const double level = std::hypot(r(2, 1), r(2, 2));
  const bool upright = level < 1e-9;  // looking straight up or down: roll and yaw are the same turn
  numbers[3] = upright ? 0.0 : std::atan2(r(2, 1), r(2, 2));
  numbers[4] = std::atan2(-r(2, 0), level);
  numbers[5] = upright ? std::atan2(-r(0, 1), r(1, 1)) : std::atan2(r(1, 0), r(0, 0));
}

template <int D>
void write_transform(const Pose<D>& pose, double* numbers) noexcept {
  const Matrix<D, D> rotation = pose.rotation();
  const Point<D> translation = pose.translation();
  for (int row = 0; row < D; ++row) {
    for (int column = 0; column < D; ++column) numbers[row * (D + 1) + column] = rotation(row, column);
    numbers[row * (D + 1) + D] = translation[row];
  }
  for (int column = 0; column <= D; ++column) numbers[D * (D + 1) + column] = column == D ? 1.0 : 0.0;
}

void write_covariance(const Matrix<3, 3>& covariance, double* numbers) noexcept {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) numbers[3 * row + column] = covariance(row, column);
}

Method method_from(int32_t method) {
  if (method == SLAMICP_POINT_TO_POINT) return Method::point_to_point;
  if (method == SLAMICP_POINT_TO_LINE) return Method::point_to_line;
  throw Refusal(SLAMICP_BAD_OPTIONS, "there is no such method; give SLAMICP_POINT_TO_POINT or SLAMICP_POINT_TO_LINE");
}

RobustKernel kernel_from(int32_t kernel) {
  if (kernel < SLAMICP_KERNEL_NONE || kernel > SLAMICP_KERNEL_TUKEY)
    throw Refusal(SLAMICP_BAD_OPTIONS, "there is no such kernel; give SLAMICP_KERNEL_NONE or another of its kind");
  return static_cast<RobustKernel>(kernel);
}

std::optional<double> distance_or_default(double distance) noexcept {
  if (distance == 0.0) return std::nullopt;
  return distance;
}

IcpOptions icp_options_from(const slamicp_icp_options& options) {
  IcpOptions made;
  made.method = method_from(options.method);
  made.max_correspondence_distance = options.max_correspondence_distance;
  made.outlier_distance = distance_or_default(options.outlier_distance);
  made.max_iterations = options.max_iterations;
  made.kernel = kernel_from(options.kernel);
  made.kernel_scale = options.kernel_scale;
  made.final_gate = options.final_gate;
  made.guess_share = options.guess_share;
  made.translation_tolerance = options.translation_tolerance;
  made.rotation_tolerance = options.rotation_tolerance;
  made.coarse_to_fine = options.coarse_to_fine != 0;
  return made;
}

Outputs outputs_from(uint32_t outputs) {
  if ((outputs & ~static_cast<uint32_t>(SLAMICP_ALL_OUTPUTS)) != 0)
    throw Refusal(SLAMICP_BAD_OPTIONS, "outputs has bits that mean nothing; use SLAMICP_OUTLIER_INDICES and its kind");
  const auto has = [outputs](uint32_t bit) { return (outputs & bit) != 0; };
  return {.mean_inlier_distance = has(SLAMICP_MEAN_INLIER_DISTANCE),
          .outlier_indices = has(SLAMICP_OUTLIER_INDICES),
          .outliers_in_map = has(SLAMICP_OUTLIERS_IN_MAP),
          .transformed_scan = has(SLAMICP_TRANSFORMED_SCAN),
          .updated_map = has(SLAMICP_UPDATED_MAP),
          .matches = has(SLAMICP_MATCHES),
          .covariance = has(SLAMICP_COVARIANCE),
          .strays = has(SLAMICP_STRAYS)};
}

uint32_t bits_of(const Outputs& outputs) noexcept {
  uint32_t bits = 0;
  if (outputs.mean_inlier_distance) bits |= SLAMICP_MEAN_INLIER_DISTANCE;
  if (outputs.outlier_indices) bits |= SLAMICP_OUTLIER_INDICES;
  if (outputs.outliers_in_map) bits |= SLAMICP_OUTLIERS_IN_MAP;
  if (outputs.transformed_scan) bits |= SLAMICP_TRANSFORMED_SCAN;
  if (outputs.updated_map) bits |= SLAMICP_UPDATED_MAP;
  if (outputs.matches) bits |= SLAMICP_MATCHES;
  if (outputs.covariance) bits |= SLAMICP_COVARIANCE;
  if (outputs.strays) bits |= SLAMICP_STRAYS;
  return bits;
}

void copy_matches(const std::vector<Match>& from, std::vector<slamicp_match>& to) {
  to.resize(from.size());
  std::transform(from.begin(), from.end(), to.begin(), [](const Match& match) {
    return slamicp_match{match.map_index, static_cast<int32_t>(match.point_class), match.distance};
  });
}

template PointView<2> view_of<2>(const double*, std::size_t, const char*);
template PointView<3> view_of<3>(const double*, std::size_t, const char*);
template PointView<2> view_of_some<2>(const double*, std::size_t, const char*);
template PointView<3> view_of_some<3>(const double*, std::size_t, const char*);
template void write_transform<2>(const Pose2&, double*) noexcept;
template void write_transform<3>(const Pose3&, double*) noexcept;

}  // namespace slamicp::c
