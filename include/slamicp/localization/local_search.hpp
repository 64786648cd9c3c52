// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include <slamicp/map/point_map.hpp>
#include <slamicp/registration/icp_options.hpp>
#include <slamicp/scan/scan_points.hpp>

namespace slamicp {

/// Where to look for a pose that is not where it was thought to be.
struct LocalSearchOptions {
  double radius = 3.0;  ///< around the pose that is doubted [m], above 0, at most 20
  double step = 0.25;   ///< between the places that are looked at [m]; a match reaches about half of it. Above 0.01
  double heading_step = std::numbers::pi / 30.0;  ///< between the headings there [rad]; in [0.02, 1]
  int points = 60;                                ///< of the scan that are held against the map at each, 10 to 500
  int matches = 24;                               ///< best places that are matched in full, 1 to 200
  /// What the best place must have before all others [log odds]: where the building has two such places none is told.
  double lead = 1.5;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// What a search has found.
struct FoundPlace {
  Pose2 pose;                ///< T_map_robot
  double probability = 0.0;  ///< that it is right, by this scan alone
  bool unique = false;       ///< false: another place is nearly as likely
};

/// Looks for a robot near where it was thought to be: all headings, a few metres around, one scan. The caller says when
/// and how much: no thread, no stall.
///
/// A place counts the points of the scan that would end near a mapped surface there; the best ones are matched, and
/// their evidence (free space, walls that explain) decides. Allocates.
class LocalSearch {
 public:
  /// @param origin  where the scan's rays start, in the robot's frame
  /// Throws Error with options.problem(), or if `map` is null.
  LocalSearch(PointMap2::Pointer map, ScanPoints scan, const Point2& origin, const Pose2& around,
              const IcpOptions& icp = {}, const LocalSearchOptions& options = {});
  ~LocalSearch();
  LocalSearch(LocalSearch&&) noexcept;
  LocalSearch& operator=(LocalSearch&&) noexcept;

  /// Looks at up to `budget` places more, a match in full counting as 50. True when there is nothing left to look at.
  /// A thousand take about half a millisecond.
  bool step(int budget);

  /// The most likely place; none before the end, and none where nothing matched.
  std::optional<FoundPlace> found() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slamicp
