// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/geometry/pose.hpp>

namespace slamicp {

enum class CellState : std::uint8_t { unknown, free, occupied };

/// A cell by its column (along the grid's x) and row (along its y), counted from 0 at the origin.
struct Cell {
  int column = 0;
  int row = 0;

  bool operator==(const Cell&) const = default;
};

/// A map as squares that are occupied, free or unknown, as map_server, nav2 and AMCL of ROS have it.
struct OccupancyGrid {
  int width = 0;             ///< cells in a row
  int height = 0;            ///< rows
  double resolution = 0.05;  ///< the side of a cell [m]
  /// The outer corner of cell (0, 0), from which columns go along x and rows along y: the `origin` of ROS.
  Pose2 T_map_grid;
  std::vector<CellState> cells;  ///< row by row from the lowest, as in nav_msgs/OccupancyGrid
  /// That a cell is occupied, 0 .. 1, in the order of `cells`, NaN where nothing is known; empty where only the states
  /// are known.
  std::vector<float> probability;

  bool contains(const Cell& cell) const noexcept {
    return cell.column >= 0 && cell.row >= 0 && cell.column < width && cell.row < height;
  }
  std::size_t index(const Cell& cell) const noexcept {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(cell.column);
  }
  /// Unknown outside.
  CellState at(const Cell& cell) const noexcept { return contains(cell) ? cells[index(cell)] : CellState::unknown; }

  /// The middle of a cell in the map's frame [m].
  Point2 centre(const Cell& cell) const noexcept {
    return T_map_grid * Point2((cell.column + 0.5) * resolution, (cell.row + 0.5) * resolution);
  }
  /// The cell around a point of the map's frame; nothing outside the grid.
  std::optional<Cell> cell_at(const Point2& point) const noexcept;

  /// The first rule broken, in words; empty if none is.
  std::string problem() const;
};

/// How many cells are what.
struct CellCounts {
  std::size_t occupied = 0;
  std::size_t free = 0;
  std::size_t unknown = 0;
};
CellCounts count_cells(const OccupancyGrid& grid) noexcept;

/// The largest grid that we make or read: 10 km x 10 km of 1 m cells, 500 m x 500 m of 5 cm cells.
inline constexpr std::size_t most_grid_cells = 100'000'000;

/// How points become cells.
struct GridOptions {
  /// The side of a cell [m], above 0. 0.05 is what ROS's tools are used to; smaller keeps more of a good lidar's
  /// accuracy and takes more memory.
  double resolution = 0.05;
  /// Cells beyond the outermost points, unknown ones [m], at least 0.
  double padding = 0.5;
  /// Where a corner between four cells lies, and where the rows point to: T_map_grid. Default: the map's own frame.
  /// Give another grid's to get the same cells again.
  Pose2 origin = {};

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// The points as a grid: occupied where there are any, unknown elsewhere; what is free only scans can tell, see
/// GridBuilder. Points that are not finite are left out. Throws Error with options.problem(), where no point is finite,
/// or where the grid would have more than `most_grid_cells`. O(points + cells).
OccupancyGrid to_occupancy_grid(PointView<2> points, const GridOptions& options = {});

/// The centre of each occupied cell, in the map's frame [m], in the order of the cells. O(cells).
PointCloud2 cell_centres(const OccupancyGrid& grid);

/// Points on the walls as a laser sees them, in the map's frame [m]: the centre of each occupied cell that shares a
/// side with a free one. Where the wall is two cells thick and seen from one side only, noise has spread it, and the
/// point lies midway between them. Cells inside a thicker wall, which no ray reaches, are left out. In a grid without
/// free cells, unknown ones count as free. In the order of the cells, O(cells).
///
/// Why not the side that faces the free cell: a grid is made of laser hits, and a cell is occupied because hits lie in
/// it. On the map of a real building (3 cm cells) the hits of another drive lie 2 mm from these points along the
/// normal, and 17 mm behind the sides. On grids of a known room (5 cm cells, 1 cm noise) the points lie 1 mm from the
/// true walls on average, 10 mm rms; without the second rule 4 mm and 15 mm, the sides 28 mm.
PointCloud2 wall_points(const OccupancyGrid& grid);

/// What a laser's rays go through in a grid: free cells; unknown ones where there are no free ones. O(cells).
CellState air_of(const OccupancyGrid& grid) noexcept;

/// A cell that rays reach, and the point on the wall in it, as wall_points has it.
struct WallCell {
  Cell cell;
  Point2 point;  ///< in the map's frame [m]
};
std::vector<WallCell> wall_cells(const OccupancyGrid& grid);

}  // namespace slamicp
