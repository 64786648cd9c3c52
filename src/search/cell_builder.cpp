// SPDX-License-Identifier: Apache-2.0
#include "search/cell_builder.hpp"

#include <algorithm>
#include <cmath>

#include "search/cell_clip.hpp"

namespace slamicp {
namespace {

// A query in float may fall into the cell beside its own: lists are good for so much more than the cell [m].
constexpr double margin = 2e-5;
// Squared distances as near as this count as the same [m^2].
constexpr double slack = 1e-9;
// A grown list longer than this is cut down: twice what a match looks at in one go.
constexpr std::size_t long_list = 32;

constexpr CellPlace nowhere{32767, 32767};  // a reach from the tile, and more

bool same_place(const CellPoint& a, const CellPoint& b) noexcept { return a.x == b.x && a.y == b.y; }

/// True if q is nearer than p all over the square around the origin.
bool is_beaten(const CellPoint& p, const CellPoint& q, double cx, double cy, double half) noexcept {
  const double px = p.x - cx, py = p.y - cy, qx = q.x - cx, qy = q.y - cy;
  const double least = px * px + py * py - qx * qx - qy * qy - 2.0 * half * (std::abs(px - qx) + std::abs(py - qy));
  return least > slack;
}

}  // namespace

CellPoint cell_point(const Point2& place, int number, const Line& line) noexcept {
  // A normal that is shorter by what the line is trusted makes residuals that count so much less.
  const auto whole = [&](float normal) {
    return static_cast<std::int16_t>(std::lround(line.trust * normal * line_scale));
  };
  CellLine stored{whole(line.normal_x), whole(line.normal_y), 0.0F, number};
  // The offset is of the normal as rounded, so that the line goes through the same place.
  const double nx = stored.normal_x / static_cast<double>(line_scale);
  const double ny = stored.normal_y / static_cast<double>(line_scale);
  const double turn = nx * static_cast<double>(line.normal_x) + ny * static_cast<double>(line.normal_y);
  stored.offset = static_cast<float>(nx * place.x() + ny * place.y() + turn * static_cast<double>(line.offset));
  return {place.x(), place.y(), stored};
}

double distance_unit(const TileGrid& grid, double reach) noexcept { return (reach + 3.0 * grid.cell) / 62.0; }

double place_unit(const TileGrid& grid, double reach) noexcept {
  return (0.5 * grid.tile + reach + grid.cell) / 32767.0;
}

CellBuilder::CellBuilder(const TileGrid& grid, double reach)
    : grid_(grid),
      reach_(reach),
      units_per_metre_(1.0 / place_unit(grid, reach)),
      distance_unit_(distance_unit(grid, reach)) {}

void CellBuilder::begin_table() {
  words_.fill(CellTable::word(0, 0, CellTable::farthest, CellTable::farthest));
  places_.clear();
  lines_.clear();
}

CellTablePointer CellBuilder::finish_table() const {
  const auto count = static_cast<std::uint32_t>(places_.size());
  char* memory = static_cast<char*>(::operator new(table_bytes(count)));
  auto* table = new (memory + lines_bytes(count)) CellTable;
  std::copy(words_.begin(), words_.end(), table->cells);
  table->count = count;
  std::fill(std::begin(table->unused), std::end(table->unused), 0U);
  auto* places = reinterpret_cast<CellPlace*>(table + 1);
  std::fill(std::copy(places_.begin(), places_.end(), places), places + count + CellTable::spare, nowhere);
  auto* line = reinterpret_cast<CellLine*>(table);
  for (const CellLine& one : lines_) *--line = one;
  std::fill(line - CellTable::spare, line, CellLine{0, 0, 0.0F, -1});
  return CellTablePointer(table);
}

std::uint32_t CellBuilder::unit_above(double squared_distance) const noexcept {
  const double units = std::ceil(std::sqrt(squared_distance) / distance_unit_ + 1e-6);
  return static_cast<std::uint32_t>(std::min(units, static_cast<double>(CellTable::farthest)));
}

std::uint32_t CellBuilder::unit_below(double squared_distance) const noexcept {
  const double units = std::floor(std::sqrt(squared_distance) / distance_unit_ - 1e-6);
  return static_cast<std::uint32_t>(std::clamp(units, 0.0, static_cast<double>(CellTable::farthest)));
}

CellTablePointer CellBuilder::build(std::span<const CellPoint> points) {
  begin_table();
  levels_[0].assign(points.begin(), points.end());
  const Square all{-margin, -margin, grid_.tile + 2.0 * margin};
  split(0, all, 0, 0, tile_cells, [&](std::size_t cell, Points& near, const Square& square) {
    cut_down(near, square);
    put(cell, near, square);
  });
  return finish_table();
}

/// Calls fill(cell, the points that may be nearest to some place in it, its square) for every cell that has such
/// points.
template <typename Fill>
void CellBuilder::split(std::size_t level, const Square& square, int column, int row, int cells, const Fill& fill) {
  // Nobody in the square has its nearest point farther than the point with the nearest farthest place.
  double bound = reach_ * reach_;
  for (const CellPoint& point : levels_[level]) bound = std::min(bound, square.across(point));
  bound += slack;
  Points& near = levels_[level + 1];
  near.clear();
  for (const CellPoint& point : levels_[level])
    if (square.to(point) <= bound) near.push_back(point);
  if (near.empty()) return;
  if (cells == 1) {
    fill(static_cast<std::size_t>(row) * tile_cells + static_cast<std::size_t>(column), near, square);
    return;
  }
  const int half = cells / 2;
  for (int part = 0; part < 4; ++part) {
    const int to_x = column + (part & 1) * half;
    const int to_y = row + (part >> 1) * half;
    const Square quarter{to_x * grid_.cell - margin, to_y * grid_.cell - margin, half * grid_.cell + 2.0 * margin};
    split(level + 1, quarter, to_x, to_y, half, fill);
  }
}

/// The order in which a cell lists its points: nearest to the centre of the square first.
struct NearerToCentre {
  double x, y;
  bool operator()(const CellPoint& a, const CellPoint& b) const noexcept {
    const double da = (a.x - x) * (a.x - x) + (a.y - y) * (a.y - y);
    const double db = (b.x - x) * (b.x - x) + (b.y - y) * (b.y - y);
    return da < db || (da == db && a.number() < b.number());
  }
};

/// Leaves out points that the one nearest to the centre beats all over the square. Quick, and keeps some too many.
void CellBuilder::thin_out(Points& points, const Square& square) {
  if (points.size() < 2) return;
  const double half = 0.5 * square.side;
  const double cx = square.x + half;
  const double cy = square.y + half;
  std::iter_swap(points.begin(), std::min_element(points.begin(), points.end(), NearerToCentre{cx, cy}));
  const CellPoint first = points.front();
  const auto is_out = [&](const CellPoint& p) {
    return is_beaten(p, first, cx, cy, half) || (same_place(p, first) && p.number() > first.number());
  };
  points.erase(std::remove_if(points.begin() + 1, points.end(), is_out), points.end());
}

/// Leaves the points that are nearest to some place in the square, nearest to its centre first.
void CellBuilder::cut_down(Points& points, const Square& square) {
  thin_out(points, square);
  if (points.size() < 2) return;
  const double half = 0.5 * square.side;
  const double cx = square.x + half;
  const double cy = square.y + half;
  std::sort(points.begin() + 1, points.end(), NearerToCentre{cx, cy});

  survivors_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CellPoint& p = points[i];
    CellClip clip(half);
    for (std::size_t j = 0; j < points.size() && !clip.empty(); ++j) {
      if (j == i) continue;
      const CellPoint& q = points[j];
      if (same_place(p, q)) {
        if (q.number() < p.number()) break;  // the lower number answers for both
        continue;
      }
      clip.keep_nearer(p.x - cx, p.y - cy, q.x - cx, q.y - cy);
    }
    const bool has_twin = std::any_of(survivors_.begin(), survivors_.end(),
                                      [&](const CellPoint& q) { return same_place(p, q) && q.number() < p.number(); });
    if (!clip.empty() && !has_twin) survivors_.push_back(p);
  }
  points.assign(survivors_.begin(), survivors_.end());
}

