// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp {

std::string DriveOptions::problem() const {
  if (!(speed > 0.0 && std::isfinite(speed))) return "speed must be above 0 m/s";
  if (const std::string in_lidar = lidar.problem(); !in_lidar.empty()) return "lidar: " + in_lidar;
  if (const std::string in_odometry = odometry.problem(); !in_odometry.empty()) return "odometry: " + in_odometry;
  return {};
}

SimulatedRun simulate_drive(const World& world, std::span<const Point2> waypoints, const DriveOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "DriveOptions");
  const SplinePath path(waypoints);
  const Random random(options.seed);
  Random lidar_random = random.stream(1);
  Random wheel_random = random.stream(2);
  Random sweep_random = random.stream(3);

  const auto count = static_cast<std::size_t>(std::floor(path.length() / options.speed * options.lidar.rate)) + 1;
  SimulatedRun run;
  run.scans.reserve(count);
  run.truth.reserve(count);
  Pose2 T_odom_robot;
  for (std::size_t i = 0; i < count; ++i) {
    const double stamp = static_cast<double>(i) / options.lidar.rate;
    const Pose2 T_map_robot = path.at(stamp * options.speed);
    if (i > 0) {
      const Pose2 T_before_after = run.truth.back().pose.inverse() * T_map_robot;
      T_odom_robot = T_odom_robot * measured_motion(T_before_after, options.odometry, wheel_random);
    }
    const Pose2 sweep_motion = T_map_robot.inverse() * path.at((stamp + options.lidar.sweep_time) * options.speed);
    LaserScan sweep = scan(world, T_map_robot, sweep_motion, options.lidar, lidar_random, stamp);
    sweep.T_odom_robot = T_odom_robot;
    if (options.lidar.sweep_time > 0.0)
      sweep.sweep_motion = measured_motion(sweep_motion, options.odometry, sweep_random);
    run.scans.push_back(std::move(sweep));
    run.truth.push_back({stamp, T_map_robot});
  }
  return run;
}

}  // namespace slamicp
