// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// A cloud as its file holds it, 2D or 3D.
struct Cloud {
  std::variant<PointCloud2, PointCloud3> points;  ///< [m]
  std::string name;                               ///< the file
  std::string format;                             ///< "CSV", "PCD ascii", "PLY binary_little_endian", ...
  std::vector<std::string> warnings;              ///< problems found that do not stop us, in words

  int dimension() const noexcept { return points.index() == 0 ? 2 : 3; }
  std::size_t size() const noexcept {
    return points.index() == 0 ? std::get_if<0>(&points)->size() : std::get_if<1>(&points)->size();
  }
};

/// Reads a cloud by its file name's ending:
/// - `.csv`, `.xyz`, `.txt`: x,y or x,y,z a line, comma or blank; a header is allowed and, where it names columns x and
///   y, decides; more columns are ignored with a warning;
/// - `.pcd`: ascii, binary; `.ply`: ascii, binary_little_endian, binary_big_endian; other fields are ignored;
/// - `.yaml`: a map_server map, see load_occupancy_map: its wall_points.
///
/// It is 2D where there is no z or z is the same everywhere. Points that are not finite are left out, with a warning.
/// Throws Error with file and line for anything malformed or cut.
Cloud load_cloud(const std::filesystem::path& path);

/// As `load_cloud`; throws Error if the cloud is 3D.
PointCloud2 load_cloud2(const std::filesystem::path& path);

/// As `load_cloud`; a cloud without z gets z = 0.
PointCloud3 load_cloud3(const std::filesystem::path& path);

/// How numbers stand in a `.pcd` or `.ply` file.
enum class CloudEncoding {
  ascii,   ///< 12 significant digits; read by every tool
  binary,  ///< doubles, bit by bit; a third of the size
};

/// Writes by the file name's ending: `.csv` (x,y), `.xyz`, `.txt` (x y), `.pcd`, `.ply`. PCD and PLY get z = 0, which
/// their viewers need. `.csv` and `.xyz` are always text of 12 significant digits: 1e-6 m at 10 km. A 2D cloud also as
/// `.yaml`, a map_server map of 5 cm cells: occupied where there are points, unknown elsewhere. Throws Error.
void save_cloud(const std::filesystem::path& path, const PointCloud2& points,
                CloudEncoding encoding = CloudEncoding::ascii);
void save_cloud(const std::filesystem::path& path, const PointCloud3& points,
                CloudEncoding encoding = CloudEncoding::ascii);

}  // namespace slamicp
