// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include <slamicp/agent/obstacle_evaluation.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/navigation/path_tracker.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/obstacles/obstacle_tracker.hpp>

namespace slamicp {

/// The two forms of the paper's software agent (section 3.3, Figure 9).
enum class AgentForm {
  /// Figure 9a: a match by a tree of the map that hands out nothing but the pose, and a comparison of the transformed
  /// scan with all of the map, by brute force, to find what does not fit. Slow; for comparison.
  original,
  /// Figure 9b: the outliers of the match are what does not fit.
  improved,
};

struct AgentOptions {
  AgentForm form = AgentForm::improved;
  /// The original form has its own match: of these options it uses the distances, the ranges and use_odometry.
  LocalizerOptions localization = {};
  PathTrackerOptions tracking = {};
  /// Without shapes: the evaluation asks where points are.
  ObstacleOptions detection = {.min_points = 5, .shapes = false};
  ObstacleTrackerOptions following = {};  ///< of obstacles from scan to scan
  ObstacleEvaluationOptions evaluation = {};
  /// The index of the map is built anew for every scan, as the paper's MATLAB wrapper does; for comparison.
  bool rebuild_index = false;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// How long each subtask took [s]; 0 without a clock.
struct CycleTimes {
  double localization = 0.0;
  double path_tracking = 0.0;
  double obstacle_detection = 0.0;
  double obstacle_evaluation = 0.0;

  double total() const noexcept { return localization + path_tracking + obstacle_detection + obstacle_evaluation; }
};

/// What one scan led to.
struct Cycle {
  const Fix* fix = nullptr;  ///< where the robot is; good until the next step
  Tracking tracking;         ///< where it is on its way, and what the motors are told
  /// What stands there that the map does not know; good until the next step.
  std::span<const EvaluatedObstacle> obstacles;
  std::span<const Track> tracks;  ///< the same from scan to scan; good until the next step
  Decision decision = Decision::ignore;
  CycleTimes times;
};

/// Seconds that pass; a core without a clock is given one.
using Clock = std::function<double()>;

/// A robot's software agent: from each scan, one control cycle of self-localization, path tracking, obstacle detection
/// and obstacle evaluation, in this order. What the evaluation finds holds back the path tracking of the next cycle,
/// one scan later; a scan that fits nothing (too_few_points, no_overlap) stops the robot, and so does a pose that is
/// lost.
///
/// Belongs to one thread. The improved form allocates nothing after the first scan, as long as scans do not grow and no
/// more than 32 obstacles are seen at once.
class Agent {
 public:
  /// @param path   what to drive
  /// @param clock  for the times; none: they stay 0
  /// Throws Error with options.problem(), or where map or path are null.
  Agent(PointMap2::Pointer map, std::shared_ptr<const SplinePath> path, const AgentOptions& options = {},
        Clock clock = {});
  ~Agent();
  Agent(Agent&&) noexcept;
  Agent& operator=(Agent&&) noexcept;

  /// Where the robot is now, T_map_robot.
  void set_pose(const Pose2& pose);

  /// One control cycle. What it returns is good until the next.
  const Cycle& step(const LaserScan& scan);

  /// What to do at `now`, in the clock of the scans [s], where the next scan may be late: see
  /// ObstacleEvaluation::decision_at.
  Decision decision_at(double now) const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slamicp
