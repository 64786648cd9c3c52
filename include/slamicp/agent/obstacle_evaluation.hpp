// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <slamicp/localization/fix.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/obstacles/exclusion_zone.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/obstacles/track.hpp>

namespace slamicp {

/// What an obstacle means for the way ahead.
enum class Decision {
  ignore,  ///< beside the way, or far
  slow,    ///< on the way: go slower the nearer it is
  stop,    ///< on the way and near: stand
};
const char* to_string(Decision decision) noexcept;

struct ObstacleEvaluationOptions {
  double corridor_half_width = 0.30;  ///< what the robot sweeps to either side of the path, with its margin [m], > 0
  double slow_distance = 1.5;         ///< along the path, from the robot's centre [m], > stop_distance
  double stop_distance = 0.6;         ///< [m], > 0
  double braking = 1.0;               ///< with which a stop in time is planned [m/s^2], > 0
  /// Scans in a row that must show something on the way before the robot slows down, so that a stray reading stops
  /// nobody; a delay of so many scans. At least 1.
  int confirmations = 3;
  /// Scans in a row without it before the robot goes on. At least 1.
  int releases = 5;
  /// What moves and will be where the robot then is, or where it stands, within so long: go slower; stand [s]. It must
  /// be a track that is confirmed, so no more scans are waited for. stop_time > 0, slow_time > stop_time.
  double slow_time = 2.5;
  double stop_time = 1.2;
  /// Older news than this stops the robot: see decision_at() [s], > 0.
  double latest = 0.5;
  std::vector<ExclusionZone> exclusion_zones = {};  ///< what is seen there counts for nothing

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// One obstacle beside or on the way.
struct EvaluatedObstacle {
  Obstacle obstacle;
  double ahead = 0.0;  ///< its nearest point, along the path from the robot [m]; infinity where it is not ahead
  /// Of the point that is nearest to the way ahead, positive to the left [m]; infinity where nothing is near it.
  double cross_track = 0.0;
  Decision decision = Decision::ignore;
  int track = 0;  ///< id of the track that it was seen as; 0: none
  /// Until its track and the robot meet, as both go on now [s]; infinity where they do not, or it does not move.
  double seconds = 0.0;
};

/// Judges obstacles by the path that the robot is about to drive: the last subtask of the paper's agent (Figure 9).
class ObstacleEvaluation {
 public:
  /// Throws Error with options.problem().
  explicit ObstacleEvaluation(const ObstacleEvaluationOptions& options = {});

  /// Room for so many obstacles at once, of so many points each: up to these, update() allocates nothing.
  void reserve(std::size_t obstacles, std::size_t points);

  /// Fail-safe: a fix that is blind (too_few_points, no_overlap) or lost stops the robot at once, and so long as it
  /// lasts; then `releases` scans must be clear before it goes on.
  /// @param travelled  where the robot is on the path [m]
  /// @param tracks     of these obstacles, by the same fix; without them nothing is known to move
  /// @param speed      that the robot goes along the path if nothing holds it back [m/s]
  /// O(points of the obstacles).
  void update(const SplinePath& path, double travelled, const Fix& fix, std::span<const Obstacle> obstacles,
              std::span<const Track> tracks = {}, double speed = 0.0);

  /// Those of the last update, as they came. Good until the next.
  std::span<const EvaluatedObstacle> obstacles() const noexcept { return {evaluated_.data(), count_}; }
  /// What the robot should do, confirmed over several scans.
  Decision decision() const noexcept { return decision_; }
  /// What that leaves of its speed [m/s]: infinity to ignore, 0 to stop.
  double speed_limit() const noexcept { return speed_limit_; }
  /// The decision for whoever asks at `now`, in the clock of the scans [s]: stop where the last scan is older than
  /// `latest`, or was never. For a watchdog between the scans, which may have ceased to come.
  Decision decision_at(double now) const noexcept;

 private:
  class WayAhead;

  /// How far ahead things matter [m].
  double reach() const noexcept { return options_.slow_distance + options_.corridor_half_width; }
  void judge(const WayAhead& way, const Fix& fix, EvaluatedObstacle& it) const;
  double seconds_to(const Track& track, const SplinePath& path, double travelled, const Fix& fix,
                    double speed) const noexcept;
  Decision judge_tracks(const SplinePath& path, double travelled, const Fix& fix, std::span<const Track> tracks,
                        double speed, double& nearest);
  bool is_excluded(const Point2& in_map, const Fix& fix) const noexcept;

  ObstacleEvaluationOptions options_;
  std::vector<EvaluatedObstacle> evaluated_;  // the first count_ of them; the others are kept for their memory
  std::size_t count_ = 0;
  Decision decision_ = Decision::ignore;
  double speed_limit_;
  int in_a_row_ = 0;  // scans that show something on the way
  int clear_ = 0;     // scans that do not
  double stamp_;      // of the last scan [s]
};

}  // namespace slamicp
