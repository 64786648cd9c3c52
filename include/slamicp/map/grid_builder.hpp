// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <slamicp/map/occupancy_grid.hpp>
#include <slamicp/scan/laser_scan.hpp>
#include <slamicp/scan/scan_points.hpp>

namespace slamicp {

struct GridBuilderOptions {
  GridOptions grid = {};
  RangeFilter ranges = {};  ///< readings to leave out
  /// A cell is occupied where at least this share of the rays that came into it ended there, else free, (0, 0.5].
  /// Smaller: walls grow thick by noise, and who walked by stays; larger: walls that are seen at a glancing angle, and
  /// thin posts, get lost.
  double occupied_share = 0.25;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// Makes an occupancy grid of scans whose poses are known: what rays passed is free, where they end is occupied, what
/// no ray reached is unknown. Counts for each cell the rays that ended in it and those that passed (the counting model,
/// Haehnel 2004, "Mapping with Mobile Robots").
///
/// Two rules keep walls where they are. A ray does not pass a cell in which another one of its scan ended: a wall seen
/// at a glancing angle stays whole (hits before misses: Hess et al. 2016, "Real-time loop closure in 2D lidar SLAM",
/// section IV). And of two cells side by side, one with less than `occupied_share` of what ended in both is no wall:
/// noise throws hits behind the wall as it does before it, but there no ray ever passes.
///
/// The grid grows as scans come; their order does not matter.
class GridBuilder {
 public:
  /// Throws Error with options.problem().
  explicit GridBuilder(const GridBuilderOptions& options = {});
  ~GridBuilder();
  GridBuilder(GridBuilder&&) noexcept;
  GridBuilder& operator=(GridBuilder&&) noexcept;

  /// Counts the returns of a scan, as if measured all at once; a reading that is no return says nothing. Throws Error
  /// where the pose is not finite, or where the grid would have more than `most_grid_cells`. O(cells that its rays
  /// pass).
  void add(const LaserScan& scan, const Pose2& T_map_robot);

  /// The same for points that are known already, as a Fix has them: of several lasers, of a robot that moved meanwhile.
  /// @param laser_in_robot  where their rays start [m]
  void add(PointView<2> points_in_robot, const Point2& laser_in_robot, const Pose2& T_map_robot);

  /// The grid so far, with probabilities. Throws Error before the first return. O(cells).
  OccupancyGrid grid() const;

 private:
  class Tallies;

  GridBuilderOptions options_;
  std::unique_ptr<Tallies> tallies_;
  ScanPoints points_;
  PointCloud2 ends_;  // of the rays [cells]
};

}  // namespace slamicp
