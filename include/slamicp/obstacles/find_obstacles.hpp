// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <slamicp/localization/fix.hpp>
#include <slamicp/obstacles/oriented_box.hpp>
#include <slamicp/obstacles/ray_class.hpp>
#include <slamicp/obstacles/shape.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// Something that stands where the map has nothing.
struct Obstacle {
  OrientedBox box;          ///< around what was seen of it, in the map's frame
  double distance = 0.0;    ///< from the laser to its nearest seen point [m]
  std::vector<int> points;  ///< its points, as indices into the Fix's scan (or into the cloud it was found in)
  RayClass ray_class = RayClass::unknown;  ///< of most of its rays
  Shape shape;                             ///< what it looks like, by its points
  Point2 nearest = Point2::Zero();         ///< its nearest seen point, in the map's frame [m]
  /// Nothing stood before its first point (in beam order), its last one: the thing ends there. Else it may go on.
  bool first_end_seen = false;
  bool last_end_seen = false;

  /// "0.42 m x 0.18 m at 3.10 m, 0.55 m, 41 points"
  std::string brief() const;
};

struct ObstacleOptions {
  /// Fewer points make no obstacle: noise comes alone. At least 1.
  int min_points = 3;
  /// Range noise, 1 sigma [m]: neighbours along the scan this unsteady still belong together. At least 0.
  double range_noise = 0.01;
  /// The flattest incidence at which a surface still holds together [deg]. Smaller joins more. In (0, 90).
  double min_incidence_deg = 10.0;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// Groups a fix's outliers into obstacles, nearest first.
///
/// Outliers that follow each other along the scan belong together while their gap is no wider than a surface seen
/// at min_incidence would leave (the adaptive breakpoint of Borges, Aldon 2004). O(outliers). Throws Error with
/// options.problem().
/// @param scan  the one that the fix is of; of several that were joined the first, all being of its kind
std::vector<Obstacle> find_obstacles(const Fix& fix, const LaserScan& scan, const ObstacleOptions& options = {});

/// The same, scan after scan: it keeps its memory.
class ObstacleFinder {
 public:
  /// Throws Error with options.problem().
  explicit ObstacleFinder(const ObstacleOptions& options = {});

  /// Room for so many obstacles at once, of so many points each: up to these, find() allocates nothing.
  void reserve(std::size_t obstacles, std::size_t points);
  /// Good until the next call.
  std::span<const Obstacle> find(const Fix& fix, const LaserScan& scan);

 private:
  void add(const Fix& fix, const Point2& laser, std::span<const int> points);

  ObstacleOptions options_;
  std::vector<Obstacle> obstacles_;  // the first found_ of them; the others are kept for their memory
  std::size_t found_ = 0;
  PointCloud2 in_map_;
  BoxFinder boxes_;
};

}  // namespace slamicp
