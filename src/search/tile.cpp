// SPDX-License-Identifier: Apache-2.0
#include "search/tile.hpp"

#include <algorithm>

namespace slamicp {

void FreeTable::operator()(const CellTable* table) const noexcept {
  if (table != nullptr)
    ::operator delete(reinterpret_cast<char*>(const_cast<CellTable*>(table)) - lines_bytes(table->count));
}

Tile::Tile(TilePlace place, std::vector<int> numbers, PointView<2> points, const TileGrid& grid)
    : place_(place), numbers_(std::move(numbers)) {
  const auto cell_of = [&](int number) {
    const Point2& point = points[static_cast<std::size_t>(number)];
    return static_cast<std::uint32_t>(TileGrid::within_tile(grid.cell_of(point.y())) * tile_cells +
                                      TileGrid::within_tile(grid.cell_of(point.x())));
  };
  std::vector<std::uint64_t> keys(numbers_.size());  // cell, then number: one sort of plain words
  for (std::size_t j = 0; j < keys.size(); ++j)
    keys[j] = (std::uint64_t{cell_of(numbers_[j])} << 32U) | static_cast<std::uint32_t>(numbers_[j]);
  std::sort(keys.begin(), keys.end());

  std::uint64_t last = tile_cells * tile_cells;
  for (std::size_t j = 0; j < keys.size(); ++j) {
    numbers_[j] = static_cast<int>(keys[j] & 0xFFFFFFFFU);
    const std::uint64_t cell = keys[j] >> 32U;
    if (cell == last) continue;
    occupied_[cell >> 6U] |= std::uint64_t{1} << (cell & 63U);
    starts_.push_back(static_cast<std::uint32_t>(j));
    last = cell;
  }
  starts_.push_back(static_cast<std::uint32_t>(keys.size()));
  starts_.shrink_to_fit();
  for (std::size_t word = 1; word < occupied_.size(); ++word)
    rank_[word] = static_cast<std::uint16_t>(rank_[word - 1] + std::popcount(occupied_[word - 1]));
}

std::size_t Tile::memory() const noexcept {
  std::size_t bytes = sizeof *this + numbers_.capacity() * sizeof(int) + starts_.capacity() * sizeof(std::uint32_t);
  if (const auto* built = lines()) bytes += sizeof *built + built->capacity() * sizeof(Line);
  if (const CellTable* built = table()) bytes += table_bytes(built->count);
  return bytes;
}

}  // namespace slamicp
