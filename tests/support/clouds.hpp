// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <slamicp/geometry/pose.hpp>

#include "support/random.hpp"

namespace slamicp::test {

/// A cloud that is unkind to an index: blobs, walls, lattice points that tie, duplicates, and points that are no
/// numbers; anywhere around `center`.
template <int D>
PointCloud<D> unkind_cloud(Random& random, int size, const Point<D>& center = Point<D>::Zero()) {
  PointCloud<D> cloud;
  while (static_cast<int>(cloud.size()) < size) {
    Point<D> point = random.point<D>(2.0);
    switch (random.integer(0, 9)) {
      case 0:
        point = (2.0 * point).array().round() * 0.1;  // a lattice: many ties
        break;
      case 1:
        if (!cloud.empty()) {
          cloud.push_back(cloud[static_cast<std::size_t>(random.integer(0, static_cast<int>(cloud.size()) - 1))]);
          continue;
        }
        break;
      case 2:
      case 3:
        point[0] = 0.7;  // a wall
        break;
      case 4:
        point *= 0.02;  // a blob
        break;
      case 5:
        if (random.chance(0.2)) point[random.integer(0, D - 1)] = random.chance(0.5) ? nan : infinity;
        break;
      default:
        break;
    }
    cloud.push_back(center + point);
  }
  return cloud;
}

/// Points along the straight wall from a to b, ends included, off by noise across it.
inline PointCloud2 wall(const Point2& a, const Point2& b, double spacing, double noise = 0.0,
                        Random* random = nullptr) {
  const int steps = std::max(1, static_cast<int>(std::lround((b - a).norm() / spacing)));
  const Point2 along = (b - a).normalized();
  const Point2 across(-along.y(), along.x());
  PointCloud2 points;
  for (int k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    points.push_back(a + share * (b - a) + (random != nullptr ? random->normal(noise) : 0.0) * across);
  }
  return points;
}

inline void append(PointCloud2& cloud, const PointCloud2& more) { cloud.insert(cloud.end(), more.begin(), more.end()); }

template <int D>
PointCloud<D> transformed(const Pose<D>& pose, const PointCloud<D>& cloud) {
  PointCloud<D> moved;
  for (const Point<D>& point : cloud) moved.push_back(pose * point);
  return moved;
}

/// Something that holds a pose in every direction, without noise: an L-shaped room in the plane (walls of 4, 3 and
/// 1.5 m), the faces of a cut block in space.
template <int D>
PointCloud<D> sharp_shape();

template <>
inline PointCloud2 sharp_shape<2>() {
  PointCloud2 room;
  const Point2 corners[] = {{0, 0}, {4, 0}, {4, 3}, {2.5, 3}, {2.5, 1.5}, {0, 1.5}};
  for (std::size_t k = 0; k < 6; ++k) {
    append(room, wall(corners[k], corners[(k + 1) % 6], 0.02));
    room.pop_back();  // the next wall begins there
  }
  return transformed(Pose2{-1.5, -0.8, 0.1}, room);
}

template <>
inline PointCloud3 sharp_shape<3>() {
  PointCloud3 block;
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const double u = 0.06 * i;
      const double v = 0.06 * j;
      block.emplace_back(u, v, 0.0);
      block.emplace_back(u, 0.0, 0.8 * v);
      block.emplace_back(0.0, u, v);
    }
  }
  return transformed(Pose3::exp(Pose3::Tangent(-0.5, -0.4, -0.6, 0.2, 0.1, -0.3)), block);
}

}  // namespace slamicp::test
