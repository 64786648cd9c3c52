// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/search/neighbour.hpp>

namespace slamicp::bench {

/// A map as the paper's agents keep it: a kd-tree (nanoflann's, leaves of 10 points), and for each point the normal of
/// the line through its 10 nearest neighbours. The cloud must outlive it.
class TreeMap {
 public:
  explicit TreeMap(const PointCloud2& cloud);
  ~TreeMap();
  TreeMap(const TreeMap&) = delete;
  TreeMap& operator=(const TreeMap&) = delete;

  const PointCloud2& points() const noexcept { return cloud_; }
  const std::vector<Vector<2>>& normals() const noexcept { return normals_; }

  /// The nearest point, however far.
  Neighbour nearest(const Point2& query) const;

 private:
  struct Tree;

  Vector<2> normal_around(const Point2& point) const;

  const PointCloud2& cloud_;
  std::unique_ptr<Tree> tree_;
  std::vector<Vector<2>> normals_;
};

}  // namespace slamicp::bench
