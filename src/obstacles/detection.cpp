// SPDX-License-Identifier: Apache-2.0
#include "obstacles/detection.hpp"

#include <algorithm>
#include <cmath>

namespace slamicp {
namespace {

struct Ends {
  bool is_cut = false;   // something nearer stands beside one: it may go on behind that
  bool is_part = false;  // the laser sees it go on beyond one: the rest of it is in the map
};

Ends ends_of(const Fix& fix, const LaserScan& scan, const Obstacle& obstacle) noexcept {
  constexpr double step = 0.1;  // [m]
  constexpr int beams = 2;
  Ends ends;
  if (!fix.scan.scans.empty()) return ends;  // beams of several scans: not known
  const Point2 laser = scan.T_robot_laser.translation();
  const auto look_beside = [&](int point, int way) {
    const auto index = static_cast<std::size_t>(point);
    const double range = (fix.scan.in_robot[index] - laser).norm();
    for (int k = 1; k <= beams; ++k) {
      const int beam = fix.scan.beams[index] + way * k;
      if (beam < 0 || beam >= static_cast<int>(scan.ranges.size())) {
        ends.is_cut = true;
        continue;
      }
      const float reading = scan.ranges[static_cast<std::size_t>(beam)];
      if (!is_return(scan, reading)) continue;
      const double beyond = static_cast<double>(reading) - range;
      ends.is_cut |= beyond < -step;
      ends.is_part |= std::abs(beyond) <= step;
    }
  };
  look_beside(obstacle.points.front(), -1);
  look_beside(obstacle.points.back(), 1);
  return ends;
}

/// Points evenly along it, its ends left out: they may lie between near and far.
Footprint footprint_of(const Fix& fix, const Obstacle& obstacle) noexcept {
  Footprint footprint;
  const std::size_t points = obstacle.points.size();
  const auto count = std::min<std::size_t>(Footprint::most, points > 2 ? points - 2 : points);
  const RigidTransform<2> T_map_robot(fix.pose);
  for (std::size_t k = 0; k < count; ++k) {
    const auto point = static_cast<std::size_t>(obstacle.points[evenly_chosen(k, count, points)]);
    footprint.points[k] = T_map_robot * fix.scan.in_robot[point];
  }
  footprint.count = static_cast<int>(count);
  return footprint;
}

}  // namespace

Matrix<2, 2> noise_of_fix(const Fix& fix, const Point2& in_map) noexcept {
  const Matrix<2, 2> rotation = fix.pose.rotation();
  const Point2 in_robot = rotation.transpose() * (in_map - fix.pose.translation());
  Matrix<2, 3> jacobian;
  jacobian << rotation, rotation * Vector<2>(-in_robot.y(), in_robot.x());
  return jacobian * fix.covariance * jacobian.transpose();
}

Detection detect(const Fix& fix, const LaserScan& scan, const Obstacle& obstacle, int index) noexcept {
  Detection it;
  it.obstacle = index;
  it.middle = obstacle.box.centre;
  it.width = obstacle.box.width;
  // Between the last beam that met it and the next one that did not it may go on.
  const double spacing = obstacle.distance * std::abs(scan.angle_increment);
  const Ends ends = ends_of(fix, scan, obstacle);
  it.is_part = ends.is_part;
  it.is_leg = it.width <= widest_leg && it.width + spacing >= least_leg && !ends.is_cut && !ends.is_part;
  // What is seen of wide things changes more.
  const double unsteady = it.width <= widest_leg ? 0.03 : std::min(0.3, 0.02 + 0.1 * it.width);
  it.noise = unsteady * unsteady * Matrix<2, 2>::Identity() + noise_of_fix(fix, it.middle);
  it.footprint = footprint_of(fix, obstacle);
  return it;
}

}  // namespace slamicp
