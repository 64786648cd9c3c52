// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <slamicp/geometry/trajectory.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/obstacle_tracker.hpp>

namespace slamicp {

/// All that a tracker of people in a map is set by.
struct TrackingSetup {
  LocalizerOptions localization = {};
  ObstacleOptions detection = {};
  ObstacleTrackerOptions tracking = {};
};

/// The one setting for legs: what is 0.15 m off the map may be one; points at one incidence hold together that legs
/// side by side do not have; nearer than 0.76 m the robots of the logs see themselves.
TrackingSetup setup_for_legs();

/// A map of what stays, made of a log itself: the mean reading of each 5 cm square that more scans show taken than look
/// through. Who stands for a while, but not for half of the log, does not get into it. Throws Error where nothing
/// stays. O(squares * scans).
/// @param trajectory  T_map_robot of each scan
PointMap2::Pointer background_of(std::span<const LaserScan> scans, const Trajectory& trajectory);

/// How legs were found.
struct LegScore {
  std::size_t scans = 0;
  std::size_t labels = 0;
  std::size_t found = 0;       ///< labels with a leg track within reach of their own
  std::size_t leg_tracks = 0;  ///< tracks of legs and people, over all scans that showed them

  double recall() const noexcept { return labels > 0 ? static_cast<double>(found) / static_cast<double>(labels) : 1.0; }
  double leg_tracks_a_scan() const noexcept {
    return scans > 0 ? static_cast<double>(leg_tracks) / static_cast<double>(scans) : 0.0;
  }
};

/// One scan of a log, tracked; good during the call only.
struct TrackedScan {
  const LaserScan& scan;
  const Fix& fix;
  std::span<const Obstacle> obstacles;
  std::span<const Track> tracks;
};

/// Localizes a log in a map and follows what the map does not know.
/// @param first  T_map_robot of the first scan
void follow_log(std::span<const LaserScan> scans, PointMap2::Pointer map, const Pose2& first,
                const TrackingSetup& setup, const std::function<void(const TrackedScan&)>& each);

/// Where tracks of legs and people say that legs are, of what this scan showed: those of a person at the obstacles that
/// it was seen as.
PointCloud2 legs_of(const TrackedScan& tracked);

/// Adds a scan: each label may be found by one leg within `reach` [m], the nearest pairs first.
void add_legs(const TrackedScan& tracked, PointView<2> labels, double reach, LegScore& score);

}  // namespace slamicp
