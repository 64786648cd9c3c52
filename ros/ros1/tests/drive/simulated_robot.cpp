// SPDX-License-Identifier: Apache-2.0
#include "simulated_robot.hpp"

#include <cmath>
#include <limits>

#include <slamicp/io/map_file.hpp>
#include <slamicp/navigation/path_tracker.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>
#include <slamicp/simulation/robot.hpp>

namespace slamicp::drive {
namespace {

constexpr double box_ahead = 4.0;  // [m]

PlainPose plain(const Pose2& pose) { return {pose.x, pose.y, pose.theta}; }

std::shared_ptr<const SplinePath> reference_path() {
  return std::make_shared<const SplinePath>(route(corridor_world(), "reference").waypoints);
}

}  // namespace

struct SimulatedRobot::State {
  State() : world(corridor_world()), robot(apr02(), reference_path()->at(0.0), 1), random(2) {
    const Pose2 place = reference_path()->at(box_ahead);
    world = with_box(world, {place.translation(), 0.3, 0.3, place.theta});
  }

  World world;
  LidarModel lidar = real_hokuyo_utm30lx();
  slamicp::SimulatedRobot robot;
  Random random;
  std::uint64_t steps = 0;
  Sweep sweep;
};

SimulatedRobot::SimulatedRobot() : state_(std::make_unique<State>()) {}
SimulatedRobot::~SimulatedRobot() = default;

const Sweep& SimulatedRobot::step(const Command& command) {
  State& state = *state_;
  constexpr double start = 1000.0;
  state.lidar.rate = rate;
  const double stamp = static_cast<double>(state.steps++) / state.lidar.rate;
  const double end = stamp + state.lidar.sweep_time;
  if (state.steps > 1) state.robot.command(state.robot.stamp(), {command.x, command.y, command.turn});
  state.robot.advance(stamp);
  const Pose2 T_map_robot = state.robot.pose();
  Sweep& sweep = state.sweep;
  sweep.odometry = plain(state.robot.odometry());
  state.robot.advance(end);
  sweep.odometry_at_end = plain(state.robot.odometry());
  sweep.truth = plain(T_map_robot);
  const LaserScan seen =
      scan(state.world, T_map_robot, T_map_robot.inverse() * state.robot.pose(), state.lidar, state.random, stamp);
  sweep.stamp = start + stamp;
  sweep.end = start + end;
  sweep.angle_min = seen.angle_min;
  sweep.angle_increment = seen.angle_increment;
  sweep.time_increment = seen.time_increment;
  sweep.range_max = state.lidar.range_max;
  sweep.ranges = seen.ranges;
  return sweep;
}

Command SimulatedRobot::wander() const {
  constexpr double middle = 1.6, reach = 1.4, pulse = 0.2, gain = 2.0;  // [m], [m], [rad/s], [1/s]
  const double time = state_->robot.stamp();
  const Pose2 there = reference_path()->at(middle - reach * std::cos(pulse * time));
  const Pose2 way = state_->robot.pose().inverse() * there;
  return {gain * way.x, gain * way.y, gain * way.theta};
}

void SimulatedRobot::remove_box() { state_->world.obstacles.clear(); }

PlainPose SimulatedRobot::write_map(const std::string& file) {
  Random random(3);
  save_map(file, *PointMap2::create(sample_map(corridor_world(), random)));
  return plain(reference_path()->at(0.0));
}

struct Follower::State {
  State() : path(reference_path()), tracker(path, options()) {}
  static PathTrackerOptions options() {
    PathTrackerOptions chosen;
    chosen.delay = apr02().delay + real_hokuyo_utm30lx().sweep_time;
    return chosen;
  }

  std::shared_ptr<const SplinePath> path;
  PathTracker tracker;
  double travelled = 0.0;
};

Follower::Follower() : state_(std::make_unique<State>()) {}
Follower::~Follower() = default;

Command Follower::follow(double stamp, const PlainPose& pose, const std::vector<Thing>& things) {
  constexpr double half_width = 0.3, looks = 1.5, stands = 0.8, braking = 0.5;  // [m], [m/s^2]
  State& state = *state_;
  double limit = std::numeric_limits<double>::infinity();
  for (const Thing& thing : things)
    for (double ahead = 0.0; ahead < looks; ahead += 0.05) {
      const Point2 place = state.path->at(state.travelled + ahead).translation();
      if ((place - Point2(thing.x, thing.y)).norm() > half_width + thing.radius) continue;
      limit = std::min(limit, std::sqrt(2.0 * braking * std::max(0.0, ahead - stands)));
      break;
    }
  const Tracking& tracking = state.tracker.update({pose.x, pose.y, pose.theta}, stamp, limit);
  state.travelled = tracking.travelled;
  return {tracking.command.x, tracking.command.y, tracking.command.turn};
}

double Follower::travelled() const { return state_->travelled; }

}  // namespace slamicp::drive
