// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/evaluation/recorded_drive.hpp>
#include <slamicp/simulation/agent_drive.hpp>
#include <slamicp/simulation/corridor_world.hpp>

namespace slamicp {
namespace {

// How far beside the placed obstacle the agent's may stand: half of a large one, and what the map is off there [m].
constexpr double found_within = 0.15;

class Recorder {
 public:
  Recorder(const ExperimentSite& site, const DrivePlan& plan, const LidarModel& lidar)
      : site_(site), lidar_(lidar), world_(site.world) {
    drive_.plan = plan;
    if (plan.obstacle.empty()) return;
    placed_ = corridor_obstacle(plan.obstacle);
    world_ = with_obstacle(site.world, placed_);
  }

  const World& world() const noexcept { return world_; }

  void add(const DriveMoment& now) {
    const Fix& fix = *now.cycle.fix;
    drive_.samples.push_back({now.scan.stamp, now.cycle.tracking.travelled, now.T_map_robot, fix.pose,
                              fix.outliers().size(), fix.match.inliers, fix.match.mean_inlier_distance,
                              now.cycle.obstacles.size(), is_found(now.cycle), beams_on_it(now), now.cycle.decision});
    if (drive_.views.size() < drive_.plan.views.size() &&
        now.cycle.tracking.travelled >= drive_.plan.views[drive_.views.size()])
      drive_.views.push_back(view(now.cycle));
    if (!drive_.plan.keeps_scans) return;
    drive_.scans.push_back(now.scan);
    drive_.outliers.insert(drive_.outliers.end(), fix.outliers_in_map().begin(), fix.outliers_in_map().end());
  }

  RecordedDrive take(bool finished) {
    drive_.finished = finished;
    return std::move(drive_);
  }

 private:
  bool is_found(const Cycle& cycle) const {
    return std::any_of(cycle.obstacles.begin(), cycle.obstacles.end(), [&](const EvaluatedObstacle& evaluated) {
      return distance(placed_, evaluated.obstacle.box.centre) < found_within;
    });
  }

  /// Those that it shortens.
  int beams_on_it(const DriveMoment& now) {
    if (drive_.plan.obstacle.empty()) return 0;
    const Pose2 T_map_laser = now.T_map_robot * lidar_.T_robot_laser;
    const Pose2 motion = now.scan.sweep_motion.value_or(Pose2{});
    const Pose2 T_first_last = lidar_.T_robot_laser.inverse() * motion * lidar_.T_robot_laser;
    true_ranges(world_, T_map_laser, T_first_last, lidar_, with_, now.scan.stamp);
    true_ranges(site_.world, T_map_laser, T_first_last, lidar_, without_, now.scan.stamp);
    int beams = 0;
    for (std::size_t i = 0; i < with_.size(); ++i) beams += with_[i] < without_[i] && with_[i] <= near_range;
    return beams;
  }

  static DriveView view(const Cycle& cycle) {
    const Fix& fix = *cycle.fix;
    DriveView view{cycle.tracking.travelled, fix.pose, {}, fix.outliers_in_map()};
    auto outlier = fix.outliers().begin();
    for (std::size_t i = 0; i < fix.scan.in_robot.size(); ++i) {
      if (outlier != fix.outliers().end() && static_cast<std::size_t>(*outlier) == i)
        ++outlier;
      else
        view.inliers.push_back(fix.pose * fix.scan.in_robot[i]);
    }
    return view;
  }

  const ExperimentSite& site_;
  LidarModel lidar_;
  World world_;
  PlacedObstacle placed_;
  RecordedDrive drive_;
  std::vector<double> with_;
  std::vector<double> without_;
};

}  // namespace

std::size_t RecordedDrive::most_outliers() const noexcept {
  std::size_t most = 0;
  for (const DriveSample& sample : samples) most = std::max(most, sample.outliers);
  return most;
}

double RecordedDrive::mean_inlier_distance() const noexcept {
  double sum = 0.0;
  for (const DriveSample& sample : samples) sum += sample.mean_inlier_distance;
  return samples.empty() ? 0.0 : sum / static_cast<double>(samples.size());
}

AgentOptions agent_of(const DrivePlan& plan) {
  AgentOptions agent;
  agent.tracking.speed = plan.speed;
  agent.localization.outlier_distance = plan.outlier_distance;
  agent.evaluation.corridor_half_width = plan.corridor_half_width;
  return agent;
}

RecordedDrive record_drive(const ExperimentSite& site, const DrivePlan& plan) {
  AgentDriveOptions options;
  options.agent = agent_of(plan);
  options.seed = plan.seed;
  options.start = plan.start;
  options.most_seconds = plan.most_seconds;
  Recorder recorder(site, plan, options.lidar);
  const AgentDriveResult result =
      drive_agent(recorder.world(), site.map, site.path, options, [&](const DriveMoment& now) {
        recorder.add(now);
        return true;
      });
  return recorder.take(result.finished);
}

Sighting sighting_of(const RecordedDrive& drive) {
  Sighting sighting;
  if (drive.plan.obstacle.empty()) return sighting;
  const PlacedObstacle placed = corridor_obstacle(drive.plan.obstacle);
  for (const DriveSample& sample : drive.samples) {
    if (!sighting.was_due() && sample.beams_on_it >= beams_to_find) sighting.due = sample.stamp;
    if (!sighting.was_found() && sample.found) {
      sighting.found = sample.stamp;
      sighting.found_at_range = distance(placed, sample.truth.translation());
    }
  }
  return sighting;
}

}  // namespace slamicp