/// Starts with all that a table has.
void CellBuilder::continue_table(const CellTable& old, std::span<const CellPoint> changed) {
  std::copy(std::begin(old.cells), std::end(old.cells), words_.begin());
  places_.assign(old.places(), old.places() + old.count);
  lines_.clear();
  for (std::uint32_t k = 0; k < old.count; ++k) lines_.push_back(old.line(k));
  if (changed.empty()) return;
  for (CellLine& line : lines_) {
    const auto found = std::lower_bound(changed.begin(), changed.end(), line.number,
                                        [](const CellPoint& one, int wanted) { return one.number() < wanted; });
    if (found != changed.end() && found->number() == line.number) line = found->line;
  }
}

CellTablePointer CellBuilder::grow(const CellTable& old, const Point2& corner, PointView<2> all,
                                   std::span<const CellPoint> added, std::span<const CellPoint> changed) {
  continue_table(old, changed);
  std::size_t used = 0;
  for (const std::uint32_t word : words_)
    used += CellTable::count_of(word) == CellTable::no_answer ? 0 : CellTable::count_of(word);
  levels_[0].assign(added.begin(), added.end());
  const Square tile{-margin, -margin, grid_.tile + 2.0 * margin};
  split(0, tile, 0, 0, tile_cells, [&](std::size_t cell, Points& near, const Square& square) {
    const std::uint32_t word = words_[cell];
    const std::uint32_t count = CellTable::count_of(word);
    if (count == CellTable::no_answer) return;
    if (const std::uint32_t above = CellTable::above_of(word); above < CellTable::farthest) {
      const double bound = above * distance_unit_ * (above * distance_unit_) + slack;
      std::erase_if(near, [&](const CellPoint& point) { return square.to(point) > bound; });
    }
    if (near.empty()) return;
    const std::uint32_t first = CellTable::first_of(word);
    for (std::uint32_t j = first; j < first + count; ++j) {
      const Point2 place = all[static_cast<std::size_t>(lines_[j].number)] - corner;
      near.push_back({place.x(), place.y(), lines_[j]});
    }
    thin_out(near, square);
    if (near.size() > long_list) cut_down(near, square);
    put(cell, near, square);
    used += near.size() - count;
  });
  constexpr std::size_t little = 1024;  // candidates that a table may waste in any case
  if (places_.size() > 2 * used + little) return nullptr;
  return finish_table();
}

