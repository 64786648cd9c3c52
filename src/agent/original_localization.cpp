// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include <slamicp/search/kd_tree.hpp>

#include "agent/self_localization.hpp"

namespace slamicp {
namespace {

constexpr std::size_t fewest_pairs = 5;
constexpr double tolerance = 1e-4;  // [m], [rad]

/// Figure 9a: the match of the paper's section 2.4, point to line with a constant gate, which asks the tree twice for
/// each point in every iteration, once to tell the inliers, once for the pairs. Then every scan point is compared with
/// every map point.
class OriginalLocalization : public SelfLocalization {
 public:
  OriginalLocalization(PointMap2::Pointer map, const AgentOptions& options)
      : options_(options.localization), rebuild_(options.rebuild_index), points_(to_cloud<2>(map->points())) {
    fix_.map = std::move(map);
    build();
  }

  void set_pose(const Pose2& pose) override {
    fix_.pose = pose;
    last_odometry_.reset();
  }

  void localize(const LaserScan& scan) override {
    if (rebuild_) build();
    fix_.stamp = scan.stamp;
    to_points(scan, options_.ranges, fix_.scan);
    const bool has_odometry = options_.use_odometry && scan.T_odom_robot && scan.T_odom_robot->is_finite();
    fix_.predicted = fix_.pose;
    if (last_odometry_ && has_odometry) fix_.predicted = fix_.pose * (last_odometry_->inverse() * *scan.T_odom_robot);
    last_odometry_ = has_odometry ? scan.T_odom_robot : std::nullopt;
    align();
    fix_.pose = fix_.match.usable() ? fix_.match.pose : fix_.predicted;
  }

  void find_discrepancies() override {
    IcpResult2& match = fix_.match;
    match.outlier_indices.clear();
    match.outliers_in_map.clear();
    match.mean_inlier_distance = 0.0;
    match.inliers = 0;
    const double outlier = options_.icp().outlier_threshold();
    for (std::size_t i = 0; i < fix_.scan.in_robot.size(); ++i) {
      const Point2 in_map = fix_.pose * fix_.scan.in_robot[i];
      const double distance = std::sqrt(nearest_by_brute_force(in_map));
      if (distance < options_.max_correspondence_distance) {
        ++match.inliers;
        match.mean_inlier_distance += distance;
      }
      if (distance < outlier) continue;
      match.outlier_indices.push_back(static_cast<int>(i));
      match.outliers_in_map.push_back(in_map);
    }
    if (match.inliers > 0) match.mean_inlier_distance /= static_cast<double>(match.inliers);
  }

  const Fix& fix() const noexcept override { return fix_; }

 private:
  void build() {
    tree_ = KdTree<2>(points_);
    normals_.resize(points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) normals_[k] = normal_around(points_[k]);
  }

  /// Of the line through the ten nearest neighbours.
  Vector<2> normal_around(const Point2& point) const {
    Neighbour found[10];
    const std::size_t count = tree_.nearest_k(point, std::numeric_limits<double>::infinity(), found);
    Point2 centre = Point2::Zero();
    for (std::size_t k = 0; k < count; ++k) centre += points_[static_cast<std::size_t>(found[k].index)];
    centre /= static_cast<double>(std::max<std::size_t>(count, 1));
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const Point2 off = points_[static_cast<std::size_t>(found[k].index)] - centre;
      xx += off.x() * off.x();
      xy += off.x() * off.y();
      yy += off.y() * off.y();
    }
    const double along = 0.5 * std::atan2(2.0 * xy, xx - yy);
    return {-std::sin(along), std::cos(along)};
  }

  void select_inliers(const Pose2& pose) {
    inliers_.clear();
    for (std::size_t i = 0; i < fix_.scan.in_robot.size(); ++i)
      if (tree_.nearest(pose * fix_.scan.in_robot[i], options_.max_correspondence_distance).index >= 0)
        inliers_.push_back(i);
  }

  /// One Gauss-Newton step on the sum of (n . (R p + t - q))^2: shift [m, m] and turn about the robot [rad].
  Vector<3> step(const Pose2& pose) const {
    Matrix<3, 3> information = Matrix<3, 3>::Zero();
    Vector<3> gradient = Vector<3>::Zero();
    for (const std::size_t i : inliers_) {
      const Point2 in_map = pose * fix_.scan.in_robot[i];
      const Point2 lever = in_map - pose.translation();
      const auto nearest = static_cast<std::size_t>(tree_.nearest(in_map, options_.max_correspondence_distance).index);
      const Vector<2>& normal = normals_[nearest];
      const Vector<3> jacobian(normal.x(), normal.y(), normal.y() * lever.x() - normal.x() * lever.y());
      information += jacobian * jacobian.transpose();
      gradient += normal.dot(in_map - points_[nearest]) * jacobian;
    }
    return -information.ldlt().solve(gradient);
  }

  void align() {
    IcpResult2& match = fix_.match;
    match.pose = fix_.predicted;
    match.stop = Stop::max_iterations;
    for (match.iterations = 0; match.iterations < options_.max_iterations;) {
      select_inliers(match.pose);
      if (inliers_.size() < fewest_pairs) {
        match.stop = Stop::no_overlap;
        return;
      }
      const Vector<3> moved = step(match.pose);
      if (!moved.allFinite()) {
        match.stop = Stop::degenerate;
        return;
      }
      match.pose = {match.pose.x + moved[0], match.pose.y + moved[1], wrap_angle(match.pose.theta + moved[2])};
      ++match.iterations;
      if (moved.head<2>().norm() < tolerance && std::abs(moved[2]) < tolerance) {
        match.stop = Stop::converged;
        return;
      }
    }
  }

  double nearest_by_brute_force(const Point2& point) const noexcept {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point2& in_map : points_) nearest = std::min(nearest, (in_map - point).squaredNorm());
    return nearest;
  }

  LocalizerOptions options_;
  bool rebuild_;
  PointCloud2 points_;
  KdTree<2> tree_;
  std::vector<Vector<2>> normals_;
  std::vector<std::size_t> inliers_;
  std::optional<Pose2> last_odometry_;
  Fix fix_;
};

}  // namespace

std::unique_ptr<SelfLocalization> original_localization(PointMap2::Pointer map, const AgentOptions& options) {
  return std::make_unique<OriginalLocalization>(std::move(map), options);
}

}  // namespace slamicp
