// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include <slamicp/error.hpp>
#include <slamicp/search/kd_tree.hpp>

#include "search/visitors.hpp"

namespace slamicp {
namespace {

constexpr std::uint32_t bucket_size = 8;
constexpr std::size_t max_depth = 64;  // 2^32 points halve 32 times

template <int D>
int widest_axis(PointView<D> points, std::span<const std::uint32_t> order) {
  Bounds<D> bounds;
  for (const std::uint32_t k : order) bounds.include(points[k]);
  int axis = 0;
  (bounds.upper - bounds.lower).maxCoeff(&axis);
  return axis;
}

}  // namespace

template <int D>
KdTree<D>::KdTree(PointView<D> points, int first_id) {
  if (points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max() - first_id))
    throw Error("a kd-tree of " + std::to_string(points.size()) + " points", "KdTree",
                "thin the cloud: at most 2^31 - 1 points can be numbered");
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    if (is_finite<D>(points[k])) order.push_back(static_cast<std::uint32_t>(k));
  if (order.empty()) return;

  nodes_.reserve(2 * order.size() / (bucket_size / 2) + 1);
  build(order, 0, static_cast<std::uint32_t>(order.size()), points);
  points_.reserve(order.size());
  ids_.reserve(order.size());
  for (const std::uint32_t k : order) {
    points_.push_back(points[k]);
    ids_.push_back(first_id + static_cast<int>(k));
  }
}

template <int D>
void KdTree<D>::build(std::vector<std::uint32_t>& order, std::uint32_t begin, std::uint32_t end, PointView<D> points) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  const std::uint32_t count = end - begin;
  if (count <= bucket_size) {
    nodes_[self].first = begin;
    nodes_[self].count = static_cast<std::uint16_t>(count);
    return;
  }
  const int axis = widest_axis<D>(points, std::span(order).subspan(begin, count));
  const std::uint32_t middle = begin + count / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return points[a][axis] < points[b][axis]; });
  nodes_[self].axis = static_cast<std::uint16_t>(axis);
  nodes_[self].split = points[order[middle]][axis];
  build(order, begin, middle, points);
  nodes_[self].first = static_cast<std::uint32_t>(nodes_.size());
  build(order, middle, end, points);
}

template <int D>
template <typename Visitor>
void KdTree<D>::visit(const Point<D>& query, Visitor& visitor) const noexcept(noexcept(visitor.see(0, 0.0))) {
  if (nodes_.empty() || !is_finite<D>(query)) return;

  // What is left to look at: a subtree, and the offset from the query to its box (0 where the query is inside).
  struct Pending {
    std::uint32_t node;
    double squared_distance;
    Point<D> offset;
  };
  std::array<Pending, max_depth> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, 0.0, Point<D>::Zero()};

  while (waiting > 0) {
    Pending here = stack[--waiting];
    if (here.squared_distance > visitor.bound()) continue;
    while (nodes_[here.node].count == 0) {
      const Node& node = nodes_[here.node];
      const double beyond = query[node.axis] - node.split;
      const bool is_right = beyond >= 0.0;
      Pending far{is_right ? here.node + 1 : node.first, 0.0, here.offset};
      far.offset[node.axis] = beyond;
      // Summed anew, as see()'s distances are: no coordinate is smaller than a point's there, so rounding cannot make
      // the box seem farther than a point in it.
      far.squared_distance = far.offset.squaredNorm();
      if (far.squared_distance <= visitor.bound()) stack[waiting++] = far;
      here.node = is_right ? node.first : here.node + 1;
    }
    const Node& leaf = nodes_[here.node];
    for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
      visitor.see(ids_[k], (points_[k] - query).squaredNorm());
  }
}

template <int D>
Neighbour KdTree<D>::nearest(const Point<D>& query, double reach) const noexcept {
  NearestVisitor visitor{reach * reach};
  visit(query, visitor);
  return visitor.best;
}

template <int D>
NearestTwo KdTree<D>::nearest_two(const Point<D>& query, double reach) const noexcept {
  NearestTwoVisitor visitor{reach * reach};
  visit(query, visitor);
  return {visitor.best, visitor.bound()};
}

template <int D>
std::size_t KdTree<D>::nearest_k(const Point<D>& query, double reach, std::span<Neighbour> found,
                                 std::size_t count) const noexcept {
  if (found.empty()) return 0;
  NearestKVisitor visitor{reach * reach, found, count};
  visit(query, visitor);
  return visitor.count;
}

template <int D>
void KdTree<D>::within(const Point<D>& query, double radius, std::vector<int>& indices) const {
  WithinVisitor visitor{radius * radius, indices};
  visit(query, visitor);
}

template class KdTree<2>;
template class KdTree<3>;

}  // namespace slamicp
