// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace slamicp {

enum class FileKind {
  scan_log,       ///< open_scan_log reads it
  cloud,          ///< load_cloud reads it
  occupancy_map,  ///< load_occupancy_map reads it; so does load_cloud, its walls as points
  world,          ///< load_world reads it
};

/// What a file holds, by its ending; a `.csv` may be either, and its first full line tells: a point has two or three
/// numbers, a scan more; a `.yaml` with the key `world` is a world, any other a map. Throws Error for an unknown
/// ending, or a `.csv` that cannot be read.
FileKind kind_of(const std::filesystem::path& path);

}  // namespace slamicp
