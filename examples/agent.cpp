// SPDX-License-Identifier: Apache-2.0
// A robot's control loop by the library alone, no files and no ROS: each scan leads to a velocity command, and to what
// stands there that the map does not know (the paper, section 3.3, Figure 9b).
#include <cstdio>

#include <slamicp/agent/agent.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>
#include <slamicp/simulation/robot.hpp>

namespace {

/// Where scans come from and commands go to: put the drivers of your laser and your motors here.
struct Robot {
  slamicp::World world = slamicp::corridor_world_with("D3");
  slamicp::LidarModel lidar = slamicp::hokuyo_utm30lx();
  slamicp::Random random{1};
  slamicp::SimulatedRobot wheels;
  double stamp = 0.0;  // [s]

  slamicp::LaserScan next_scan() {
    wheels.advance(stamp += 0.025);
    slamicp::LaserScan seen = scan(world, wheels.pose(), lidar, random);
    seen.stamp = stamp;
    seen.T_odom_robot = wheels.odometry();  // where there are no encoders, leave it out
    return seen;
  }
  void drive(const slamicp::VelocityCommand& command) { wheels.command(stamp, command); }
};

}  // namespace

int main() {
  const slamicp::World building = slamicp::corridor_world();
  slamicp::Random random(2);
  const auto map = slamicp::PointMap2::create(sample_map(building, random));  // or load_map("corridor.pcd") of io
  const auto path = std::make_shared<const slamicp::SplinePath>(route(building, "reference").waypoints);

  Robot robot{.wheels = {slamicp::apr02(), path->at(0.0), 3}};
  slamicp::Agent agent(map, path, {.tracking = {.speed = 0.55}});
  agent.set_pose(path->at(0.0));  // T_map_robot
  std::size_t seen = 0;
  for (int cycles = 0; cycles < 4000; ++cycles) {
    const slamicp::Cycle& cycle = agent.step(robot.next_scan());
    const slamicp::VelocityCommand& command = cycle.tracking.command;
    robot.drive(command);
    seen += cycle.obstacles.size();
    if (cycles % 120 == 0 || cycle.tracking.finished) {
      std::printf("%5.2f s, %5.2f m: drive %.2f m/s, turn %5.2f rad/s\n", robot.stamp, cycle.tracking.travelled,
                  command.x, command.turn);
      for (const slamicp::EvaluatedObstacle& it : cycle.obstacles)
        std::printf("          %s: %s\n", it.obstacle.brief().c_str(), to_string(it.decision));
    }
    if (cycle.tracking.finished) return seen > 0 ? 0 : 1;
  }
  return 1;
}
