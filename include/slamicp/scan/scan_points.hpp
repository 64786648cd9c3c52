// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// A scan as points: the paper's T, eq. (2). Points stand in beam order, scan after scan where several were joined.
struct ScanPoints {
  PointCloud2 in_robot;    ///< each return in the robot's frame, as it stood at the (first) scan's stamp [m]
  std::vector<int> beams;  ///< beam number of each point, counted from 0
  std::vector<int> scans;  ///< which of the joined scans each point is of, counted from 0; empty where there is one
};

/// Which ranges to use, on top of the limits that the scan itself names.
struct RangeFilter {
  double min_range = 0.0;  ///< drop shorter readings [m]; raise it where the robot sees itself
  double max_range = 1e9;  ///< drop readings at or beyond [m]; lower it where far readings are poor
};

/// How the robot moves while a laser sweeps, as if with constant velocity.
struct SweepMotion {
  Pose2 T_start_first = {};  ///< where it is at the first beam, as seen from where the points are wanted
  Pose2 T_first_last = {};   ///< how far it gets from the first beam to the last
};

/// Turns scans into points. It keeps the directions of a laser's beams from scan to scan: give each laser its own.
class ScanProjector {
 public:
  /// Adds the scan's returns to `points`, each from where the robot was when its beam was measured (de-skewing).
  /// O(beams); allocates only where `points` must grow, and for a scan whose beams point elsewhere than the last one's.
  void append(const LaserScan& scan, const RangeFilter& filter, const SweepMotion& motion, ScanPoints& points);

 private:
  void aim(const LaserScan& scan);

  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;
  std::vector<Point2> directions_;  // of the beams, in the laser's frame
};

/// Turns the scan's returns into points in the robot's frame, as if measured all at once. O(beams).
void to_points(const LaserScan& scan, const RangeFilter& filter, ScanPoints& points);

ScanPoints to_points(const LaserScan& scan, const RangeFilter& filter = {});

}  // namespace slamicp
