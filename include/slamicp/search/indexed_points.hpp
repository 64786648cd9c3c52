// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <slamicp/search/kd_tree.hpp>
#include <slamicp/search/neighbour.hpp>
#include <slamicp/search/surface.hpp>

namespace slamicp {

/// Points, the surface around each, and an index to find the nearest. Immutable: it grows by making another one.
///
/// The index is a row of kd-trees, each at least twice the size of the next (Bentley and Saxe 1980), which
/// successive versions share; so adding m points to n costs O(n) to copy plus about O(m log n) to index.
template <int D>
class IndexedPoints {
 public:
  IndexedPoints() = default;

  /// Points that are not finite keep their number and are never found. Throws Error where an option is absurd.
  explicit IndexedPoints(PointCloud<D> points, const SurfaceOptions& options = {});

  /// These points and `added` behind them, numbers unchanged. Surfaces near the new points are estimated anew.
  IndexedPoints with_added(PointView<D> added) const;

  std::size_t size() const noexcept { return points_.size(); }
  const PointCloud<D>& points() const noexcept { return points_; }
  /// One for each point; empty where SurfaceOptions::neighbours is 0.
  const std::vector<Surface<D>>& surfaces() const noexcept { return surfaces_; }
  bool has_surfaces() const noexcept { return !surfaces_.empty(); }

  /// Median distance from a point to its nearest neighbour [m], over a sample; 0 with fewer than two points.
  double spacing() const noexcept { return spacing_; }

  Neighbour nearest(const Point<D>& query, double reach) const noexcept;
  NearestTwo nearest_two(const Point<D>& query, double reach) const noexcept;
  /// Up to `found.size()` nearest points closer than `reach`, nearest first. Returns how many.
  std::size_t nearest_k(const Point<D>& query, double reach, std::span<Neighbour> found) const noexcept;
  /// Appends the index of every point closer than `radius` to `indices`, in no particular order.
  void within(const Point<D>& query, double radius, std::vector<int>& indices) const;

 private:
  void index_from(std::size_t first);
  void estimate_surface(std::size_t k) noexcept;
  void estimate_surfaces(std::span<const int> which);
  std::vector<int> touched_by(std::size_t first_new) const;
  double sample_spacing() const noexcept;

  struct Tree {
    std::shared_ptr<const KdTree<D>> tree;
    std::size_t first;  // the number of its first point
  };

  PointCloud<D> points_;
  std::vector<Surface<D>> surfaces_;
  std::vector<float> window_;  // how far the neighbours of each surface reach; infinite where it could take more
  std::vector<Tree> trees_;
  SurfaceOptions options_;
  double spacing_ = 0.0;
};

extern template class IndexedPoints<2>;
extern template class IndexedPoints<3>;

static_assert(NearestNeighbourIndex<KdTree<2>, 2> && NearestNeighbourIndex<IndexedPoints<2>, 2>);

}  // namespace slamicp
