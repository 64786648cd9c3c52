// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace slamicp {

/// Cells along a side of a tile.
inline constexpr int tile_cells = 16;
/// Cells of a tile.
inline constexpr std::size_t cells_of_a_tile = std::size_t{tile_cells} * tile_cells;

/// A place, from the centre of its tile, in CellIndex::place_unit(): good enough to tell which point is nearest, but
/// for two as near as about 0.05 mm to each other in distance.
struct CellPlace {
  std::int16_t x, y;
};

/// Which point it is, and the line that the map follows there.
struct CellLine {
  std::int16_t normal_x, normal_y;  ///< times line_scale; both zero where there is no line
  float offset;         ///< [m]: the places p on it, from the lower corner of the tile, have normal . p = offset
  std::int32_t number;  ///< of the point
};

inline constexpr float line_scale = 32767.0F;

/// A tile of 16 x 16 cells as a match reads it: for each cell every map point that can be nearest to some place in it,
/// side by side. In memory the points' lines lie in front of this head, the last one first, and the places behind it,
/// with `spare` places far from everything at their end: so that both are found from the head alone.
struct CellTable {
  /// A cell in one word: bits 0-5 how many candidates, 6-19 the first, 20-25 and 26-31 a bound from above and from
  /// below on the distance from any place of the cell to the nearest point, in CellIndex::distance_unit().
  std::uint32_t cells[cells_of_a_tile];
  std::uint32_t count;  ///< of all candidates
  std::uint32_t unused[3];

  /// As a count: the cell cannot answer, ask the index.
  static constexpr std::uint32_t no_answer = 63;
  static constexpr std::uint32_t most_candidates = 1U << 14U;  // of a tile
  static constexpr std::uint32_t farthest = 63;                // a distance bound: this far or farther
  /// A reader may look at so many places at once, from any candidate on: those behind a list are map points too.
  static constexpr std::uint32_t spare = 16;

  static constexpr std::uint32_t word(std::uint32_t count, std::uint32_t first, std::uint32_t above,
                                      std::uint32_t below) noexcept {
    return count | (first << 6U) | (above << 20U) | (below << 26U);
  }
  static constexpr std::uint32_t count_of(std::uint32_t word) noexcept { return word & 63U; }
  static constexpr std::uint32_t first_of(std::uint32_t word) noexcept { return (word >> 6U) & 0x3FFFU; }
  static constexpr std::uint32_t above_of(std::uint32_t word) noexcept { return (word >> 20U) & 63U; }
  static constexpr std::uint32_t below_of(std::uint32_t word) noexcept { return word >> 26U; }

  const CellPlace* places() const noexcept { return reinterpret_cast<const CellPlace*>(this + 1); }
  const CellLine& line(std::uint32_t k) const noexcept { return *(reinterpret_cast<const CellLine*>(this) - 1 - k); }
};

static_assert(sizeof(CellPlace) == 4 && sizeof(CellLine) == 12 && sizeof(CellTable) == 1040);

}  // namespace slamicp
