// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <slamicp/search/cell_options.hpp>
#include <slamicp/search/cell_table.hpp>
#include <slamicp/search/line_noise.hpp>
#include <slamicp/search/neighbour.hpp>
#include <slamicp/search/surface.hpp>

namespace slamicp {

/// Exact nearest neighbours in the plane at the speed of memory: the plane is cut into cells, and each cell lists every
/// point that is nearest to some place in it (those whose Voronoi cells meet it), so that a query looks at about three.
///
/// Cells lie in tiles of 16 x 16, made only where points are within reach: memory follows the points, not the bounding
/// box. Immutable: adding or removing points makes another index, which shares every tile that did not change; copies
/// are cheap. Queries are safe from any number of threads, also while others call build().
///
/// Points that are not finite, or farther than 10,000 km from the origin, keep their number and are never found.
class CellIndex {
 public:
  /// No points.
  CellIndex();

  /// O(n); about 4 us a point where the cells are built at once. Throws Error where an option is absurd, or where there
  /// are more than 2^31 - 1 points.
  CellIndex(PointCloud2 points, const SurfaceOptions& surfaces, const CellOptions& cells = {});

  /// These points and `added` behind them, numbers unchanged. Lines near the new points are estimated anew. Costs what
  /// the tiles around the added points cost, however many others there are.
  CellIndex with_added(PointView<2> added) const;

  /// These points without some, which keep their numbers but are no longer finite. Costs a copy of the coordinates and
  /// the tiles around the points. Throws Error where a number is out of range.
  CellIndex with_removed(std::span<const int> which) const;

  std::size_t size() const noexcept;
  PointView<2> points() const noexcept;
  bool has_surfaces() const noexcept;
  /// The line that the map follows around a point; not valid() where there is none.
  Surface2 surface(std::size_t number) const noexcept;
  /// Median distance from a point to its nearest neighbour [m], over a sample; 0 with fewer than two points.
  double spacing() const noexcept;
  /// How well the map knows its lines; all zero without lines.
  const LineNoise& line_noise() const noexcept;

  Neighbour nearest(const Point2& query, double reach) const noexcept;
  NearestTwo nearest_two(const Point2& query, double reach) const noexcept;
  /// Up to `found.size()` nearest points closer than `reach`, nearest first. Returns how many.
  std::size_t nearest_k(const Point2& query, double reach, std::span<Neighbour> found) const noexcept;
  /// Appends the number of every point closer than `radius` to `indices`, in no particular order.
  void within(const Point2& query, double radius, std::vector<int>& indices) const;

  /// Builds the cells of up to so many tiles that have none yet, those near a place first, and publishes them to all
  /// readers, who need not stop. For maps made with CellOptions::eager = false: call it beside the running robot, or
  /// between scans, until it returns 0. About 0.4 ms a tile.
  /// @returns how many tiles were built
  std::size_t build(std::size_t tiles, const Point2& near) const;

  /// Changes with every call of build() that built something, here or in an index this one shares tiles with.
  std::uint64_t builds() const noexcept;
  /// No two indices in this process have the same, but for copies.
  std::uint64_t id() const noexcept;
  const CellOptions& cell_options() const noexcept;
  /// Of all that this index holds, the coordinates and what it shares with others included [bytes].
  std::size_t memory() const noexcept;

  /// What a reader of tables needs to know: the plane is cut at multiples of `tile` and, within a tile, of `cell`.
  double cell() const noexcept;
  double tile() const noexcept;
  /// In which unit a CellTable bounds distances [m].
  double distance_unit() const noexcept;
  /// In which unit a CellTable has places [m].
  double place_unit() const noexcept;
  /// Writes the tables of width x width tiles, row by row, the first at (x, y). Where nothing is within reach stands a
  /// table without candidates, where none is built one that cannot answer. They live as long as the index.
  void tables(int x, int y, int width, std::span<const CellTable*> tables) const noexcept;
  /// Tables of the two kinds named above.
  static const CellTable& empty_table() noexcept;
  static const CellTable& unbuilt_table() noexcept;

 private:
  struct State;
  friend class CellIndexEdit;
  explicit CellIndex(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

static_assert(NearestNeighbourIndex<CellIndex, 2>);

}  // namespace slamicp
