// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
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
  /// Notes that a map of so many points is about to grow by these of the fix's scan, in this order.
  void expect(std::size_t map_size, const Fix& fix, std::span<const int> points);

  /// The map's points, each moved to the mean of what was seen of it. Without those that were seen far less often than
  /// their neighbours, which is what noise leaves beside a wall; and without strays, what a laser reads where its beam
  /// meets an edge: they lie between near and far in their scan, stand alone in the map, and no later scan saw them
  /// again. O(n log n).
  PointCloud2 refined(const PointMap2& map) const;

 private:
  struct Seen {
    Point2 sum = Point2::Zero();
    double times = 0.0;
    int since = 0;              // scans counted before it came
    bool may_be_mixed = false;  // by the beams beside it
  };

  bool may_be_mixed(const Fix& fix, std::size_t i) const noexcept;
  bool is_doubtful(std::size_t k) const noexcept;

  double reach_;
  int scans_ = 0;           // counted
  std::vector<Seen> seen_;  // one for each map point so far
};

}  // namespace slamicp
