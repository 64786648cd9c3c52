// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <compare>
#include <memory>
#include <new>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/search/cell_table.hpp>

namespace slamicp {

/// Which tile: its lower corner is at (x, y) times the tile's side.
struct TilePlace {
  int x = 0;
  int y = 0;
  auto operator<=>(const TilePlace&) const = default;
};

/// How the plane is cut. Sides are such that a float holds any multiple of them that a scan can reach.
struct TileGrid {
  double cell;
  double tile;
  double cells_per_metre;

  explicit TileGrid(double wanted) noexcept
      : cell(std::max(1.0, std::round(wanted * 65536.0)) / 65536.0),
        tile(tile_cells * cell),
        cells_per_metre(1.0 / cell) {}

  /// Which column (row) of cells; places beyond what an int can count fall into the last one.
  int cell_of(double coordinate) const noexcept {
    constexpr double last = 2e9;
    return static_cast<int>(std::floor(std::clamp(coordinate * cells_per_metre, -last, last)));
  }
  static int tile_of(int cell) noexcept { return cell >> 4; }
  static int within_tile(int cell) noexcept { return cell & 15; }
  TilePlace place_of(const Point2& point) const noexcept {
    return {tile_of(cell_of(point.x())), tile_of(cell_of(point.y()))};
  }
  Point2 corner(TilePlace place) const noexcept { return {place.x * tile, place.y * tile}; }
};

/// The line that the map follows at one of its points.
struct Line {
  float normal_x = 0.0F;
  float normal_y = 0.0F;
  float offset = 0.0F;  ///< from the point to the line, along the normal [m]
  /// How far the neighbours that made it reach [m]; infinite where it could take more.
  float window = std::numeric_limits<float>::infinity();
  float trust = 1.0F;  ///< see Surface

  bool valid() const noexcept { return normal_x != 0.0F || normal_y != 0.0F; }
};

struct FreeTable {
  void operator()(const CellTable* table) const noexcept;
};
using CellTablePointer = std::unique_ptr<const CellTable, FreeTable>;

/// How much of a table of so many candidates lies in front of its head.
constexpr std::size_t lines_bytes(std::uint32_t count) noexcept {
  constexpr std::size_t whole = 64;  // so that heads begin a cache line where tables do
  return (sizeof(CellLine) * (count + CellTable::spare) + whole - 1) / whole * whole;
}
constexpr std::size_t table_bytes(std::uint32_t count) noexcept {
  return lines_bytes(count) + sizeof(CellTable) + sizeof(CellPlace) * (count + CellTable::spare);
}

/// The map points in a square, by cell, and what was worked out from them: lines and the table of cells. Both are built
/// once, by whoever comes first, and published for all readers.
class Tile {
 public:
  /// @param numbers  of the points in the tile, in any order
  Tile(TilePlace place, std::vector<int> numbers, PointView<2> points, const TileGrid& grid);
  ~Tile() {
    delete lines_.load(std::memory_order_relaxed);
    FreeTable()(table_.load(std::memory_order_relaxed));
  }
  Tile(const Tile&) = delete;
  Tile& operator=(const Tile&) = delete;

  TilePlace place() const noexcept { return place_; }
  const std::vector<int>& numbers() const noexcept { return numbers_; }

  /// The points of columns first..last of a row of cells: a piece of numbers().
  struct Piece {
    std::uint32_t begin, end;
  };
  Piece row_piece(int row, int first, int last) const noexcept {
    const std::uint64_t word = occupied_[static_cast<std::size_t>(row >> 2)];
    const int shift = (row & 3) * tile_cells;
    const std::uint64_t below = (std::uint64_t{1} << static_cast<unsigned>(shift + first)) - 1;
    const std::uint64_t in_row = (word >> static_cast<unsigned>(shift)) & 0xFFFFU;
    const std::uint64_t up_to = (std::uint64_t{2} << static_cast<unsigned>(last)) - 1;
    const std::uint64_t wanted = (in_row & up_to) >> static_cast<unsigned>(first);
    if (wanted == 0) return {0, 0};
    const std::size_t rank =
        rank_[static_cast<std::size_t>(row >> 2)] + static_cast<std::size_t>(std::popcount(word & below));
    return {starts_[rank], starts_[rank + static_cast<std::size_t>(std::popcount(wanted))]};
  }

  /// One for each of numbers(); null until built.
  const std::vector<Line>* lines() const noexcept { return lines_.load(std::memory_order_acquire); }
  /// Null until built.
  const CellTable* table() const noexcept { return table_.load(std::memory_order_acquire); }

  /// Keeps what comes first; every builder comes to the same.
  void publish(std::unique_ptr<const std::vector<Line>> lines) const noexcept {
    const std::vector<Line>* none = nullptr;
    if (lines_.compare_exchange_strong(none, lines.get(), std::memory_order_acq_rel))
      static_cast<void>(lines.release());
  }
  bool publish(CellTablePointer table) const noexcept {
    const CellTable* none = nullptr;
    const bool first = table_.compare_exchange_strong(none, table.get(), std::memory_order_acq_rel);
    if (first) static_cast<void>(table.release());
    return first;
  }

  std::size_t memory() const noexcept;

 private:
  TilePlace place_;
  std::vector<int> numbers_;                 // by cell, then rising
  std::array<std::uint64_t, 4> occupied_{};  // a bit a cell, four rows a word
  std::array<std::uint16_t, 4> rank_{};      // occupied cells before each word
  std::vector<std::uint32_t> starts_;        // into numbers_, one for each occupied cell, and the end
  mutable std::atomic<const std::vector<Line>*> lines_{nullptr};
  mutable std::atomic<const CellTable*> table_{nullptr};
};

}  // namespace slamicp
