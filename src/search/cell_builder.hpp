// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "search/tile.hpp"

namespace slamicp {

/// A map point as a tile sees it.
struct CellPoint {
  double x, y;  ///< from the tile's lower corner [m]
  int number;
  CellLine line;
};

/// @param place  from the tile's lower corner [m]
CellPoint cell_point(const Point2& place, int number, const Line& line) noexcept;

/// Makes the tables of tiles: for each cell, the points whose Voronoi cells meet it. Keeps its memory between tiles.
class CellBuilder {
 public:
  CellBuilder(const TileGrid& grid, double reach);

  double reach() const noexcept { return reach_; }

  /// @param points  every point within reach of the tile
  CellTablePointer build(std::span<const CellPoint> points);

  /// The table with more points: lists gain those that may be nearest, and are not cut down as build() would, until
  /// they grow long.
  /// @param old      of the same tile
  /// @param corner   the tile's lower corner [m]
  /// @param all      coordinates of all points, by number
  /// @param added    the new points within reach of the tile
  /// @param changed  points of the old table whose lines are other ones now, numbers rising
  CellTablePointer grow(const CellTable& old, const Point2& corner, PointView<2> all, std::span<const CellPoint> added,
                        std::span<const CellPoint> changed);

 private:
  struct Square {
    double x, y, side;                                     // lower corner
    double to(const CellPoint& point) const noexcept;      // squared distance to its nearest place
    double across(const CellPoint& point) const noexcept;  // squared distance to its farthest place
  };
  using Points = std::vector<CellPoint>;

  void split(std::size_t level, const Square& square, int column, int row, int cells);
  void fill_cell(Points& points, const Square& square, std::size_t cell);
  void cut_down(Points& points, const Square& square);
  void thin_out(Points& points, const Square& square);
  void find_cells(std::span<const CellPoint> added, const CellTable& old);
  void put(std::size_t cell, std::span<const CellPoint> points, const Square& square);
  void begin_table() noexcept;
  CellTablePointer finish_table() const;
  Square square_of(std::size_t cell) const noexcept;
  std::uint32_t unit_above(double squared_distance) const noexcept;
  std::uint32_t unit_below(double squared_distance) const noexcept;

  TileGrid grid_;
  double reach_;
  std::array<Points, 6> levels_;  // points that may matter to the square that split() is at, one list a level
  Points survivors_;
  struct Meeting {
    std::uint32_t cell, point;
  };
  std::vector<Meeting> meetings_;  // which added point may matter to which cell
  std::array<std::uint32_t, tile_cells * tile_cells> words_{};
  std::vector<CellPlace> places_;
  std::vector<CellLine> lines_;
  std::vector<std::int32_t> numbers_;
};

/// The unit of a table's distance bounds [m].
double distance_unit(const TileGrid& grid, double reach) noexcept;
/// The unit of a table's places [m].
double place_unit(const TileGrid& grid, double reach) noexcept;

}  // namespace slamicp
