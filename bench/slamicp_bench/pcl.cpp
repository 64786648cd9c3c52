// SPDX-License-Identifier: Apache-2.0
// The Point Cloud Library: its ICP, with its own point-to-point step or a point-to-line step in the plane, its tree set
// once; outliers by its tree at the final pose.
#include <Eigen/Cholesky>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/transformation_estimation.h>

#include "field.hpp"
#include "tree_map.hpp"

namespace slamicp::bench {
namespace {

using PclPoint = pcl::PointNormal;
using PclCloud = pcl::PointCloud<PclPoint>;

/// What all matchers of a map share.
struct PclMap {
  explicit PclMap(const PointCloud2& points) : cloud(std::make_shared<PclCloud>()) {
    const TreeMap lines(points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector2f at = points[k].cast<float>(), normal = lines.normals()[k].cast<float>();
      cloud->push_back(PclPoint(at.x(), at.y(), 0.0F, normal.x(), normal.y(), 0.0F));
    }
  }
  PclCloud::Ptr cloud;
};

/// One Gauss-Newton step in the plane on the sum of (n . (R p + t - q))^2.
class PointToLine : public pcl::registration::TransformationEstimation<PclPoint, PclPoint, float> {
 public:
  void estimateRigidTransformation(const PclCloud& source, const PclCloud& target, const pcl::Correspondences& pairs,
                                   Matrix4& step) const override {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (const pcl::Correspondence& pair : pairs) {
      const auto& p = source[static_cast<std::size_t>(pair.index_query)];
      const auto& q = target[static_cast<std::size_t>(pair.index_match)];
      const Eigen::Vector2d at(p.x, p.y), normal(q.normal_x, q.normal_y);
      const Eigen::Vector3d jacobian(normal.x(), normal.y(), normal.y() * at.x() - normal.x() * at.y());
      information += jacobian * jacobian.transpose();
      gradient += normal.dot(at - Eigen::Vector2d(q.x, q.y)) * jacobian;
    }
    const Eigen::Vector3d moved = -information.ldlt().solve(gradient);
    step.setIdentity();
    step.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(moved[2]).toRotationMatrix().cast<float>();
    step.topRightCorner<2, 1>() = moved.head<2>().cast<float>();
  }

  // All pairs are given one by one: PCL's ICP calls nothing else.
  void estimateRigidTransformation(const PclCloud& /*source*/, const PclCloud& /*target*/,
                                   Matrix4& /*step*/) const override {}
  void estimateRigidTransformation(const PclCloud& /*source*/, const pcl::Indices& /*chosen*/,
                                   const PclCloud& /*target*/, Matrix4& /*step*/) const override {}
  void estimateRigidTransformation(const PclCloud& /*source*/, const pcl::Indices& /*chosen*/,
                                   const PclCloud& /*target*/, const pcl::Indices& /*chosen*/,
                                   Matrix4& /*step*/) const override {}
};

class PclMatcher : public Matcher {
 public:
  PclMatcher(std::shared_ptr<const PclMap> map, bool to_lines) : map_(std::move(map)) {
    tree_->setInputCloud(map_->cloud);
    icp_.setSearchMethodTarget(tree_, true);  // or it is built at every align()
    icp_.setInputTarget(map_->cloud);
    icp_.setMaxCorrespondenceDistance(gate);
    icp_.setMaximumIterations(max_iterations);
    icp_.setTransformationEpsilon(tolerance * tolerance);                      // the square of the step [m^2]
    icp_.setTransformationRotationEpsilon(1.0 - 0.5 * tolerance * tolerance);  // its cosine
    if (to_lines) icp_.setTransformationEstimation(std::make_shared<PointToLine>());
  }

  void localize(const PointCloud2& scan, const Pose2& guess, Estimate& estimate) override {
    scan_->clear();
    for (const Point2& point : scan)
      scan_->push_back(PclPoint(static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F));
    icp_.setInputSource(scan_);
    Eigen::Matrix4f start = Eigen::Matrix4f::Identity();
    start.topLeftCorner<2, 2>() = guess.rotation().cast<float>();
    start.topRightCorner<2, 1>() = guess.translation().cast<float>();
    icp_.align(in_map_, start);
    const Eigen::Matrix4f found = icp_.getFinalTransformation();
    estimate.pose =
        Pose2::from(found.topLeftCorner<2, 2>().cast<double>(), found.topRightCorner<2, 1>().cast<double>());
    estimate.iterations = icp_.iterations();
    find_outliers(estimate.fresh_outliers());
  }

 private:
  struct CountingIcp : pcl::IterativeClosestPoint<PclPoint, PclPoint> {
    int iterations() const { return nr_iterations_; }
  };

  void find_outliers(std::vector<int>& outliers) {
    const auto limit = static_cast<float>(gate);
    for (std::size_t i = 0; i < in_map_.size(); ++i)
      if (tree_->nearestKSearch(in_map_[i], 1, nearest_, squared_distance_) == 0 ||
          squared_distance_[0] >= limit * limit)
        outliers.push_back(static_cast<int>(i));
  }

  std::shared_ptr<const PclMap> map_;
  pcl::search::KdTree<PclPoint>::Ptr tree_ = std::make_shared<pcl::search::KdTree<PclPoint>>();
  CountingIcp icp_;
  PclCloud::Ptr scan_ = std::make_shared<PclCloud>();
  PclCloud in_map_;
  pcl::Indices nearest_;
  std::vector<float> squared_distance_;
};

Contender contender(std::string name, std::string what, bool to_lines) {
  const auto prepare = [to_lines](const SharedCloud& cloud) -> MakeMatcher {
    const auto map = std::make_shared<const PclMap>(*cloud);
    return [=] { return std::make_unique<PclMatcher>(map, to_lines); };
  };
  return {std::move(name), std::move(what), prepare};
}

}  // namespace

std::vector<Contender> pcl_contenders() {
  return {contender("pcl_point", "PCL " PCL_VERSION_PRETTY " ICP, point to point", false),
          contender("pcl_line", "PCL " PCL_VERSION_PRETTY " ICP, an own point-to-line step in the plane", true)};
}

}  // namespace slamicp::bench
