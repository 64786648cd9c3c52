// SPDX-License-Identifier: Apache-2.0
#include <slamicp/error.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/map_file.hpp>

namespace slamicp {

PointMap2::Pointer load_map(const std::filesystem::path& path, const SurfaceOptions& surfaces) {
  PointCloud2 points = load_cloud2(path);
  if (points.empty()) throw Error("the map holds no point", path.string(), "make one with 'slamicp map LOG --out MAP'");
  return PointMap2::create(std::move(points), surfaces);
}

void save_map(const std::filesystem::path& path, const PointMap2& map) { save_cloud(path, to_cloud<2>(map.points())); }

}  // namespace slamicp
