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
// A grown list longer than this is cut down.
constexpr std::size_t long_list = 12;

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
  const auto whole = [](float normal) { return static_cast<std::int16_t>(std::lround(normal * line_scale)); };
  CellLine stored{whole(line.normal_x), whole(line.normal_y), 0.0F};
  // The offset is of the normal as rounded, so that the line goes through the same place.
  const double nx = stored.normal_x / static_cast<double>(line_scale);
  const double ny = stored.normal_y / static_cast<double>(line_scale);
  const double turn = nx * static_cast<double>(line.normal_x) + ny * static_cast<double>(line.normal_y);
  stored.offset = static_cast<float>(nx * place.x() + ny * place.y() + turn * static_cast<double>(line.offset));
  return {place.x(), place.y(), number, stored};
}

double distance_unit(const TileGrid& grid, double reach) noexcept { return (reach + 3.0 * grid.cell) / 62.0; }

double place_unit(const TileGrid& grid, double reach) noexcept {
  return (0.5 * grid.tile + reach + grid.cell) / 32767.0;
}

double CellBuilder::Square::to(const CellPoint& point) const noexcept {
  const double dx = std::max({x - point.x, point.x - x - side, 0.0});
  const double dy = std::max({y - point.y, point.y - y - side, 0.0});
  return dx * dx + dy * dy;
}

double CellBuilder::Square::across(const CellPoint& point) const noexcept {
  const double dx = std::max(point.x - x, x + side - point.x);
  const double dy = std::max(point.y - y, y + side - point.y);
  return dx * dx + dy * dy;
}

CellBuilder::CellBuilder(const TileGrid& grid, double reach) : grid_(grid), reach_(reach) {}

CellBuilder::Square CellBuilder::square_of(std::size_t cell) const noexcept {
  const auto column = static_cast<double>(cell % tile_cells);
  const auto row = static_cast<double>(cell / tile_cells);
  return {column * grid_.cell - margin, row * grid_.cell - margin, grid_.cell + 2.0 * margin};
}

void CellBuilder::begin_table() noexcept {
  words_.fill(CellTable::word(0, 0, CellTable::farthest, CellTable::farthest));
  places_.clear();
  lines_.clear();
  numbers_.clear();
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
  std::fill(line - CellTable::spare, line, CellLine{0, 0, 0.0F});
  std::copy(numbers_.begin(), numbers_.end(), reinterpret_cast<std::int32_t*>(places + count + CellTable::spare));
  return CellTablePointer(table);
}

std::uint32_t CellBuilder::unit_above(double squared_distance) const noexcept {
  const double units = std::ceil(std::sqrt(squared_distance) / distance_unit(grid_, reach_) + 1e-6);
  return static_cast<std::uint32_t>(std::min(units, static_cast<double>(CellTable::farthest)));
}

std::uint32_t CellBuilder::unit_below(double squared_distance) const noexcept {
  const double units = std::floor(std::sqrt(squared_distance) / distance_unit(grid_, reach_) - 1e-6);
  return static_cast<std::uint32_t>(std::clamp(units, 0.0, static_cast<double>(CellTable::farthest)));
}

CellTablePointer CellBuilder::build(std::span<const CellPoint> points) {
  begin_table();
  levels_[0].assign(points.begin(), points.end());
  const Square all{-margin, -margin, grid_.tile + 2.0 * margin};
  split(0, all, 0, 0, tile_cells);
  return finish_table();
}

void CellBuilder::split(std::size_t level, const Square& square, int column, int row, int cells) {
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
    fill_cell(near, square, static_cast<std::size_t>(row * tile_cells + column));
    return;
  }
  const int half = cells / 2;
  for (int part = 0; part < 4; ++part) {
    const int to_x = column + (part & 1) * half;
    const int to_y = row + (part >> 1) * half;
    const Square quarter{to_x * grid_.cell - margin, to_y * grid_.cell - margin, half * grid_.cell + 2.0 * margin};
    split(level + 1, quarter, to_x, to_y, half);
  }
}

void CellBuilder::fill_cell(Points& points, const Square& square, std::size_t cell) {
  cut_down(points, square);
  put(cell, points, square);
}

/// Leaves the points that are nearest to some place in the square, nearest to its centre first.
void CellBuilder::cut_down(Points& points, const Square& square) {
  if (points.size() < 2) return;
  const double half = 0.5 * square.side;
  const double cx = square.x + half;
  const double cy = square.y + half;
  const auto from_centre = [&](const CellPoint& p) { return (p.x - cx) * (p.x - cx) + (p.y - cy) * (p.y - cy); };
  const auto nearer = [&](const CellPoint& a, const CellPoint& b) {
    const double da = from_centre(a);
    const double db = from_centre(b);
    return da < db || (da == db && a.number < b.number);
  };
  std::iter_swap(points.begin(), std::min_element(points.begin(), points.end(), nearer));
  const CellPoint first = points.front();
  const auto is_out = [&](const CellPoint& p) {
    return is_beaten(p, first, cx, cy, half) || (same_place(p, first) && p.number > first.number);
  };
  points.erase(std::remove_if(points.begin() + 1, points.end(), is_out), points.end());
  if (points.size() < 2) return;
  std::sort(points.begin() + 1, points.end(), nearer);

  survivors_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CellPoint& p = points[i];
    CellClip clip(half);
    for (std::size_t j = 0; j < points.size() && !clip.empty(); ++j) {
      if (j == i) continue;
      const CellPoint& q = points[j];
      if (same_place(p, q)) {
        if (q.number < p.number) break;  // the lower number answers for both
        continue;
      }
      clip.keep_nearer(p.x - cx, p.y - cy, q.x - cx, q.y - cy);
    }
    const bool has_twin = std::any_of(survivors_.begin(), survivors_.end(),
                                      [&](const CellPoint& q) { return same_place(p, q) && q.number < p.number; });
    if (!clip.empty() && !has_twin) survivors_.push_back(p);
  }
  points.assign(survivors_.begin(), survivors_.end());
}

