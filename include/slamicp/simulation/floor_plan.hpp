// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/map/occupancy_grid.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// The world with the walls of a grid: the outlines of what is occupied, where rays reach it (see air_of), as straight
/// walls. A cell with no neighbour is a pillar as wide as a cell.
///
/// The walls go through the grid's wall_points, so who localizes in the grid finds the walls where the lidar sees them:
/// a wall one cell thick has no thickness, as nobody knows on which side of the cell's middle the real one ended. They
/// leave these points by at most 0.8 cells, the steps of a wall that is not along the grid. Behind the edge of what is
/// known there is nothing. O(cells), and O(n^2) at worst for an outline of n cells.
///
/// Throws Error with grid.problem(), and for a grid where nothing is occupied.
World with_floor_plan(World world, const OccupancyGrid& grid);

}  // namespace slamicp
