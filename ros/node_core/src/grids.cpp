// SPDX-License-Identifier: Apache-2.0
#include "grids.hpp"

#include <cmath>
#include <limits>

#include <slamicp/error.hpp>
#include <slamicp/geometry/planar.hpp>

#include "frames.hpp"

namespace slamicp::node {

OccupancyGrid to_occupancy(const Grid& message) {
  const std::optional<Pose3> origin = pose_of(message.origin, message.orientation);
  if (!origin) throw Error("the map's origin is no pose", "map", "its quaternion must not be zero");
  if (message.width < 0 || message.height < 0 ||
      message.cells.size() != static_cast<std::size_t>(message.width) * static_cast<std::size_t>(message.height))
    throw Error("the map has another number of cells than its size says", "map");
  OccupancyGrid grid;
  grid.width = message.width;
  grid.height = message.height;
  // Messages hold it as a float: 0.05 came as 0.05000000075, 3 mm too many in 200 m.
  grid.resolution = std::round(message.resolution * 1e6) / 1e6;
  grid.T_map_grid = planar(*origin);
  grid.cells.reserve(message.cells.size());
  for (const std::int8_t cell : message.cells)
    grid.cells.push_back(cell >= 65                ? CellState::occupied
                         : cell >= 0 && cell <= 19 ? CellState::free
                                                   : CellState::unknown);
  if (const std::string problem = grid.problem(); !problem.empty()) throw Error(problem, "map");
  return grid;
}

void to_message(const OccupancyGrid& grid, Grid& message) {
  message.resolution = grid.resolution;
  message.width = grid.width;
  message.height = grid.height;
  message.origin = {grid.T_map_grid.x, grid.T_map_grid.y, 0.0};
  message.orientation = {0.0, 0.0, std::sin(0.5 * grid.T_map_grid.theta), std::cos(0.5 * grid.T_map_grid.theta)};
  message.cells.clear();
  message.cells.reserve(grid.cells.size());
  for (const CellState cell : grid.cells) {
    constexpr std::int8_t occupied = 100, free = 0, unknown = -1;
    message.cells.push_back(cell == CellState::occupied ? occupied : cell == CellState::free ? free : unknown);
  }
}

}  // namespace slamicp::node
