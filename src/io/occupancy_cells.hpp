// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <slamicp/io/occupancy_map_file.hpp>

#include "io/occupancy_image.hpp"

namespace slamicp {

/// What the greys of an image mean, as ROS 1's map_server and nav2's take them (wiki.ros.org/map_server, "Value
/// Interpretation"). Adds to `warnings` what the user may not have meant.
OccupancyGrid cells_of(const OccupancyImage& image, const OccupancyMapHeader& header,
                       std::vector<std::string>& warnings);

}  // namespace slamicp
