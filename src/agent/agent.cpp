// SPDX-License-Identifier: Apache-2.0
#include <slamicp/agent/agent.hpp>
#include <slamicp/error.hpp>

#include "agent/self_localization.hpp"

namespace slamicp {
namespace {

constexpr std::size_t usual_obstacles = 32;  // at once; for more, memory is laid out as they come

}  // namespace

std::string AgentOptions::problem() const {
  for (const std::string& problem :
       {localization.problem(), tracking.problem(), detection.problem(), following.problem(), evaluation.problem()})
    if (!problem.empty()) return problem;
  if (!localization.outputs.outlier_indices) return "localization.outputs must ask for outlier_indices";
  return {};
}

struct Agent::State {
  State(std::unique_ptr<SelfLocalization> how, std::shared_ptr<const SplinePath> path, const AgentOptions& options,
        Clock given)
      : localization(std::move(how)),
        tracker(std::move(path), options.tracking),
        finder(options.detection),
        follower(options.following),
        evaluation(options.evaluation),
        clock(std::move(given)) {}

  /// Does a subtask, and says how long it took.
  template <typename Subtask>
  double timed(const Subtask& subtask) const {
    const double start = clock ? clock() : 0.0;
    subtask();
    return clock ? clock() - start : 0.0;
  }

  void step(const LaserScan& scan);
  void lay_out(std::size_t beams);
  void track();

  std::unique_ptr<SelfLocalization> localization;
  PathTracker tracker;
  ObstacleFinder finder;
  ObstacleTracker follower;
  ObstacleEvaluation evaluation;
  Clock clock;
  Cycle cycle;
  std::size_t most_beams = 0;  // of a scan so far
};

void Agent::State::step(const LaserScan& scan) {
  if (scan.ranges.size() > most_beams) lay_out(scan.ranges.size());
  std::span<const Obstacle> found;
  cycle.times.localization = timed([&] { localization->localize(scan); });
  cycle.fix = &localization->fix();
  cycle.times.path_tracking = timed([&] { track(); });
  cycle.times.obstacle_detection = timed([&] {
    localization->find_discrepancies();
    found = finder.find(*cycle.fix, scan);
    cycle.tracks = follower.update(*cycle.fix, scan, found);
  });
  cycle.times.obstacle_evaluation = timed([&] {
    evaluation.update(tracker.path(), cycle.tracking.travelled, *cycle.fix, found, cycle.tracks,
                      tracker.options().speed);
  });
  cycle.obstacles = evaluation.obstacles();
  cycle.decision = evaluation.decision();
}

/// Memory for this scan and all to come that are no larger.
void Agent::State::lay_out(std::size_t beams) {
  finder.reserve(usual_obstacles, beams);
  evaluation.reserve(usual_obstacles, beams);
  most_beams = beams;
}

void Agent::State::track() {
  const double limit = cycle.fix->nowhere() ? 0.0 : evaluation.speed_limit();
  cycle.tracking = tracker.update(cycle.fix->pose, cycle.fix->stamp, limit);
}

Agent::Agent(PointMap2::Pointer map, std::shared_ptr<const SplinePath> path, const AgentOptions& options, Clock clock) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "AgentOptions");
  if (!map) throw Error("the map is null", "Agent", "make one with PointMap2::create, or load_map");
  auto localization = options.form == AgentForm::original ? original_localization(std::move(map), options)
                                                          : improved_localization(std::move(map), options);
  state_ = std::make_unique<State>(std::move(localization), std::move(path), options, std::move(clock));
}

Agent::~Agent() = default;
Agent::Agent(Agent&&) noexcept = default;
Agent& Agent::operator=(Agent&&) noexcept = default;

void Agent::set_pose(const Pose2& pose) {
  if (!pose.is_finite()) throw Error("the pose is not finite", "Agent::set_pose", "give x [m], y [m], heading [rad]");
  state_->localization->set_pose(pose);
}

Decision Agent::decision_at(double now) const noexcept { return state_->evaluation.decision_at(now); }

const Cycle& Agent::step(const LaserScan& scan) {
  state_->step(scan);
  return state_->cycle;
}

}  // namespace slamicp
