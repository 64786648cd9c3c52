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
  if (numbers_.empty()) return;
  // Counted into cells, which keeps numbers in order.
  if (!std::is_sorted(numbers_.begin(), numbers_.end())) std::sort(numbers_.begin(), numbers_.end());
  std::array<std::uint32_t, cells_of_a_tile> ends{};
  std::vector<std::uint8_t> cells(numbers_.size());
  for (std::size_t j = 0; j < cells.size(); ++j) {
    const Point2& point = points[static_cast<std::size_t>(numbers_[j])];
    const int row = TileGrid::within_tile(grid.cell_of(point.y()));
    cells[j] = static_cast<std::uint8_t>(row * tile_cells + TileGrid::within_tile(grid.cell_of(point.x())));
    ++ends[cells[j]];
  }
  std::size_t occupied = 0;
  for (std::size_t cell = 0; cell < ends.size(); ++cell) {
    if (ends[cell] == 0) continue;
    occupied_[cell >> 6U] |= std::uint64_t{1} << (cell & 63U);
    ++occupied;
  }
  starts_.reserve(occupied + 1);
  std::uint32_t begin = 0;
  for (std::uint32_t& end : ends) {
    const std::uint32_t count = end;
    if (count > 0) starts_.push_back(begin);
    end = begin;  // where the next of the cell goes
    begin += count;
  }
  starts_.push_back(begin);
  std::vector<int> ordered(numbers_.size());
  for (std::size_t j = 0; j < cells.size(); ++j) ordered[ends[cells[j]]++] = numbers_[j];
  numbers_ = std::move(ordered);
  for (std::size_t word = 1; word < occupied_.size(); ++word)
    rank_[word] = static_cast<std::uint16_t>(rank_[word - 1] + std::popcount(occupied_[word - 1]));
}

std::size_t Tile::memory() const noexcept {
  std::size_t bytes = sizeof *this + numbers_.capacity() * sizeof(int) + starts_.capacity() * sizeof(std::uint32_t);
  if (const auto* built = lines()) bytes += sizeof(std::vector<Line>) + built->capacity() * sizeof(Line);
  if (const CellTable* built = table()) bytes += table_bytes(built->count);
  return bytes;
}

}  // namespace slamicp
