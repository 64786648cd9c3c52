// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <slamicp/geometry/trajectory.hpp>
#include <slamicp/localization/localizer.hpp>

namespace slamicp {

/// Which points of a scan go into the map.
enum class MapUpdate {
  outliers,    ///< only what the map does not have yet: walls stay thin (the paper, section 3.2, Figure 8b)
  all_points,  ///< every point: walls grow thicker with each scan (section 3.1, Figure 7b); for comparison
};

struct MapperOptions {
  /// Pairs farther apart take no part [m]. Wider than a localizer's: coming back to a known place, the pose has
  /// drifted.
  double max_correspondence_distance = 1.0;
  /// A point at least this far from the map is new and is added [m]. Smaller: more points, slower; larger: thin walls
  /// lose their shape. The resolution of the map.
  double insertion_distance = 0.05;
  /// The map grows when the robot has moved this far [m] ...
  double keyframe_distance = 0.3;
  /// ... or turned this far [rad] since it last grew.
  double keyframe_turn = 0.17;
  /// T_map_robot at the first scan: it fixes the map's frame.
  Pose2 initial_pose = {};
  MapUpdate update = MapUpdate::outliers;
  Method method = Method::point_to_line;
  int max_iterations = 60;
  /// The solver's last gate [m]: wider than for a finished map, whose walls are known better.
  double final_gate = 0.15;
  /// How much the prediction itself counts, as a share of the pairs, see IcpOptions: while little is mapped, a corridor
  /// must not slide.
  double guess_share = 0.05;
  RangeFilter ranges = {};   ///< readings to leave out
  bool use_odometry = true;  ///< see LocalizerOptions
  bool deskew = true;        ///< see LocalizerOptions
  /// Points farther from the robot are forgotten as the map grows [m], > 0; 0: none are. Work and memory are bounded,
  /// and what is left is odometry.
  double forget_distance = 0.0;
  SurfaceOptions surfaces = SurfaceOptions::sparse();  ///< of the map while it grows

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

class MapRefinement;

/// Builds a map while localizing in it: simultaneous localization and mapping by scan matching alone, without
/// loop closure (the paper, sections 2.3 and 3.2).
///
/// Each scan is predicted by odometry (or constant velocity) and matched to the map so far; where the robot has moved
/// on, the outliers of the match become part of the map.
class Mapper {
 public:
  /// Throws Error with options.problem().
  explicit Mapper(const MapperOptions& options = {});
  ~Mapper();
  Mapper(Mapper&&) noexcept;
  Mapper& operator=(Mapper&&) noexcept;

  /// Takes the next scan, in the order of the log. The Fix is good until the next call.
  const Fix& add(const LaserScan& scan);

  /// The map so far; null before the first scan that has points.
  const PointMap2::Pointer& map() const noexcept { return localizer_.map(); }
  /// The map to keep, once the log is done: each point moved to the mean of what later scans saw of it, without the
  /// points that noise has left beside the walls, and without lone readings between near and far that no later scan saw
  /// again; with a forget_distance the map so far. Null before the first scan
  /// that has points. O(n log n).
  PointMap2::Pointer refined_map() const;

  /// T_map_robot of every scan, in the order they came.
  const Trajectory& trajectory() const noexcept { return trajectory_; }
  /// Times the map grew.
  int keyframes() const noexcept { return keyframes_; }
  /// Scans that found nothing to match and were placed by prediction.
  int unmatched() const noexcept { return unmatched_; }

 private:
  bool moved_on(const Pose2& pose) const noexcept;
  void grow(const Fix& fix);
  void forget_far_points();

  MapperOptions options_;
  Localizer localizer_;
  std::unique_ptr<MapRefinement> refinement_;
  Trajectory trajectory_;
  Pose2 last_keyframe_;
  int keyframes_ = 0;
  int unmatched_ = 0;
};

}  // namespace slamicp
