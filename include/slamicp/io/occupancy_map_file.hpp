// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/map/occupancy_grid.hpp>

namespace slamicp {

/// What the greys of a map's image mean, p being the probability that a cell is occupied: (white - grey) / white, or
/// grey / white where `negate` is set.
enum class OccupancyMode {
  trinary,  ///< p > occupied_threshold occupied, p < free_threshold free, else unknown; alpha counts as one more
            ///< channel
  scale,    ///< the same with p in between kept as probability; what is not opaque is unknown
  raw,      ///< grey 0 .. 100 of 255 is the probability in per cent, `negate` or not; above 100 unknown
};

/// What the yaml of a map_server map says.
struct OccupancyMapHeader {
  std::filesystem::path image;       ///< as it stands there, relative to the yaml's folder
  double resolution = 0.05;          ///< the side of a cell [m]
  Pose2 T_map_grid;                  ///< `origin`: the lower left corner of the image
  bool negate = false;               ///< white is occupied
  double occupied_threshold = 0.65;  ///< `occupied_thresh`
  double free_threshold = 0.196;     ///< `free_thresh`
  OccupancyMode mode = OccupancyMode::trinary;
};

/// Reads the yaml of a map from memory. Throws Error with file and key for one that is missing or absurd.
OccupancyMapHeader parse_occupancy_yaml(std::string_view text, const std::string& name);

/// A map as map_server, nav2 and AMCL of ROS have it: a yaml and the image that it names.
struct OccupancyMap {
  std::string name;  ///< the yaml
  OccupancyMapHeader header;
  std::string format;  ///< of the image: "PGM P5", "PNG RGB, 8 bit", ...
  OccupancyGrid grid;
  std::vector<std::string> warnings;  ///< problems found that do not stop us, in words
};

/// Reads the yaml and its image: PGM (P2, P5; 8 and 16 bit) or PNG (any; colours count as their mean). What is
/// occupied, free or unknown is as ROS 1's map_server and nav2's say, see OccupancyMode. Throws Error for anything
/// missing, malformed or cut; a build without libpng reads no PNG.
OccupancyMap load_occupancy_map(const std::filesystem::path& path);

/// Writes `NAME.yaml` and beside it `NAME.pgm`, occupied black, free 254, unknown 205, with thresholds under which both
/// ROS 1 and nav2 read the same back (nav2's own 0.25 takes 205 for free). The image goes first, so that a yaml never
/// names what is not there. Throws Error; an unusable grid with grid.problem().
void save_occupancy_map(const std::filesystem::path& path, const OccupancyGrid& grid);

}  // namespace slamicp
