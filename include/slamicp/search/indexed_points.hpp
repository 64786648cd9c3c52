// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <slamicp/search/cell_index.hpp>
#include <slamicp/search/kd_tree.hpp>
#include <slamicp/search/neighbour.hpp>
#include <slamicp/search/surface.hpp>

namespace slamicp {

/// Points, the surface around each, and an index to find the nearest. Immutable: it grows by making another one.
///
/// In the plane the index is a CellIndex, in space a row of kd-trees.
template <int D>
class IndexedPoints;

/// Points of the plane, their lines and cells: see CellIndex.
template <>
class IndexedPoints<2> {
 public:
  IndexedPoints() = default;

  /// Points that are not finite keep their number and are never found. Throws Error where an option is absurd.
  explicit IndexedPoints(PointCloud2 points, const SurfaceOptions& surfaces = {}, const CellOptions& cells = {})
      : cells_(std::move(points), surfaces, cells) {}

  /// These points and `added` behind them, numbers unchanged. Lines near the new points are estimated anew.
  IndexedPoints with_added(PointView<2> added) const { return IndexedPoints(cells_.with_added(added)); }
  /// These points without some, which keep their numbers but are no longer finite.
  IndexedPoints with_removed(std::span<const int> which) const { return IndexedPoints(cells_.with_removed(which)); }

  std::size_t size() const noexcept { return cells_.size(); }
  PointView<2> points() const noexcept { return cells_.points(); }
  bool has_surfaces() const noexcept { return cells_.has_surfaces(); }
  /// Not valid() where there is no line to speak of, or no lines were asked for.
  Surface2 surface(std::size_t number) const noexcept { return cells_.surface(number); }
  /// Median distance from a point to its nearest neighbour [m], over a sample; 0 with fewer than two points.
  double spacing() const noexcept { return cells_.spacing(); }
  /// How well the map knows its lines; all zero without lines.
  const LineNoise& line_noise() const noexcept { return cells_.line_noise(); }

  Neighbour nearest(const Point2& query, double reach) const noexcept { return cells_.nearest(query, reach); }
  NearestTwo nearest_two(const Point2& query, double reach) const noexcept { return cells_.nearest_two(query, reach); }
  /// Up to `found.size()` nearest points closer than `reach`, nearest first. Returns how many.
  std::size_t nearest_k(const Point2& query, double reach, std::span<Neighbour> found) const noexcept {
    return cells_.nearest_k(query, reach, found);
  }
  /// Appends the index of every point closer than `radius` to `indices`, in no particular order.
  void within(const Point2& query, double radius, std::vector<int>& indices) const {
    cells_.within(query, radius, indices);
  }

  const CellIndex& cells() const noexcept { return cells_; }

 private:
  explicit IndexedPoints(CellIndex cells) noexcept : cells_(std::move(cells)) {}

  CellIndex cells_;
};

/// Points of space and their planes. The index is a row of kd-trees, each at least twice the size of the next (Bentley
/// and Saxe 1980), which successive versions share; so adding m points to n costs O(n) to copy plus about O(m log n) to
/// index.
template <>
class IndexedPoints<3> {
 public:
  IndexedPoints() = default;

  /// Points that are not finite keep their number and are never found. Throws Error where an option is absurd.
  explicit IndexedPoints(PointCloud3 points, const SurfaceOptions& surfaces = {});

  /// These points and `added` behind them, numbers unchanged. Planes near the new points are estimated anew.
  IndexedPoints with_added(PointView<3> added) const;

  std::size_t size() const noexcept { return points_.size(); }
  PointView<3> points() const noexcept { return points_; }
  bool has_surfaces() const noexcept { return !surfaces_.empty(); }
  /// Not valid() where there is no plane to speak of, or no planes were asked for.
  Surface3 surface(std::size_t number) const noexcept { return has_surfaces() ? surfaces_[number] : Surface3{}; }
  /// Median distance from a point to its nearest neighbour [m], over a sample; 0 with fewer than two points.
  double spacing() const noexcept { return spacing_; }

  Neighbour nearest(const Point3& query, double reach) const noexcept;
  NearestTwo nearest_two(const Point3& query, double reach) const noexcept;
  /// Up to `found.size()` nearest points closer than `reach`, nearest first. Returns how many.
  std::size_t nearest_k(const Point3& query, double reach, std::span<Neighbour> found) const noexcept;
  /// Appends the index of every point closer than `radius` to `indices`, in no particular order.
  void within(const Point3& query, double radius, std::vector<int>& indices) const;

 private:
  void index_from(std::size_t first);
  void estimate_surface(std::size_t k) noexcept;
  void estimate_surfaces(std::span<const int> which);
  std::vector<int> touched_by(std::size_t first_new) const;

  struct Tree {
    std::shared_ptr<const KdTree<3>> tree;
    std::size_t first;  // the number of its first point
  };

  PointCloud3 points_;
  std::vector<Surface3> surfaces_;
  std::vector<float> window_;  // how far the neighbours of each surface reach; infinite where it could take more
  std::vector<Tree> trees_;
  SurfaceOptions options_;
  double spacing_ = 0.0;
};

static_assert(NearestNeighbourIndex<IndexedPoints<2>, 2> && NearestNeighbourIndex<IndexedPoints<3>, 3>);

}  // namespace slamicp
