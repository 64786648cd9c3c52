// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/map/point_map.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// A recorded scan and where a Mapper put it.
struct PlacedRecord {
  LaserScan scan;
  PointCloud2 in_robot;  ///< its points, de-skewed
  Pose2 pose;            ///< T_map_robot
};

/// Maps a whole log: the frame that all parts of it have in common.
std::vector<PlacedRecord> place_scans(std::span<const LaserScan> log);

/// A map from scans whose poses are given, by outliers only as a Mapper makes it; then each point moves to the mean of
/// what the scans saw of it, and those seen once only are left out.
/// @param resolution  so far from the map a point is new, and so near it speaks of its nearest map point [m]
PointMap2::Pointer map_of(std::span<const PlacedRecord* const> scans, double resolution = 0.05);

/// A log taken apart: two maps and a run that have no scan in common, all in the frame of place_scans(). Of each four
/// scans the first is for the one map, the third for the other, those between are the run.
struct HeldOutLog {
  PointMap2::Pointer map, other_map;
  std::vector<const PlacedRecord*> run;
};
/// The records must outlive it. Throws Error where there are too few for a map.
HeldOutLog take_apart(std::span<const PlacedRecord> log);

/// Every second beam of a scan, from the first or the second on.
LaserScan half_of_beams(const LaserScan& scan, std::size_t first);

/// Two estimates of one pose that have no reading in common, and what they told of themselves.
struct IndependentPair {
  Pose2::Tangent difference;  ///< as seen from the robot
  Matrix<3, 3> covariance;    ///< of the difference: both estimates' together
  bool usable = false;        ///< both matched
  bool blind = false;         ///< one of them does not hold some direction

  /// 3 on average where the covariances are right.
  double nees() const noexcept;
};

struct HeldOutPairs {
  std::vector<IndependentPair> matches;  ///< single matches: no reading in common, and nothing else
  std::vector<IndependentPair> fixes;    ///< of localizers, over time
  int lost_tracks = 0;                   ///< times a localizer was half a metre off the map run and put back there
};

/// Runs a localizer through each map, one with the even beams of each scan, one with the odd ones, and compares them
/// where the robot has moved on by 0.1 m or 0.1 rad. Odometry, where there is any, is common to both.
HeldOutPairs compare(const HeldOutLog& log);

}  // namespace slamicp
