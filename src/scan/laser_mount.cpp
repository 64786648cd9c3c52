// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/geometry/planar.hpp>
#include <slamicp/scan/laser_mount.hpp>

namespace slamicp {

LaserMount laser_mount(const Pose3& T_robot_laser) noexcept {
  const double up = (T_robot_laser.orientation * Point3::UnitZ()).z();
  return {planar(T_robot_laser), up < 0.0, std::acos(std::min(std::abs(up), 1.0))};
}

void apply(const LaserMount& mount, LaserScan& scan) noexcept {
  scan.T_robot_laser = mount.T_robot_laser;
  if (!mount.upside_down) return;
  scan.angle_min = -scan.angle_min;
  scan.angle_increment = -scan.angle_increment;
}

}  // namespace slamicp
