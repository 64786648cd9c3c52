// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "search/tile_directory.hpp"
#include "search/visitors.hpp"

namespace slamicp {

/// Finds points by the cells they lie in: no table needed. Exact, for any reach.
class TileSearch {
 public:
  TileSearch(const TileGrid& grid, PointView<2> points, const TileDirectory& tiles) noexcept
      : grid_(grid), points_(points), tiles_(tiles) {}

  /// Shows the visitor every point not beyond its bound: first those in the 3 x 3 cells around the query, so that the
  /// bound is small when it comes to the rest.
  template <typename Visitor>
  void visit(const Point2& query, Visitor& visitor) const noexcept(noexcept(visitor.see(0, 0.0))) {
    constexpr double countless = 1e150;  // squares of more are infinite
    if (!(query.cwiseAbs().maxCoeff() < countless) || !is_finite<2>(query)) return;
    const int column = grid_.cell_of(query.x());
    const int row = grid_.cell_of(query.y());
    const Block home{column - 1, column + 1, row - 1, row + 1};
    tiles_.for_each_in(home.lower(), home.upper(), [&](const Tile& tile) { see_block(tile, home, query, visitor); });
    const double reach = radius(visitor);
    const TilePlace lower = grid_.place_of(query - Point2::Constant(reach));
    const TilePlace upper = grid_.place_of(query + Point2::Constant(reach));
    tiles_.for_each_in(lower, upper, [&](const Tile& tile) { see_rest(tile, home, query, visitor); });
  }

  Neighbour nearest(const Point2& query, double reach) const noexcept {
    NearestVisitor visitor{reach * reach};
    visit(query, visitor);
    return visitor.best;
  }

 private:
  /// Columns and rows of cells, ends included.
  struct Block {
    int left, right, bottom, top;
    TilePlace lower() const noexcept { return {TileGrid::tile_of(left), TileGrid::tile_of(bottom)}; }
    TilePlace upper() const noexcept { return {TileGrid::tile_of(right), TileGrid::tile_of(top)}; }
  };

  // Cells are told apart by rounded coordinates: a bound looks this much farther [m].
  static constexpr double rounding = 1e-7;

  template <typename Visitor>
  static double radius(const Visitor& visitor) noexcept {
    return std::sqrt(visitor.bound()) * (1.0 + 1e-9) + rounding;
  }

  template <typename Visitor>
  void see(const Tile& tile, Tile::Piece piece, const Point2& query, Visitor& visitor) const {
    for (std::uint32_t j = piece.begin; j < piece.end; ++j) {
      const int number = tile.numbers()[j];
      visitor.see(number, (points_[static_cast<std::size_t>(number)] - query).squaredNorm());
    }
  }

  template <typename Visitor>
  void see_block(const Tile& tile, const Block& block, const Point2& query, Visitor& visitor) const {
    const int x = tile.place().x * tile_cells;
    const int y = tile.place().y * tile_cells;
    const int left = std::max(block.left - x, 0);
    const int right = std::min(block.right - x, tile_cells - 1);
    const int top = std::min(block.top - y, tile_cells - 1);
    for (int row = std::max(block.bottom - y, 0); row <= top; ++row)
      see(tile, tile.row_piece(row, left, right), query, visitor);
  }

  /// The tile's points within the bound that are not in `seen`.
  template <typename Visitor>
  void see_rest(const Tile& tile, const Block& seen, const Point2& query, Visitor& visitor) const {
    if (tile.numbers().empty()) return;
    const Point2 corner = grid_.corner(tile.place());
    const Point2 from_corner = query - corner;
    const double aside = std::max({-from_corner.x(), from_corner.x() - grid_.tile, 0.0});
    const double above = std::max({-from_corner.y(), from_corner.y() - grid_.tile, 0.0});
    const double first_bound = radius(visitor);
    if (aside * aside + above * above > first_bound * first_bound) return;
    const auto within = [&](double coordinate) {
      return static_cast<int>(std::clamp(std::floor(coordinate * grid_.cells_per_metre), 0.0, 15.0));
    };
    const int last_row = within(from_corner.y() + first_bound);
    for (int row = within(from_corner.y() - first_bound); row <= last_row; ++row) {
      const double bottom = row * grid_.cell;
      const double off = std::max({bottom - from_corner.y(), from_corner.y() - bottom - grid_.cell, 0.0});
      const double bound = radius(visitor);
      if (off > bound) continue;
      const double half = std::sqrt(bound * bound - off * off) + rounding;
      if (from_corner.x() + half < 0.0 || from_corner.x() - half > grid_.tile) continue;
      const int left = within(from_corner.x() - half);
      const int right = within(from_corner.x() + half);
      const int row_of_all = tile.place().y * tile_cells + row;
      if (row_of_all < seen.bottom || row_of_all > seen.top) {
        see(tile, tile.row_piece(row, left, right), query, visitor);
        continue;
      }
      const int x = tile.place().x * tile_cells;
      const int until = std::min(right, seen.left - x - 1);
      const int again = std::max(left, seen.right - x + 1);
      if (left <= until) see(tile, tile.row_piece(row, left, until), query, visitor);
      if (again <= right) see(tile, tile.row_piece(row, again, right), query, visitor);
    }
  }

  const TileGrid& grid_;
  PointView<2> points_;
  const TileDirectory& tiles_;
};

}  // namespace slamicp
