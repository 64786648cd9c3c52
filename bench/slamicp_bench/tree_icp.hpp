// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <slamicp/geometry/pose.hpp>

#include "tree_map.hpp"

namespace slamicp::bench {

/// The ICP inside the paper's agents (its section 2.4): point to line with a constant gate. In every iteration each
/// point asks the tree twice, once to tell the inliers, once for the pairs.
class TreeIcp {
 public:
  struct Result {
    Pose2 pose;
    int iterations = 0;
  };

  Result align(const TreeMap& map, const PointCloud2& scan, const Pose2& guess);

 private:
  void select_inliers(const TreeMap& map, const PointCloud2& scan, const Pose2& pose);

  std::vector<std::size_t> inliers_;
};

/// The scan in the map's frame: the paper's tT, eq. (7).
void transform(const PointCloud2& scan, const Pose2& pose, PointCloud2& in_map);

}  // namespace slamicp::bench
