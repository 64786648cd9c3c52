// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include <slamicp/localization/fix.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/obstacles/track.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

struct ObstacleTrackerOptions {
  /// Scans that must show a thing, and the longest it may take, before it is believed. More: less is believed that is
  /// noise, and what came is told later. At least 1; [s], > 0.
  int confirmations = 3;
  double confirm_within = 0.6;
  /// How long a track lives without being seen where the laser sees its place [s], > 0 ...
  double patience = 0.4;
  /// ... and where something nearer hides it, or the laser does not look there [s], at least `patience`.
  double hidden_patience = 2.0;
  /// How long a thing must stay before it is called static [s], > 0.
  double settle = 1.0;
  /// A thing is only called moving once it has moved so far [m], > 0, and the laser has seen its old place free or its
  /// new one. Larger: slower things are not told; smaller: an error of the pose must stay smaller.
  double least_motion = 0.10;
  /// How far the unknown accelerations of a walking person are thought to reach, as a spectral density [m^2/s^3], > 0.
  /// Larger: the velocity follows sooner, and is less steady.
  double agility = 0.5;
  /// Gate of the assignment: a detection this unlikely, by its squared Mahalanobis distance, is of something else. The
  /// default is left by one in a hundred. > 0.
  double gate = 9.21;
  /// Tracks at most; what comes then is not followed, the farthest first. 1 to 1000.
  int most_tracks = 100;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// Follows obstacles from scan to scan: which one is which, how fast it is, whether it moves at all.
///
/// A Kalman filter of constant velocity for each (Bar-Shalom, Li, Kirubarajan 2001, section 6.2); each scan's obstacles
/// are given out by the least sum of their distances (global nearest neighbour by shortest augmenting paths: Jonker,
/// Volgenant 1987; Crouse 2016). A detection is as uncertain as its shape and the fix, the heading's error times the
/// distance included.
///
/// What is seen of a thing changes as the robot goes round it; that moves its middle, yet not the thing. So nothing is
/// called moving by its middle alone: rays must have passed through the place where it is now, or pass through the one
/// where it was, each seen with the width of the pose's error to spare.
///
/// People are two legs that take turns. A leg that moves and another one that stays with it become one track, whose
/// measurement is the middle of both, or the one that is seen (Leigh et al. 2015, "Person tracking and following with
/// 2D laser scanners").
///
/// Belongs to one thread. `update` allocates nothing after the first scan, as long as scans do not grow. The same scans
/// give the same tracks.
class ObstacleTracker {
 public:
  /// Throws Error with options.problem().
  explicit ObstacleTracker(const ObstacleTrackerOptions& options = {});
  ~ObstacleTracker();
  ObstacleTracker(ObstacleTracker&&) noexcept;
  ObstacleTracker& operator=(ObstacleTracker&&) noexcept;

  /// Takes what was found in a scan. Hands out every track, tentative and hidden ones too, in order of their id; good
  /// until the next call. A scan whose stamp is not after the last one's is left out. A fix that is not usable, or
  /// lost, places nothing: then tracks are only carried on.
  /// @param scan       the one that the fix is of; of several that were joined the first
  /// @param obstacles  of this fix: their points count its scan
  std::span<const Track> update(const Fix& fix, const LaserScan& scan, std::span<const Obstacle> obstacles) noexcept;

  /// Those of the last update.
  std::span<const Track> tracks() const noexcept;

  /// Forgets all tracks: the robot was put down elsewhere. Ids go on.
  void clear() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slamicp
