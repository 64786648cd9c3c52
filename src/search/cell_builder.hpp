// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "search/tile.hpp"

namespace slamicp {

/// A map point as a tile sees it.
struct CellPoint {
  double x, y;  ///< from the tile's lower corner [m]
  CellLine line;

  int number() const noexcept { return line.number; }
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
  /// they grow long; what they were before stays behind as waste. Null where there would be more waste than table: then
  /// it has to be built.
  /// @param old      of the same tile
  /// @param corner   the tile's lower corner [m]
  /// @param all      coordinates of all points, by number
  /// @param added    the new points within reach of the tile
  /// @param changed  points of the old table whose lines are other ones now, numbers rising
  CellTablePointer grow(const CellTable& old, const Point2& corner, PointView<2> all, std::span<const CellPoint> added,
                        std::span<const CellPoint> changed);

 private:
  struct Square {
    double x, y, side;  // lower corner
    /// Squared distance from a point to the nearest place in it.
    double to(const CellPoint& point) const noexcept {
      const double dx = std::max({x - point.x, point.x - x - side, 0.0});
      const double dy = std::max({y - point.y, point.y - y - side, 0.0});
      return dx * dx + dy * dy;
    }
    /// Squared distance from a point to the farthest place in it.
    double across(const CellPoint& point) const noexcept {
      const double dx = std::max(point.x - x, x + side - point.x);
      const double dy = std::max(point.y - y, y + side - point.y);
      return dx * dx + dy * dy;
    }
  };
  using Points = std::vector<CellPoint>;

  template <typename Fill>
  void split(std::size_t level, const Square& square, int column, int row, int cells, const Fill& fill);
  void cut_down(Points& points, const Square& square);
  void thin_out(Points& points, const Square& square);
  void put(std::size_t cell, std::span<const CellPoint> points, const Square& square);
  void begin_table();
  void continue_table(const CellTable& old, std::span<const CellPoint> changed);
  CellTablePointer finish_table() const;
  CellPlace in_units(const CellPoint& point) const noexcept;
  std::uint32_t unit_above(double squared_distance) const noexcept;
  std::uint32_t unit_below(double squared_distance) const noexcept;

  TileGrid grid_;
  double reach_;
  double units_per_metre_;
  double distance_unit_;
  std::array<Points, 6> levels_;  // points that may matter to the square that split() is at, one list a level
  Points survivors_;
  std::array<std::uint32_t, cells_of_a_tile> words_{};
  std::vector<CellPlace> places_;
  std::vector<CellLine> lines_;
};

/// The unit of a table's distance bounds [m].
double distance_unit(const TileGrid& grid, double reach) noexcept;
/// The unit of a table's places [m].
double place_unit(const TileGrid& grid, double reach) noexcept;

}  // namespace slamicp
