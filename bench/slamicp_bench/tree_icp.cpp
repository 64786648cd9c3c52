// SPDX-License-Identifier: Apache-2.0
#include "tree_icp.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "contender.hpp"

namespace slamicp::bench {
namespace {

constexpr std::size_t fewest_pairs = 5;

/// One Gauss-Newton step on the sum of (n . (R p + t - q))^2: shift [m, m] and turn about the robot [rad].
Vector<3> step(const TreeMap& map, const PointCloud2& scan, const std::vector<std::size_t>& inliers,
               const Pose2& pose) {
  const Matrix<2, 2> rotation = pose.rotation();
  const Point2 translation = pose.translation();
  Matrix<3, 3> information = Matrix<3, 3>::Zero();
  Vector<3> gradient = Vector<3>::Zero();
  for (const std::size_t i : inliers) {
    const Point2 lever = rotation * scan[i];
    const Point2 in_map = lever + translation;
    const auto nearest = static_cast<std::size_t>(map.nearest(in_map).index);
    const Vector<2>& normal = map.normals()[nearest];
    const Vector<3> jacobian(normal.x(), normal.y(), normal.y() * lever.x() - normal.x() * lever.y());
    information += jacobian * jacobian.transpose();
    gradient += normal.dot(in_map - map.points()[nearest]) * jacobian;
  }
  return -information.ldlt().solve(gradient);
}

}  // namespace

void TreeIcp::select_inliers(const TreeMap& map, const PointCloud2& scan, const Pose2& pose) {
  const Matrix<2, 2> rotation = pose.rotation();
  const Point2 translation = pose.translation();
  inliers_.clear();
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (map.nearest(rotation * scan[i] + translation).squared_distance < gate * gate) inliers_.push_back(i);
}

TreeIcp::Result TreeIcp::align(const TreeMap& map, const PointCloud2& scan, const Pose2& guess) {
  Result result{guess, 0};
  while (result.iterations < max_iterations) {
    select_inliers(map, scan, result.pose);
    if (inliers_.size() < fewest_pairs) return {guess, result.iterations};
    const Vector<3> moved = step(map, scan, inliers_, result.pose);
    if (!moved.allFinite()) return {guess, result.iterations};
    result.pose = {result.pose.x + moved[0], result.pose.y + moved[1], wrap_angle(result.pose.theta + moved[2])};
    ++result.iterations;
    if (moved.head<2>().norm() < tolerance && std::abs(moved[2]) < tolerance) break;
  }
  return result;
}

void transform(const PointCloud2& scan, const Pose2& pose, PointCloud2& in_map) {
  const Matrix<2, 2> rotation = pose.rotation();
  const Point2 translation = pose.translation();
  in_map.resize(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) in_map[i] = rotation * scan[i] + translation;
}

}  // namespace slamicp::bench
