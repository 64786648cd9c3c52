// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// A scan as points: the paper's T, eq. (2). Points stand in beam order.
struct ScanPoints {
  PointCloud2 in_robot;    ///< each return in the robot's frame [m]
  std::vector<int> beams;  ///< beam number of each point, counted from 0
};

/// Which ranges to use, on top of the limits that the scan itself names.
struct RangeFilter {
  double min_range = 0.0;  ///< drop shorter readings [m]; raise it where the robot sees itself
  double max_range = 1e9;  ///< drop readings at or beyond [m]; lower it where far readings are poor
};

/// Turns the scan's returns into points in the robot's frame. O(beams); allocates only where `points` must grow.
void to_points(const LaserScan& scan, const RangeFilter& filter, ScanPoints& points);

ScanPoints to_points(const LaserScan& scan, const RangeFilter& filter = {});

}  // namespace slamicp
