// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <slamicp/localization/fix.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// A few points of what was seen of something, in the map.
struct Footprint {
  static constexpr int most = 5;

  int count = 0;
  std::array<Point2, most> points;
};

/// An obstacle as a tracker measures it.
struct Detection {
  int obstacle = -1;                          // which one
  Point2 middle = Point2::Zero();             // in the map [m]
  Matrix<2, 2> noise = Matrix<2, 2>::Zero();  // of the middle, shape and pose
  double width = 0.0;                         // [m]
  bool is_leg = false;                        // as wide as one, and nothing nearer hides an end of it
  bool is_part = false;                       // of something larger that the map has
  Footprint footprint;
};

inline constexpr double least_leg = 0.05;     // [m]
inline constexpr double widest_leg = 0.25;    // [m]
inline constexpr double widest_person = 0.8;  // [m]

Detection detect(const Fix& fix, const LaserScan& scan, const Obstacle& obstacle, int index) noexcept;

/// How far off a place in the map is, as a fix sees it from its robot: position and heading, times the lever.
Matrix<2, 2> noise_of_fix(const Fix& fix, const Point2& in_map) noexcept;

}  // namespace slamicp
