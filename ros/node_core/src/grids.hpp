// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp_node/messages.hpp>

#include <slamicp/map/occupancy_grid.hpp>

namespace slamicp::node {

/// As map_server reads images: 65 per cent occupied and above is a wall, up to 19 is free. Throws Error for a grid that
/// cannot be.
OccupancyGrid to_occupancy(const Grid& grid);

/// 100 occupied, 0 free, -1 unknown, as map_server publishes.
void to_message(const OccupancyGrid& grid, Grid& message);

}  // namespace slamicp::node