CellPlace CellBuilder::in_units(const CellPoint& point) const noexcept {
  const auto whole = [&](double coordinate) {
    const double shifted = (coordinate - 0.5 * grid_.tile) * units_per_metre_ + 32768.5;  // above zero: cut is floor
    return static_cast<std::int16_t>(static_cast<std::int32_t>(shifted) - 32768);
  };
  return {whole(point.x), whole(point.y)};
}

void CellBuilder::put(std::size_t cell, std::span<const CellPoint> points, const Square& square) {
  if (points.empty()) return;
  double above = 1e300;
  double below = 1e300;
  for (const CellPoint& point : points) {
    above = std::min(above, square.across(point));
    below = std::min(below, square.to(point));
  }
  const bool fits = points.size() < CellTable::no_answer && places_.size() + points.size() < CellTable::most_candidates;
  const auto count = fits ? static_cast<std::uint32_t>(points.size()) : CellTable::no_answer;
  const auto first = fits ? static_cast<std::uint32_t>(places_.size()) : 0U;
  words_[cell] = CellTable::word(count, first, unit_above(above), unit_below(below));
  if (!fits) return;
  for (const CellPoint& point : points) {
    places_.push_back(in_units(point));
    lines_.push_back(point.line);
  }
}

}  // namespace slamicp
