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

/// Something that stands where the map has nothing, as one scan shows it.
struct Obstacle {
  OrientedBox box;        ///< around what was seen of it, in the map's frame
  double distance = 0.0;  ///< from the laser to its nearest seen point [m]
  /// Its points, as indices into the Fix's scan (or into the cloud it was found in), in beam order; where it stands
  /// across the first beam of a full turn, from the last beams on.
  std::vector<int> points;
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
  /// Of its points so many must be at least the obstacle distance from the map's surface; others may be as near as
  /// three quarters of it (hysteresis). At least 1.
  int min_far_points = 2;
  /// Range noise, 1 sigma [m]: neighbours along the scan this unsteady still belong together. At least 0.
  double range_noise = 0.01;
  /// The flattest incidence at which a surface still holds together [deg]. Smaller joins more. In (0, 90).
  double min_incidence_deg = 10.0;
  /// Whether to work out shapes, which take most of the time; else they stay unknown and empty.
  bool shapes = true;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// Groups what of a fix's scan the map does not have into obstacles, nearest first.
///
/// They are made of the fix's strays, by their distance from the map's surface; of its outliers where strays were not
/// asked for (Outputs::strays). Points that follow each other along the scan belong together while their gap is no
/// wider than a surface seen at min_incidence would leave (the adaptive breakpoint of Borges, Aldon 2004), and while
/// nothing of the map shows between them. What has no outlier must stand before a mapped surface: behind one the map's
/// own error is seen. O(strays). Throws Error with options.problem().
/// @param scan  the one that the fix is of; of several that were joined the first, all being of its kind
std::vector<Obstacle> find_obstacles(const Fix& fix, const LaserScan& scan, const ObstacleOptions& options = {});

/// The same, scan after scan: it keeps its memory.
class ObstacleFinder {
 public:
  /// Throws Error with options.problem().
  explicit ObstacleFinder(const ObstacleOptions& options = {});

  /// Room for so many obstacles at once, of so many points each: up to these, find() allocates nothing.
  /// @param points  of a scan, at most
  void reserve(std::size_t obstacles, std::size_t points);
  /// Good until the next call.
  std::span<const Obstacle> find(const Fix& fix, const LaserScan& scan);

 private:
  struct Look;

  void choose_points(const Fix& fix);
  void add(const Look& look, std::size_t from, std::size_t to);
  RayClass class_of(const Look& look, std::span<const int> points) const;

  ObstacleOptions options_;
  std::vector<int> candidates_;       // points off the map, in beam order
  std::vector<unsigned char> state_;  // of each candidate: how far off the map it is
  std::vector<Obstacle> obstacles_;   // the first found_ of them; the others are kept for their memory
  std::size_t found_ = 0;
  PointCloud2 in_map_;
  BoxFinder boxes_;
  ShapeFinder shapes_;
};

}  // namespace slamicp
