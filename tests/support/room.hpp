// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <slamicp/scan/laser_scan.hpp>

#include "support/clouds.hpp"

namespace slamicp::test {

/// Straight walls, seen by a laser without noise: enough of a world for the tests of the rooms above `simulation`.
struct Room {
  struct Wall {
    Point2 a;
    Point2 b;
  };
  std::vector<Wall> walls;

  void add_box(const Point2& center, double width, double depth, double heading) {
    const Pose2 pose{center.x(), center.y(), heading};
    const Point2 corners[] = {{width, depth}, {-width, depth}, {-width, -depth}, {width, -depth}};
    for (std::size_t k = 0; k < 4; ++k)
      walls.push_back({pose * Point2(0.5 * corners[k]), pose * Point2(0.5 * corners[(k + 1) % 4])});
  }

  PointCloud2 map(double spacing, double noise = 0.0, Random* random = nullptr) const {
    PointCloud2 points;
    for (const Wall& one : walls) append(points, wall(one.a, one.b, spacing, noise, random));
    return points;
  }

  /// Distance along a ray from the laser; 0 where it meets nothing.
  double range(const Pose2& laser, double angle) const {
    const Point2 ray(std::cos(laser.theta + angle), std::sin(laser.theta + angle));
    double nearest = infinity;
    for (const Wall& one : walls) {
      const Point2 side = one.b - one.a;
      const Point2 offset = one.a - laser.translation();
      const double cross = ray.x() * side.y() - ray.y() * side.x();
      if (std::abs(cross) < 1e-12) continue;
      const double distance = (offset.x() * side.y() - offset.y() * side.x()) / cross;
      const double share = (offset.x() * ray.y() - offset.y() * ray.x()) / cross;
      if (distance > 0.0 && share >= 0.0 && share <= 1.0) nearest = std::min(nearest, distance);
    }
    return std::isfinite(nearest) ? nearest : 0.0;
  }

  LaserScan scan(const Pose2& T_map_robot, double stamp = 0.0, double noise = 0.0, Random* random = nullptr) const {
    LaserScan scan;
    scan.stamp = stamp;
    scan.angle_min = -0.75 * pi;
    scan.angle_increment = 1.5 * pi / 540.0;
    scan.range_max = 30.0;
    for (int i = 0; i <= 540; ++i) {
      const double exact = range(T_map_robot * scan.T_robot_laser, scan.angle_min + i * scan.angle_increment);
      const double off = random != nullptr ? random->normal(noise) : 0.0;
      scan.ranges.push_back(exact > 0.0 ? static_cast<float>(exact + off) : 0.0F);
    }
    return scan;
  }
};

/// 6 m x 4 m, with a pillar and a niche: nothing in it looks alike from two places.
inline Room simple_room() {
  Room room;
  const Point2 corners[] = {{0, 0}, {6, 0}, {6, 1.5}, {6.6, 1.5}, {6.6, 2.3}, {6, 2.3}, {6, 4}, {0, 4}};
  for (std::size_t k = 0; k < 8; ++k) room.walls.push_back({corners[k], corners[(k + 1) % 8]});
  room.add_box({4.2, 3.0}, 0.5, 0.4, 0.3);
  return room;
}

}  // namespace slamicp::test
