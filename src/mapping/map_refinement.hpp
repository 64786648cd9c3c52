// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <slamicp/localization/fix.hpp>

namespace slamicp {

/// What later scans say of each map point. A map that takes only what is new keeps the first reading of a place, noise
/// and all, and then whatever noise throws far enough from it; this finds out which points the walls are made of.
class MapRefinement {
 public:
  /// @param reach  a scan point says something of its nearest map point up to this distance [m]
  explicit MapRefinement(double reach) : reach_(reach) {}

  /// Counts the fix's points for the map points that they match. Needs per-point matches.
  void count(const Fix& fix);

  /// The map's points, each moved to the mean of what was seen of it; without those that were seen far less often than
  /// their neighbours, which is what noise leaves beside a wall.
  PointCloud2 refined(const PointMap2& map) const;

 private:
  struct Seen {
    Point2 sum = Point2::Zero();
    double times = 0.0;
  };

  double reach_;
  std::vector<Seen> seen_;  // one for each map point so far
};

}  // namespace slamicp
