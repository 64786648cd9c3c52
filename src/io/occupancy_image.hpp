// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/map/occupancy_grid.hpp>

namespace slamicp {

/// The picture of a map as its file holds it, before anybody says what its greys mean.
struct OccupancyImage {
  int width = 0;
  int height = 0;
  std::uint32_t white = 255;          ///< the level of full brightness: the sum of what the channels can be at most
  std::vector<std::uint32_t> levels;  ///< sums of the colour channels, row by row from the top, 0 is black
  std::uint32_t opaque = 0;           ///< the largest alpha; 0 where the image has none
  std::vector<std::uint16_t> alphas;  ///< empty where the image has none
  std::string format;                 ///< "PGM P5", "PNG RGB, 8 bit"
  std::vector<std::string> warnings;  ///< problems found that do not stop us, in words
};

/// Each reads one format from memory; `name` is the file's, for messages. Throws Error.
OccupancyImage parse_pgm(std::string_view bytes, const std::string& name);
OccupancyImage parse_png(std::string_view bytes, const std::string& name);

/// A P5 of occupied 0, free 254, unknown 205: the greys of ROS's map_saver.
std::string pgm_bytes(const OccupancyGrid& grid);

/// Throws Error where an image of this size is none, or larger than we read.
void check_image_size(std::uint64_t width, std::uint64_t height, const std::string& where);

}  // namespace slamicp
