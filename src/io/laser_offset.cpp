// SPDX-License-Identifier: Apache-2.0
#include "io/laser_offset.hpp"

#include <cmath>
#include <numbers>

#include <slamicp/geometry/angle.hpp>

#include "io/median.hpp"

namespace slamicp {
namespace {

double round_to(double value, double step) { return std::round(value / step) * step + 0.0; }

/// One coordinate of the offset over the log: its median, and the median distance from it.
struct Coordinate {
  double median = 0.0;
  double spread = 0.0;
};

Coordinate coordinate_of(std::vector<double> values) {
  Coordinate coordinate;
  coordinate.median = median_of(values);
  for (double& value : values) value = std::abs(value - coordinate.median);
  coordinate.spread = median_of(std::move(values));
  return coordinate;
}

}  // namespace

Pose2 laser_offset(const std::vector<CarmenScan>& scans, std::vector<std::string>& warnings) {
  constexpr double most_metres = 0.02;
  constexpr double most_angle = 1.0 * rad_per_deg;
  const auto offset_of = [](const CarmenScan& scan) { return scan.scan.T_odom_robot->inverse() * scan.T_odom_laser; };
  // Headings relative to the first one: a laser that looks backwards has offsets on both sides of pi.
  const double first_theta = offset_of(scans.front()).theta;
  std::vector<double> x, y, theta;
  for (const CarmenScan& scan : scans) {
    const Pose2 offset = offset_of(scan);
    x.push_back(offset.x);
    y.push_back(offset.y);
    theta.push_back(wrap_angle(offset.theta - first_theta));
  }
  const Coordinate in_x = coordinate_of(std::move(x));
  const Coordinate in_y = coordinate_of(std::move(y));
  const Coordinate in_theta = coordinate_of(std::move(theta));
  if (!(in_x.spread <= most_metres && in_y.spread <= most_metres && in_theta.spread <= most_angle)) {
    warnings.push_back(
        "laser poses do not follow the odometry (a corrected log?): the laser is taken to sit at the robot's centre; "
        "give its offset if it does not");
    return {};
  }
  const double heading = wrap_angle(in_theta.median + first_theta);
  return {round_to(in_x.median, 1e-4), round_to(in_y.median, 1e-4),
          wrap_angle(round_to(heading / rad_per_deg, 0.01) * rad_per_deg)};
}

}  // namespace slamicp
