// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <slamicp/error.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/occupancy_map_file.hpp>
#include <slamicp/io/output_file.hpp>

#include "io/cloud_formats.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

[[noreturn]] void fail_unknown_ending(const std::filesystem::path& path) {
  throw Error("ending " + text::quoted(text::ending_of(path)) + " is of no cloud that slamicp knows",
              text::name_of(path), "name it .csv, .xyz, .txt, .pcd, .ply, or .yaml (map_server)");
}

bool is_text_ending(const std::string& ending) { return ending == ".csv" || ending == ".xyz" || ending == ".txt"; }

bool is_map_ending(const std::string& ending) { return ending == ".yaml" || ending == ".yml"; }

RawCloud load_walls(const std::filesystem::path& path) {
  OccupancyMap map = load_occupancy_map(path);
  RawCloud raw;
  for (const Point2& point : wall_points(map.grid)) raw.points.emplace_back(point.x(), point.y(), 0.0);
  raw.format = "map_server, " + map.format;
  raw.warnings = std::move(map.warnings);
  return raw;
}

RawCloud load_raw(const std::filesystem::path& path) {
  const std::string ending = text::ending_of(path);
  if (is_map_ending(ending) || ending == ".pgm") return load_walls(path);
  const bool is_text = is_text_ending(ending);
  if (!is_text && ending != ".pcd" && ending != ".ply") fail_unknown_ending(path);
  const std::string content = text::read_file(path);
  const std::string name = text::name_of(path);
  RawCloud raw = is_text            ? parse_xyz(content, name)
                 : ending == ".pcd" ? parse_pcd(content, name)
                                    : parse_ply(content, name);
  if (raw.not_finite > 0)
    raw.warnings.push_back(text::count_of(raw.not_finite, "point") + " with NaN or infinite coordinates: left out");
  return raw;
}

bool is_flat(const RawCloud& raw) {
  return !raw.has_z || std::all_of(raw.points.begin(), raw.points.end(),
                                   [&](const Point3& point) { return point.z() == raw.points.front().z(); });
}

PointCloud2 without_z(const PointCloud3& points) {
  PointCloud2 flat;
  flat.reserve(points.size());
  for (const Point3& point : points) flat.emplace_back(point.x(), point.y());
  return flat;
}

void save(const std::filesystem::path& path, const PointCloud3& points, int dimension, CloudEncoding encoding) {
  const std::string ending = text::ending_of(path);
  if (is_text_ending(ending))
    write_file(path, xyz_text(points, dimension, ending == ".csv" ? ',' : ' '));
  else if (ending == ".pcd")
    write_file(path, pcd_bytes(points, encoding));
  else if (ending == ".ply")
    write_file(path, ply_bytes(points, encoding));
  else
    fail_unknown_ending(path);
}

}  // namespace

Cloud load_cloud(const std::filesystem::path& path) {
  RawCloud raw = load_raw(path);
  Cloud cloud;
  cloud.name = text::name_of(path);
  cloud.format = std::move(raw.format);
  cloud.warnings = std::move(raw.warnings);
  if (!is_flat(raw)) {
    cloud.points = std::move(raw.points);
    return cloud;
  }
  if (!raw.points.empty() && raw.points.front().z() != 0.0)
    cloud.warnings.push_back("z is the same in every point: taken as 2D");
  cloud.points = without_z(raw.points);
  return cloud;
}

PointCloud2 load_cloud2(const std::filesystem::path& path) {
  const RawCloud raw = load_raw(path);
  if (!is_flat(raw))
    throw Error("is a 3D cloud, a 2D one is needed", text::name_of(path), "cut a slice of it, and leave z out");
  return without_z(raw.points);
}

PointCloud3 load_cloud3(const std::filesystem::path& path) { return load_raw(path).points; }

void save_cloud(const std::filesystem::path& path, const PointCloud2& points, CloudEncoding encoding) {
  if (is_map_ending(text::ending_of(path))) return save_occupancy_map(path, to_occupancy_grid(points));
  PointCloud3 in_space;
  in_space.reserve(points.size());
  for (const Point2& point : points) in_space.emplace_back(point.x(), point.y(), 0.0);
  save(path, in_space, 2, encoding);
}

void save_cloud(const std::filesystem::path& path, const PointCloud3& points, CloudEncoding encoding) {
  if (is_map_ending(text::ending_of(path)))
    throw Error("a 3D cloud does not fit a map_server map", text::name_of(path), "cut a slice of it, and leave z out");
  save(path, points, 3, encoding);
}

}  // namespace slamicp
