// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace slamicp {

/// Cells along a side of a tile.
inline constexpr int tile_cells = 16;

/// A map point that is nearest to some place of a cell, and the line that the map follows there. Coordinates relative
/// to the tile's lower corner [m].
struct Candidate {
  float x, y;
  std::int16_t normal_x, normal_y;  ///< of the line, times line_scale; both zero where there is no line
  float offset;                     ///< of the line: the places p on it have normal . p = offset
};

inline constexpr float line_scale = 32767.0F;

/// A tile of 16 x 16 cells as a match reads it: for each cell every map point that can be nearest to some place in it,
/// side by side. Plain numbers at known places, so that vector code gathers from it; the candidates follow in memory,
/// the points' numbers follow them.
struct CellTable {
  /// A cell in one word: bits 0-5 how many candidates, 6-19 where they begin, 20-25 and 26-31 a bound from above and
  /// from below on the distance from any place of the cell to the nearest point, in CellIndex::distance_unit().
  std::uint32_t cells[tile_cells * tile_cells];
  std::uint32_t count;  ///< of all candidates; the first one is far from everything
  std::uint32_t unused[3];

  /// As a count: the cell cannot answer, ask the index.
  static constexpr std::uint32_t no_answer = 63;
  static constexpr std::uint32_t most_candidates = 1U << 14U;  // of a tile
  static constexpr std::uint32_t farthest = 63;                // a distance bound: this far or farther

  static constexpr std::uint32_t word(std::uint32_t count, std::uint32_t begin, std::uint32_t above,
                                      std::uint32_t below) noexcept {
    return count | (begin << 6U) | (above << 20U) | (below << 26U);
  }
  static constexpr std::uint32_t count_of(std::uint32_t word) noexcept { return word & 63U; }
  static constexpr std::uint32_t begin_of(std::uint32_t word) noexcept { return (word >> 6U) & 0x3FFFU; }
  static constexpr std::uint32_t above_of(std::uint32_t word) noexcept { return (word >> 20U) & 63U; }
  static constexpr std::uint32_t below_of(std::uint32_t word) noexcept { return word >> 26U; }

  const Candidate* candidates() const noexcept { return reinterpret_cast<const Candidate*>(this + 1); }
  const std::int32_t* numbers() const noexcept { return reinterpret_cast<const std::int32_t*>(candidates() + count); }
};

static_assert(sizeof(Candidate) == 16 && sizeof(CellTable) == 1040);

}  // namespace slamicp
