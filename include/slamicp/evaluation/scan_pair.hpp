// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/registration/icp_result.hpp>

namespace slamicp {

/// Two scans, where the second was really taken as seen from the first, and where the wheels say it was.
struct ScanPair {
  PointCloud2 M;  ///< the first, in its robot's frame
  PointCloud2 T;  ///< the second, in its robot's frame
  Pose2 truth;    ///< T_M_T
  Pose2 guess;    ///< truth, off by 5 cm, 5 cm, 2 deg
};

/// Two scans without noise in an L-shaped room of ours, as in the paper's Figures 2 and 3: from where the robot starts,
/// a part of the room hides behind the corner.
ScanPair ideal_scan_pair();

/// Two scans of corridor_world() with 1 cm of noise, of 1,081 points each, as in the paper's Figures 6 to 8: in the
/// side corridor, and where it has come out of it. The same seed gives the same noise.
ScanPair corridor_scan_pair(std::uint64_t seed);

/// The pair matched with the paper's distances, 0.3 m, and the two maps that come of it.
struct MatchedPair {
  ScanPair scans;
  IcpResult2 result;           ///< with all outputs; updated_map is M and the outliers of T (Figure 8b)
  PointCloud2 inliers;         ///< of T, in M
  PointCloud2 all_points_map;  ///< M and all of T (Figure 7b)
};
MatchedPair match(ScanPair scans);

}  // namespace slamicp
