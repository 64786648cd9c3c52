// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/scan/scan_points.hpp>

namespace slamicp {

void to_points(const LaserScan& scan, const RangeFilter& filter, ScanPoints& points) {
  points.in_robot.clear();
  points.beams.clear();
  points.in_robot.reserve(scan.ranges.size());
  points.beams.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const float reading = scan.ranges[i];
    const double range = static_cast<double>(reading);
    if (!is_return(scan, reading) || range < filter.min_range || range >= filter.max_range) continue;
    const double angle = scan.T_robot_laser.theta + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    points.in_robot.emplace_back(scan.T_robot_laser.x + range * std::cos(angle),
                                 scan.T_robot_laser.y + range * std::sin(angle));
    points.beams.push_back(static_cast<int>(i));
  }
}

ScanPoints to_points(const LaserScan& scan, const RangeFilter& filter) {
  ScanPoints points;
  to_points(scan, filter, points);
  return points;
}

}  // namespace slamicp
