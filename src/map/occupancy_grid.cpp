// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include <slamicp/map/occupancy_grid.hpp>

#include "map/grid_frame.hpp"

namespace slamicp {
namespace {

constexpr std::array<Cell, 4> sides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

template <class Take>
void for_each_occupied(const OccupancyGrid& grid, Take take) {
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column)
      if (grid.at({column, row}) == CellState::occupied) take(Cell{column, row});
}

Cell next(const Cell& cell, const Cell& side, int steps) {
  return {cell.column + steps * side.column, cell.row + steps * side.row};
}

/// How far the wall's surface lies behind the centre of a cell that is seen from this side [cells].
double depth_behind(const OccupancyGrid& grid, const Cell& cell, const Cell& side, CellState air) {
  const bool is_two_thick =
      grid.at(next(cell, side, -1)) == CellState::occupied && grid.at(next(cell, side, -2)) != CellState::occupied;
  return is_two_thick && grid.at(next(cell, side, -2)) != air ? 0.5 : 0.0;
}

/// The wall's surface in a cell; nothing where none of its sides is seen.
std::optional<Point2> surface_in(const OccupancyGrid& grid, const Cell& cell, CellState air) {
  Point2 shift = Point2::Zero();  // of all sides that are seen [cells]
  int seen = 0;
  for (const Cell& side : sides) {
    if (grid.at(next(cell, side, 1)) != air) continue;
    shift -= depth_behind(grid, cell, side, air) * Point2(side.column, side.row);
    ++seen;
  }
  if (seen == 0) return std::nullopt;
  const Point2 in_cells = Point2(cell.column + 0.5, cell.row + 0.5) + shift / seen;
  return grid.T_map_grid * Point2(in_cells * grid.resolution);
}

}  // namespace

std::optional<Cell> OccupancyGrid::cell_at(const Point2& point) const noexcept {
  const Point2 cells_from_origin = (T_map_grid.inverse() * point) / resolution;
  // Compared as they are: NaN, and what no int holds, is outside.
  if (!(cells_from_origin.x() >= 0.0 && cells_from_origin.x() < width && cells_from_origin.y() >= 0.0 &&
        cells_from_origin.y() < height))
    return std::nullopt;
  return Cell{static_cast<int>(cells_from_origin.x()), static_cast<int>(cells_from_origin.y())};
}

std::string OccupancyGrid::problem() const {
  if (width < 1 || height < 1) return "the grid has no cell";
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (count > most_grid_cells) return "the grid has more than " + std::to_string(most_grid_cells) + " cells";
  if (cells.size() != count) return "the grid has not width x height cells";
  if (!probability.empty() && probability.size() != count) return "the grid has not one probability a cell";
  if (!(resolution > 0.0) || !std::isfinite(resolution)) return "the grid's resolution must be above 0 m";
  if (!T_map_grid.is_finite()) return "the grid's origin must be finite";
  return {};
}

CellCounts count_cells(const OccupancyGrid& grid) noexcept {
  CellCounts counts;
  for (const CellState cell : grid.cells) {
    counts.occupied += cell == CellState::occupied;
    counts.free += cell == CellState::free;
    counts.unknown += cell == CellState::unknown;
  }
  return counts;
}

std::string GridOptions::problem() const {
  if (!(resolution > 0.0) || !std::isfinite(resolution)) return "resolution must be above 0 m";
  if (!(padding >= 0.0) || !std::isfinite(padding)) return "padding must be at least 0 m";
  if (!origin.is_finite()) return "origin must be finite";
  return {};
}

void GridFrame::check_size(const Point2& first, const Point2& last) const {
  const Point2 size = last - first + Point2::Ones();
  constexpr auto most = static_cast<double>(most_grid_cells);
  if (!(size.x() <= most && size.y() <= most && size.x() * size.y() <= most))
    throw Error("a grid of more than " + std::to_string(most_grid_cells) + " cells", "GridOptions",
                "give a coarser resolution, or leave out points that lie far away");
}

OccupancyGrid GridFrame::unknown_grid(const Point2& first, const Point2& last) const {
  check_size(first, last);
  const Point2 size = last - first + Point2::Ones();
  OccupancyGrid grid;
  grid.width = static_cast<int>(size.x());
  grid.height = static_cast<int>(size.y());
  grid.resolution = options_.resolution;
  grid.T_map_grid = options_.origin * Pose2{first.x() * options_.resolution, first.y() * options_.resolution, 0.0};
  grid.cells.assign(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), CellState::unknown);
  return grid;
}

OccupancyGrid to_occupancy_grid(PointView<2> points, const GridOptions& options) {
  const GridFrame frame(options);
  Bounds<2> bounds;
  for (const Point2& point : points)
    if (is_finite<2>(point)) bounds.include(frame.in_cells(point));
  if (bounds.empty())
    throw Error("no point to make a grid of", "to_occupancy_grid", "give at least one finite point [m]");
  const Point2 first = frame.first_cell(bounds);
  OccupancyGrid grid = frame.unknown_grid(first, frame.last_cell(bounds));
  for (const Point2& point : points) {
    if (!is_finite<2>(point)) continue;
    const Point2 cell = frame.in_cells(point).array().floor() - first.array();
    grid.cells[grid.index({static_cast<int>(cell.x()), static_cast<int>(cell.y())})] = CellState::occupied;
  }
  return grid;
}

PointCloud2 cell_centres(const OccupancyGrid& grid) {
  PointCloud2 points;
  for_each_occupied(grid, [&](const Cell& cell) { points.push_back(grid.centre(cell)); });
  return points;
}

CellState air_of(const OccupancyGrid& grid) noexcept {
  const bool has_free = std::find(grid.cells.begin(), grid.cells.end(), CellState::free) != grid.cells.end();
  return has_free ? CellState::free : CellState::unknown;
}

std::vector<WallCell> wall_cells(const OccupancyGrid& grid) {
  const CellState air = air_of(grid);
  std::vector<WallCell> walls;
  for_each_occupied(grid, [&](const Cell& cell) {
    if (const std::optional<Point2> point = surface_in(grid, cell, air)) walls.push_back({cell, *point});
  });
  return walls;
}

PointCloud2 wall_points(const OccupancyGrid& grid) {
  PointCloud2 points;
  for (const WallCell& wall : wall_cells(grid)) points.push_back(wall.point);
  return points;
}

}  // namespace slamicp
