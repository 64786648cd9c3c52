// SPDX-License-Identifier: Apache-2.0
// No map yet (the paper, section 2.3, Figures 2 and 3): each scan is matched against the one before. Ideal scans, no
// noise: the robot drives down a corridor, and its way comes out of the scans alone.
#include <cstdio>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>

int main() {
  slamicp::DriveOptions drive;
  drive.lidar = slamicp::hokuyo_utm30lx(0.0);  // no noise
  drive.lidar.rate = 5.0;                      // so that the scans differ
  const slamicp::World world = slamicp::corridor_world();
  slamicp::SimulatedRun run = slamicp::simulate_drive(world, route(world, "reference").waypoints, drive);

  slamicp::Localizer localizer;  // no map
  localizer.set_pose(run.truth.front().pose);
  for (slamicp::LaserScan& scan : run.scans) {
    scan.T_odom_robot.reset();  // no wheels either
    localizer.update(scan);
  }
  const slamicp::Pose2 end = localizer.fix().pose;
  const slamicp::PoseDistance error = distance(end, run.truth.back().pose);
  std::printf("%zu scans, ends at %s: %.0f mm and %.2f deg off\n", run.scans.size(), to_string(end).c_str(),
              1e3 * error.translation, error.rotation * 57.29578);
  return error.translation < 0.2 ? 0 : 1;
}
