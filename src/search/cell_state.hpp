// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/search/cell_index.hpp>

#include "search/cell_builder.hpp"
#include "search/point_buffer.hpp"
#include "search/tile_search.hpp"

namespace slamicp {

/// What versions of an index have in common, and which tiles were there to build when the first was made.
struct BuildProgress {
  std::vector<TilePlace> places;
  std::atomic<std::size_t> next{0};
  std::atomic<std::uint64_t> builds{0};
};

struct CellIndex::State {
  State(const SurfaceOptions& with_surfaces, const CellOptions& with_cells)
      : grid(with_cells.cell), surfaces(with_surfaces), cells(with_cells) {}

  TileGrid grid;
  SurfaceOptions surfaces;
  CellOptions cells;
  PointBuffer points;
  TileDirectory tiles;
  double spacing = 0.0;
  LineNoise line_noise;
  std::size_t spacing_of = 0;  // how many points there were when both were sampled
  std::uint64_t id = 0;
  std::shared_ptr<BuildProgress> progress;

  TileSearch search() const noexcept { return {grid, points.view(), tiles}; }
  std::size_t nearest_k(const Point2& query, double reach, std::span<Neighbour> found) const noexcept;
  void measure_spacing() noexcept;

  /// Calls use(place) for the tiles that a point within the bounds can be a candidate in.
  template <typename Use>
  void for_each_place_within_reach(const Bounds<2>& bounds, const Use& use) const {
    const Point2 reach = Point2::Constant(cells.reach + grid.cell);
    const TilePlace lower = grid.place_of(bounds.lower - reach);
    const TilePlace upper = grid.place_of(bounds.upper + reach);
    for (int y = lower.y; y <= upper.y; ++y)
      for (int x = lower.x; x <= upper.x; ++x) use(TilePlace{x, y});
  }

  /// Estimates the line at a point: reads coordinates only.
  Line fit_line(int number) const noexcept;
  /// What a line is to count. @param scatter  of its points, mean square [m^2]  @param count  of its points
  double trust_of(double scatter, double count) const noexcept;
  /// The tile's lines, built and published if need be; null where the map has no surfaces.
  const std::vector<Line>* lines_of(const Tile& tile) const;
  /// The points within reach of a tile, lines included.
  void collect(const Tile& tile, std::vector<CellPoint>& points) const;
  /// Builds and publishes a tile's table. Returns false if another thread was faster.
  bool build_table(const Tile& tile, CellBuilder& builder, std::vector<CellPoint>& room) const;
  void build_all() const;
};

/// A new number at every call.
std::uint64_t next_index_id() noexcept;

/// True for points that an index finds.
inline bool can_be_found(const Point2& point) noexcept {
  constexpr double far_away = 1e7;
  return point.cwiseAbs().maxCoeff() <= far_away && is_finite<2>(point);
}

}  // namespace slamicp
