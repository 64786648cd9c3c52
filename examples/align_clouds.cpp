// SPDX-License-Identifier: Apache-2.0
// The paper's call, eq. (10): two clouds in, a pose and everything that falls out of the match.
#include <cstdio>
#include <numbers>

#include <slamicp/registration/icp.hpp>

namespace {

/// The walls of a room of 6 m x 4 m, a point every centimetre.
slamicp::PointCloud2 room() {
  slamicp::PointCloud2 walls;
  for (int k = 0; k < 600; ++k) walls.insert(walls.end(), {{0.01 * k, 0.0}, {0.01 * k, 4.0}});
  for (int k = 0; k < 400; ++k) walls.insert(walls.end(), {{0.0, 0.01 * k}, {6.0, 0.01 * k}});
  return walls;
}

}  // namespace

int main() {
  const slamicp::PointCloud2 map = room();

  // What a robot at (2.0, 1.5), turned by 30 degrees, sees of it; and a post that the map does not know.
  const slamicp::Pose2 truth{2.0, 1.5, std::numbers::pi / 6.0};
  slamicp::PointCloud2 scan;
  for (std::size_t k = 0; k < map.size(); k += 3) scan.push_back(truth.inverse() * map[k]);
  for (int k = 0; k < 12; ++k) scan.push_back(truth.inverse() * slamicp::Point2(3.0 + 0.01 * k, 1.0));

  const slamicp::Pose2 guess{1.9, 1.6, 0.45};
  const slamicp::IcpResult2 result = slamicp::align(scan, map, guess, {.max_correspondence_distance = 0.3});

  std::printf("%s\n", result.brief().c_str());
  std::printf("the map grows from %zu to %zu points\n", map.size(), result.updated_map.size());
  const slamicp::PoseDistance error = distance(result.pose, truth);
  return error.translation < 1e-3 && error.rotation < 1e-3 && result.outlier_indices.size() == 12 ? 0 : 1;
}
