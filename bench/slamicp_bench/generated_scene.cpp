// SPDX-License-Identifier: Apache-2.0
#include "generated_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <slamicp/scan/scan_points.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp::bench {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double clearance = 0.35;  // of the robot [m]
constexpr double step_length = 0.05;
constexpr std::size_t scans_of_a_run = 5;

LidarModel lidar_with(int beams) {
  LidarModel lidar = hokuyo_utm30lx();
  lidar.beams = beams;
  lidar.angle_increment = 1.5 * std::numbers::pi / std::max(1, beams - 1);
  return lidar;
}

/// Where the robot goes.
class Wanderer {
 public:
  Wanderer(const Layout& layout, Random random) : layout_(layout), random_(random) {}

  Pose2 next() {
    const Point2 ahead = pose_ * Point2(step_length, 0.0);
    if (steps_++ % scans_of_a_run == 0 || !is_free(ahead))
      pose_ = anywhere();
    else
      pose_ = {ahead.x(), ahead.y(), pose_.theta};
    return pose_;
  }

 private:
  bool is_free(const Point2& point) const {
    const Bounds<2>& in = layout_.interior;
    const bool inside = (point.array() > in.lower.array()).all() && (point.array() < in.upper.array()).all();
    return inside && distance_to_walls(layout_.world, point) > clearance;
  }

  Pose2 anywhere() {
    const Bounds<2>& in = layout_.interior;
    while (true) {
      const Point2 point(random_.uniform(in.lower.x(), in.upper.x()), random_.uniform(in.lower.y(), in.upper.y()));
      if (is_free(point)) return {point.x(), point.y(), wrap_angle(random_.uniform(0.0, turn))};
    }
  }

  const Layout& layout_;
  Random random_;
  Pose2 pose_;
  std::size_t steps_ = 0;
};

/// Sets round things about the robot until the wanted share of the returns comes from them.
void hide_behind_things(std::vector<double>& ranges, const Pose2& pose, const LidarModel& lidar, double share,
                        Random& random) {
  const std::vector<double> walls = ranges;
  const auto returns = std::count_if(walls.begin(), walls.end(), [&](double range) { return range < lidar.range_max; });
  World things;
  std::vector<double> seen;
  for (int tries = 0; tries < 400; ++tries) {
    const auto hidden = std::count_if(ranges.begin(), ranges.end(),
                                      [&, k = std::size_t{0}](double range) mutable { return range < walls[k++]; });
    if (static_cast<double>(hidden) >= share * static_cast<double>(returns)) return;
    const double bearing = lidar.angle_min + random.uniform(0.0, lidar.angle_increment * (lidar.beams - 1));
    const double radius = random.uniform(0.04, 0.12);
    const Pose2 towards{pose.x, pose.y, pose.theta + bearing};
    things.obstacles = {{"thing", {}, {{towards * Point2(random.uniform(0.5, 2.5), 0.0), radius}}}};
    true_ranges(things, pose, lidar, seen);
    for (std::size_t k = 0; k < ranges.size(); ++k) ranges[k] = std::min(ranges[k], seen[k]);
  }
}

PointCloud2 points_of(const std::vector<double>& ranges, const LidarModel& lidar, Random& random) {
  LaserScan scan;
  scan.angle_min = lidar.angle_min;
  scan.angle_increment = lidar.angle_increment;
  scan.range_min = lidar.range_min;
  scan.range_max = lidar.range_max;
  for (const double range : ranges) {
    const double noise = lidar.range_noise * random.normal();
    scan.ranges.push_back(std::isfinite(range) ? static_cast<float>(range + noise) : 0.0F);
  }
  return to_points(scan).in_robot;
}

double cut_normal(Random& random) {
  while (true)
    if (const double value = random.normal(); std::abs(value) < 2.5) return value;
}

}  // namespace

Scene make_scene(const Recipe& recipe) {
  const Random random(recipe.seed);
  Random building = random.stream(0), survey = random.stream(1), things = random.stream(2), noise = random.stream(3),
         guess = random.stream(4);
  const Layout layout = make_layout(recipe.layout, recipe.map_points * default_map_spacing, building);
  const LidarModel lidar = lidar_with(recipe.beams);
  Scene scene{to_string(recipe.layout), std::make_shared<const PointCloud2>(sample_map(layout.world, survey)), {}};
  Wanderer robot(layout, random.stream(5));
  std::vector<double> ranges;
  while (scene.trials.size() < recipe.scans) {
    const Pose2 truth = robot.next();
    true_ranges(layout.world, truth, lidar, ranges);
    hide_behind_things(ranges, truth, lidar, recipe.outlier_share, things);
    const double dx = recipe.guess_sigma * cut_normal(guess), dy = recipe.guess_sigma * cut_normal(guess);
    const double turned = recipe.guess_turn_sigma_deg * turn / 360.0 * cut_normal(guess);
    scene.trials.push_back(
        {points_of(ranges, lidar, noise), truth, {truth.x + dx, truth.y + dy, wrap_angle(truth.theta + turned)}});
  }
  return scene;
}

}  // namespace slamicp::bench
