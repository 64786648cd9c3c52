// SPDX-License-Identifier: Apache-2.0
// MRPT's CICP, point to point in the plane, with its defaults but for the gate and the steps; outliers by its tree at
// the final pose.
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPosePDF.h>
#include <mrpt/slam/CICP.h>

#include "field.hpp"

namespace slamicp::bench {
namespace {

using MrptMap = mrpt::maps::CSimplePointsMap;

void fill(const PointCloud2& points, MrptMap& map) {
  map.resize(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    map.setPointFast(k, static_cast<float>(points[k].x()), static_cast<float>(points[k].y()), 0.0F);
  map.mark_as_modified();
}

class MrptMatcher : public Matcher {
 public:
  explicit MrptMatcher(std::shared_ptr<const MrptMap> map) : map_(std::move(map)) {
    icp_.options.maxIterations = max_iterations;
    icp_.options.thresholdDist = gate;
    icp_.options.thresholdAng = 0.0;  // or the gate grows with the range
    icp_.options.minAbsStep_trans = icp_.options.minAbsStep_rot = tolerance;
    icp_.options.corresponding_points_decimation = 1;  // all points, as everybody else
    icp_.options.skip_cov_calculation = true;
  }

  void localize(const PointCloud2& scan, const Pose2& guess, Estimate& estimate) override {
    fill(scan, scan_);
    mrpt::slam::CICP::TReturnInfo info;
    const auto found =
        icp_.Align(map_.get(), &scan_, mrpt::poses::CPose2D(guess.x, guess.y, guess.theta), info)->getMeanVal();
    estimate.pose = {found.x(), found.y(), found.phi()};
    estimate.iterations = static_cast<int>(info.nIterations);
    std::vector<int>& outliers = estimate.fresh_outliers();
    const auto limit = static_cast<float>(gate);
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const Point2 in_map = estimate.pose * scan[i];
      if (map_->squareDistanceToClosestCorrespondence(static_cast<float>(in_map.x()), static_cast<float>(in_map.y())) >=
          limit * limit)
        outliers.push_back(static_cast<int>(i));
    }
  }

 private:
  std::shared_ptr<const MrptMap> map_;
  mrpt::slam::CICP icp_;
  MrptMap scan_;
};

}  // namespace

std::vector<Contender> mrpt_contenders() {
  const auto prepare = [](const SharedCloud& cloud) -> MakeMatcher {
    const auto map = std::make_shared<MrptMap>();
    fill(*cloud, *map);
    (void)map->squareDistanceToClosestCorrespondence(0.0F, 0.0F);  // builds its tree
    return [map] { return std::make_unique<MrptMatcher>(map); };
  };
  return {{"mrpt_point", "MRPT CICP, point to point", prepare}};
}

}  // namespace slamicp::bench