/// Leaves out points that the one nearest to the centre beats all over the square. Quick, and keeps some too many.
void CellBuilder::thin_out(Points& points, const Square& square) {
  if (points.size() < 2) return;
  const double half = 0.5 * square.side;
  const double cx = square.x + half;
  const double cy = square.y + half;
  const auto nearer = [&](const CellPoint& a, const CellPoint& b) {
    const double da = (a.x - cx) * (a.x - cx) + (a.y - cy) * (a.y - cy);
    const double db = (b.x - cx) * (b.x - cx) + (b.y - cy) * (b.y - cy);
    return da < db || (da == db && a.number < b.number);
  };
  std::iter_swap(points.begin(), std::min_element(points.begin(), points.end(), nearer));
  const CellPoint first = points.front();
  const auto is_out = [&](const CellPoint& p) {
    return is_beaten(p, first, cx, cy, half) || (same_place(p, first) && p.number > first.number);
  };
  points.erase(std::remove_if(points.begin() + 1, points.end(), is_out), points.end());
}

/// Notes which added point may be nearest to some place of which cell.
void CellBuilder::find_cells(std::span<const CellPoint> added, const CellTable& old) {
  std::array<double, tile_cells * tile_cells> bound;  // squared: nobody in the cell has its nearest point farther
  const double unit = distance_unit(grid_, reach_);
  for (std::size_t cell = 0; cell < bound.size(); ++cell) {
    const std::uint32_t above = CellTable::above_of(old.cells[cell]);
    const double farthest = above == CellTable::farthest ? reach_ : std::min(reach_, above * unit);
    bound[cell] = farthest * farthest;
  }
  const auto for_each_cell_near = [&](const CellPoint& point, const auto& use) {
    const auto at = [&](double coordinate) {
      return static_cast<int>(std::clamp(std::floor(coordinate * grid_.cells_per_metre), 0.0, 15.0));
    };
    const int right = at(point.x + reach_ + grid_.cell);
    const int top = at(point.y + reach_ + grid_.cell);
    for (int row = at(point.y - reach_ - grid_.cell); row <= top; ++row)
      for (int column = at(point.x - reach_ - grid_.cell); column <= right; ++column)
        use(static_cast<std::size_t>(row * tile_cells + column));
  };
  for (const CellPoint& point : added)
    for_each_cell_near(point,
                       [&](std::size_t cell) { bound[cell] = std::min(bound[cell], square_of(cell).across(point)); });
  meetings_.clear();
  for (std::size_t k = 0; k < added.size(); ++k)
    for_each_cell_near(added[k], [&](std::size_t cell) {
      if (square_of(cell).to(added[k]) <= bound[cell] + slack)
        meetings_.push_back({static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(k)});
    });
  std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) {
    return a.cell < b.cell || (a.cell == b.cell && a.point < b.point);
  });
}

CellTablePointer CellBuilder::grow(const CellTable& old, const Point2& corner, PointView<2> all,
                                   std::span<const CellPoint> added, std::span<const CellPoint> changed) {
  begin_table();
  find_cells(added, old);
  const auto as_it_is_now = [&](std::uint32_t candidate) {
    const int number = old.numbers()[candidate];
    const auto found = std::lower_bound(changed.begin(), changed.end(), number,
                                        [](const CellPoint& one, int wanted) { return one.number < wanted; });
    if (found != changed.end() && found->number == number) return *found;
    const Point2 place = all[static_cast<std::size_t>(number)] - corner;
    return CellPoint{place.x(), place.y(), number, old.line(candidate)};
  };
  Points& list = levels_[0];
  auto meeting = meetings_.begin();
  for (std::size_t cell = 0; cell < words_.size(); ++cell) {
    const std::uint32_t word = old.cells[cell];
    const std::uint32_t begin = CellTable::first_of(word);
    const std::uint32_t count = CellTable::count_of(word);
    if (count == CellTable::no_answer) {
      while (meeting != meetings_.end() && meeting->cell == cell) ++meeting;
      words_[cell] = CellTable::word(count, 0, CellTable::above_of(word), 0);
      continue;
    }
    list.clear();
    for (std::uint32_t j = begin; j < begin + count; ++j) list.push_back(as_it_is_now(j));
    const bool is_new = meeting != meetings_.end() && meeting->cell == cell;
    for (; meeting != meetings_.end() && meeting->cell == cell; ++meeting) list.push_back(added[meeting->point]);
    const Square square = square_of(cell);
    if (is_new) thin_out(list, square);
    if (is_new && list.size() > long_list) cut_down(list, square);
    put(cell, list, square);
  }
  return finish_table();
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
  const auto begin = fits ? static_cast<std::uint32_t>(places_.size()) : 0U;
  words_[cell] = CellTable::word(count, begin, unit_above(above), unit_below(below));
  if (!fits) return;
  const double unit = place_unit(grid_, reach_);
  const auto in_units = [&](double coordinate) {
    return static_cast<std::int16_t>(std::lround((coordinate - 0.5 * grid_.tile) / unit));
  };
  for (const CellPoint& point : points) {
    places_.push_back({in_units(point.x), in_units(point.y)});
    lines_.push_back(point.line);
    numbers_.push_back(point.number);
  }
}

}  // namespace slamicp
