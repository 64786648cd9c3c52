// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp::bench {

/// Which points of a scan have no map point closer than a limit, in double: what brute force says, and the contender
/// `original` checks that it does. All pairs of neighbouring cells are looked at, in cells as wide as the limit.
class OutlierOracle {
 public:
  OutlierOracle(const PointCloud2& map, double limit);

  /// Rising numbers of points.
  std::vector<int> outliers(const PointCloud2& scan, const Pose2& T_map_robot) const;

 private:
  struct Entry {
    std::uint64_t cell;
    Point2 point;
  };

  std::uint64_t cell_of(double x, double y) const;
  bool any_closer(const Point2& point) const;

  double limit_;
  double cell_size_;
  std::vector<Entry> entries_;  // by cell
};

}  // namespace slamicp::bench
