// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <slamicp/io/cloud_file.hpp>

namespace slamicp {

/// What every cloud reader gives: points in space, z = 0 where the file has none.
struct RawCloud {
  PointCloud3 points;
  bool has_z = false;
  std::size_t not_finite = 0;  ///< points left out
  std::string format;
  std::vector<std::string> warnings;

  void add(const Point3& point) {
    if (is_finite<3>(point))
      points.push_back(point);
    else
      ++not_finite;
  }
};

/// Each reads one format from memory; `name` is the file's, for messages. Throws Error.
RawCloud parse_xyz(std::string_view text, const std::string& name);
RawCloud parse_pcd(std::string_view bytes, const std::string& name);
RawCloud parse_ply(std::string_view bytes, const std::string& name);

/// Each writes one format. @param dimension  2 leaves z out where the format may
std::string xyz_text(const PointCloud3& points, int dimension, char separator);
std::string pcd_bytes(const PointCloud3& points, CloudEncoding encoding);
std::string ply_bytes(const PointCloud3& points, CloudEncoding encoding);

}  // namespace slamicp
