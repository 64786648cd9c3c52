// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/search/neighbour.hpp>

namespace slamicp {

/// A kd-tree over a fixed set of points (Bentley 1975; Friedman, Bentley, Finkel 1977): split at the median of the
/// widest axis, buckets of a few points, search in order of distance with the best found as bound.
///
/// Build O(n log n), query O(log n) on average; 24 to 40 bytes a point. Queries allocate nothing and may run on any
/// number of threads at once. Points that are not finite are left out.
template <int D>
class KdTree {
 public:
  KdTree() = default;

  /// @param points    the points; the tree keeps its own copy
  /// @param first_id  the index that queries return for points[0]
  explicit KdTree(PointView<D> points, int first_id = 0);

  std::size_t size() const noexcept { return ids_.size(); }

  /// The nearest point closer than `reach` [m].
  Neighbour nearest(const Point<D>& query, double reach) const noexcept;

  /// The nearest point closer than `reach`, and a bound on all others.
  NearestTwo nearest_two(const Point<D>& query, double reach) const noexcept;

  /// Up to `found.size()` nearest points closer than `reach`, nearest first. Returns how many. Where `found` holds
  /// answers already (`count` of them, nearest first, from another tree) they take part.
  std::size_t nearest_k(const Point<D>& query, double reach, std::span<Neighbour> found,
                        std::size_t count = 0) const noexcept;

  /// Appends the index of every point closer than `radius` to `indices`, in no particular order.
  void within(const Point<D>& query, double radius, std::vector<int>& indices) const;

 private:
  struct Node {
    double split = 0.0;       // coordinate of the cut
    std::uint32_t first = 0;  // leaf: its first point; inner node: its right child (the left one follows the node)
    std::uint16_t count = 0;  // points of a leaf; 0 in an inner node
    std::uint16_t axis = 0;
  };

  void build(std::vector<std::uint32_t>& order, std::uint32_t begin, std::uint32_t end, PointView<D> points);
  template <typename Visitor>
  void visit(const Point<D>& query, Visitor& visitor) const noexcept(noexcept(visitor.see(0, 0.0)));

  std::vector<Node> nodes_;
  PointCloud<D> points_;  // in the order of the leaves
  std::vector<int> ids_;
};

extern template class KdTree<2>;
extern template class KdTree<3>;

static_assert(NearestNeighbourIndex<KdTree<2>, 2> && NearestNeighbourIndex<KdTree<3>, 3>);

}  // namespace slamicp
