// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <slamicp/map/point_map.hpp>

namespace slamicp {

/// A 2D map, ready to localize in: the points of a cloud file, or the walls of a map_server map (`.yaml`), see
/// load_cloud2; their lines and their index.
/// Throws Error where the file cannot be read, is 3D, or holds no point.
PointMap2::Pointer load_map(const std::filesystem::path& path, const SurfaceOptions& surfaces = {});

/// Writes the map's points as a cloud, by the file name's ending, see save_cloud. A `.yaml` made so knows nothing of
/// what is free: see GridBuilder and save_occupancy_map for a map that others can plan in.
void save_map(const std::filesystem::path& path, const PointMap2& map);

}  // namespace slamicp
