// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/simulation/agent_drive.hpp>

namespace slamicp {

std::string AgentDriveOptions::problem() const {
  for (const std::string& problem : {robot.problem(), lidar.problem(), agent.problem()})
    if (!problem.empty()) return problem;
  if (!(lidar.sweep_time <= 1.0 / lidar.rate)) return "lidar: a sweep takes longer than there is between two";
  if (!(start >= 0.0 && std::isfinite(start))) return "start must be 0 m or more";
  if (!(most_seconds > 0.0)) return "most_seconds must be above 0 s";
  return {};
}

AgentDriveResult drive_agent(const World& world, PointMap2::Pointer map, std::shared_ptr<const SplinePath> path,
                             const AgentDriveOptions& options, const std::function<bool(const DriveMoment&)>& each,
                             Clock clock) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "AgentDriveOptions");
  if (!path) throw Error("the path is null", "drive_agent", "make one from waypoints: SplinePath");
  AgentOptions with_delay = options.agent;
  with_delay.tracking.delay = options.robot.delay + options.lidar.sweep_time;
  Agent agent(std::move(map), path, with_delay, std::move(clock));
  SimulatedRobot robot(options.robot, path->at(options.start), options.seed);
  Random random = Random(options.seed).stream(1);
  agent.set_pose(robot.pose());

  AgentDriveResult result;
  for (std::uint64_t k = 0; result.seconds < options.most_seconds; ++k) {
    const double stamp = static_cast<double>(k) / options.lidar.rate;
    robot.advance(stamp);
    const Pose2 T_map_robot = robot.pose();
    const Pose2 T_odom_robot = robot.odometry();
    robot.advance(stamp + options.lidar.sweep_time);
    LaserScan seen = scan(world, T_map_robot, T_map_robot.inverse() * robot.pose(), options.lidar, random, stamp);
    seen.T_odom_robot = T_odom_robot;
    if (options.lidar.sweep_time > 0.0) seen.sweep_motion = T_odom_robot.inverse() * robot.odometry();
    const Cycle& cycle = agent.step(seen);
    robot.command(stamp + options.lidar.sweep_time, cycle.tracking.command);
    result.finished = cycle.tracking.finished;
    result.seconds = stamp;
    if (!each({seen, T_map_robot, cycle}) || result.finished) break;
  }
  return result;
}

}  // namespace slamicp
