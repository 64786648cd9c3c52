// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/navigation/path_tracker.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp {

SimulatedRun simulate_drive(const World& world, std::span<const Point2> waypoints, const OmniRobotModel& robot,
                            const DriveOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "DriveOptions");
  const LidarModel& lidar = options.lidar;
  if (!(lidar.sweep_time <= 1.0 / lidar.rate))
    throw Error("a sweep takes longer than there is between two", "DriveOptions", "give a lower rate");
  const auto path = std::make_shared<const SplinePath>(waypoints);
  PathTracker tracker(path, {.speed = options.speed, .delay = robot.delay + lidar.sweep_time});
  const Random random(options.seed);
  Random lidar_random = random.stream(1);
  SimulatedRobot wheels(robot, path->at(0.0), options.seed);

  const double most_seconds = 60.0 + 10.0 * path->length() / options.speed;
  SimulatedRun run;
  for (std::size_t k = 0;; ++k) {
    const double stamp = static_cast<double>(k) / lidar.rate;
    if (stamp > most_seconds)
      throw Error("the robot does not get to the end of its way", "simulate_drive",
                  "give it less slip, or a lower speed");
    wheels.advance(stamp);
    const Pose2 T_map_robot = wheels.pose();
    const Pose2 T_odom_robot = wheels.odometry();
    wheels.advance(stamp + lidar.sweep_time);
    LaserScan sweep = scan(world, T_map_robot, T_map_robot.inverse() * wheels.pose(), lidar, lidar_random, stamp);
    sweep.T_odom_robot = T_odom_robot;
    if (lidar.sweep_time > 0.0) sweep.sweep_motion = T_odom_robot.inverse() * wheels.odometry();
    run.scans.push_back(std::move(sweep));
    run.truth.push_back({stamp, T_map_robot});
    const Tracking& tracking = tracker.update(T_map_robot, stamp);
    if (tracking.finished) return run;
    wheels.command(stamp + lidar.sweep_time, tracking.command);
  }
}

}  // namespace slamicp
