// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>

namespace slamicp {
namespace {

/// The widest gap that one surface can leave between two beams `turn` apart, the first of which read `range`:
/// D_max = r sin(turn) / sin(lambda - turn) + 3 sigma (Borges, Aldon 2004).
double widest_gap(double range, double turn, const ObstacleOptions& options) noexcept {
  const double lambda = options.min_incidence_deg * rad_per_deg;
  if (turn >= lambda) return 0.0;
  return range * std::sin(turn) / std::sin(lambda - turn) + 3.0 * options.range_noise;
}

Obstacle make_obstacle(const Fix& fix, const Point2& laser, std::vector<int> points) {
  Obstacle obstacle;
  obstacle.distance = std::numeric_limits<double>::infinity();
  PointCloud2 in_map;
  in_map.reserve(points.size());
  for (const int i : points) {
    const Point2& in_robot = fix.scan.in_robot[static_cast<std::size_t>(i)];
    obstacle.distance = std::min(obstacle.distance, (in_robot - laser).norm());
    in_map.push_back(fix.pose * in_robot);
  }
  obstacle.box = smallest_box(in_map);
  obstacle.points = std::move(points);
  return obstacle;
}

}  // namespace

std::string Obstacle::brief() const {
  char text[128];
  std::snprintf(text, sizeof text, "%.2f m x %.2f m at %.2f m, %.2f m, %zu points", box.width, box.depth,
                box.centre.x(), box.centre.y(), points.size());
  return text;
}

std::string ObstacleOptions::problem() const {
  if (min_points < 1) return "min_points must be at least 1";
  if (!(range_noise >= 0.0)) return "range_noise must be at least 0 m";
  if (!(min_incidence_deg > 0.0 && min_incidence_deg < 90.0))
    return "min_incidence_deg must lie between 0 and 90 degrees; 10 is the default";
  return {};
}

std::vector<Obstacle> find_obstacles(const Fix& fix, const LaserScan& scan, const ObstacleOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "ObstacleOptions");
  const Point2 laser = scan.T_robot_laser.translation();
  std::vector<Obstacle> obstacles;
  std::vector<int> group;
  const auto close_group = [&] {
    if (group.size() >= static_cast<std::size_t>(options.min_points))
      obstacles.push_back(make_obstacle(fix, laser, group));
    group.clear();
  };
  const auto of_one_scan = [&](std::size_t a, std::size_t b) {
    return fix.scan.scans.empty() || fix.scan.scans[a] == fix.scan.scans[b];
  };
  for (const int i : fix.outliers()) {
    if (!group.empty()) {
      const auto here = static_cast<std::size_t>(i);
      const auto before = static_cast<std::size_t>(group.back());
      const double turn = std::abs(scan.angle_increment) * (fix.scan.beams[here] - fix.scan.beams[before]);
      const Point2& last = fix.scan.in_robot[before];
      const double gap = (fix.scan.in_robot[here] - last).norm();
      if (!of_one_scan(here, before) || gap > widest_gap((last - laser).norm(), turn, options)) close_group();
    }
    group.push_back(i);
  }
  close_group();
  std::sort(obstacles.begin(), obstacles.end(),
            [](const Obstacle& a, const Obstacle& b) { return a.distance < b.distance; });
  return obstacles;
}

}  // namespace slamicp
