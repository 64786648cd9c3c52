// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/obstacles/find_obstacles.hpp>

namespace slamicp {

struct ReconstructionOptions {
  double gap = 0.15;            ///< points closer than this belong together [m]; above 0
  int min_points = 20;          ///< smaller groups are dropped: noise does not repeat itself at one place. At least 1
  double filter_radius = 0.03;  ///< a point needs filter_neighbours others this near [m]; above 0
  int filter_neighbours = 3;    ///< 0: no filter
  /// Share of the points left outside each side of the box: their noise would make it larger than the thing. In [0,
  /// 0.2].
  double trim = 0.01;

  /// Of the points, by ranges and poses, 1 sigma [m]; above 0. For the shapes.
  double noise = 0.012;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// The obstacles that a run's outliers add up to (the paper, section 4.2, Figure 16), largest first: outliers of many
/// scans, in the map's frame [m], filtered and grouped by nearness. `points` of each count `outliers`; `distance` is 0.
/// For things that stand still. O(n log n). Throws Error with options.problem().
std::vector<Obstacle> reconstruct_obstacles(const PointCloud2& outliers, const ReconstructionOptions& options = {});

/// What a run has seen of things that the map does not have, and from where.
struct SeenThings {
  PointCloud2 points;  ///< in the map [m]
  PointCloud2 lasers;  ///< where the ray of each began, in the map [m]

  /// Adds what stands before mapped surfaces: the points of obstacles whose class is `obstacle`.
  void add(const Fix& fix, const LaserScan& scan, std::span<const Obstacle> obstacles);
};

/// The same of these, with the shapes that they show from everywhere together.
std::vector<Obstacle> reconstruct_shapes(const SeenThings& seen, const ReconstructionOptions& options = {});

}  // namespace slamicp
