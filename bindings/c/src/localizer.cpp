// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "conversion.hpp"
#include "handles.hpp"
#include "sized.hpp"

namespace slamicp::c {
namespace {

constexpr std::size_t most_beams = 10'000'000;

slamicp_localizer_options default_localizer_options() noexcept {
  const LocalizerOptions options;
  slamicp_localizer_options made = {};
  made.size = sizeof made;
  made.method = SLAMICP_POINT_TO_LINE;
  made.max_iterations = options.max_iterations;
  made.max_correspondence_distance = options.max_correspondence_distance;
  made.final_gate = options.final_gate;
  made.guess_share = options.guess_share;
  made.outputs = bits_of(options.outputs);
  made.kernel_scale = options.kernel_scale;
  made.min_range = options.ranges.min_range;
  made.max_range = options.ranges.max_range;
  made.use_odometry = options.use_odometry ? 1 : 0;
  made.deskew = options.deskew ? 1 : 0;
  return made;
}

LocalizerOptions localizer_options_from(const slamicp_localizer_options& options) {
  if (!(options.min_range >= 0.0) || !(options.max_range > options.min_range))
    throw Refusal(SLAMICP_BAD_OPTIONS, "min_range must be at least 0 m and below max_range");
  LocalizerOptions made;
  made.method = method_from(options.method);
  made.max_iterations = options.max_iterations;
  made.max_correspondence_distance = options.max_correspondence_distance;
  made.outlier_distance = distance_or_default(options.outlier_distance);
  made.obstacle_distance = distance_or_default(options.obstacle_distance);
  made.final_gate = options.final_gate;
  made.guess_share = options.guess_share;
  made.kernel = kernel_from(options.kernel);
  made.kernel_scale = options.kernel_scale;
  made.outputs = outputs_from(options.outputs);
  made.ranges = {options.min_range, options.max_range};
  made.use_odometry = options.use_odometry != 0;
  made.deskew = options.deskew != 0;
  return made;
}

slamicp_scan default_scan() noexcept {
  slamicp_scan scan = {};
  scan.size = sizeof scan;
  scan.range_max = LaserScan{}.range_max;
  return scan;
}

const PointMap2::Pointer& plane_of(const slamicp_map& map) {
  if (!map.plane) throw Refusal(SLAMICP_BAD_POINTS, "a localizer needs a map of 2 dimensions");
  return map.plane;
}

/// Infinite limits are fine: there is none.
bool is_limit(double metres) noexcept { return !std::isnan(metres); }

void check_scan(const slamicp_scan& scan) {
  if (!std::isfinite(scan.stamp) || !std::isfinite(scan.time_increment))
    throw Refusal(SLAMICP_BAD_SCAN, "the scan's stamp or time_increment is not finite");
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment))
    throw Refusal(SLAMICP_BAD_SCAN, "the scan's angle_min or angle_increment is not finite");
  if (!is_limit(scan.range_min) || !is_limit(scan.range_max))
    throw Refusal(SLAMICP_BAD_SCAN, "the scan's range_min or range_max is not a number");
  if (scan.count > most_beams) throw Refusal(SLAMICP_BAD_SCAN, "the scan has more than 10^7 beams");
  if (scan.count > 0) need(scan.ranges, "scan->ranges");
}

/// Ranges lie in the handle's memory, which grows no more after the largest scan.
void take_scan(const slamicp_scan& from, LaserScan& to) {
  check_scan(from);
  const auto pose = [](const double* numbers, const char* name) { return pose_from<2>(numbers, name); };
  const Pose2 laser = pose(from.T_robot_laser, "scan->T_robot_laser");
  std::optional<Pose2> odometry, sweep;
  if (from.has_odometry != 0) odometry = pose(from.T_odom_robot, "scan->T_odom_robot");
  if (from.has_sweep_motion != 0) sweep = pose(from.T_first_last, "scan->T_first_last");
  to.ranges.assign(from.ranges, from.ranges + from.count);
  to.T_robot_laser = laser;
  to.T_odom_robot = odometry;
  to.sweep_motion = sweep;
  to.stamp = from.stamp;
  to.time_increment = from.time_increment;
  to.angle_min = from.angle_min;
  to.angle_increment = from.angle_increment;
  to.range_min = from.range_min;
  to.range_max = from.range_max;
}

void write_point(const Point2& point, double* numbers) noexcept {
  numbers[0] = point.x();
  numbers[1] = point.y();
}

slamicp_fix told(const Fix& from, std::vector<slamicp_match>& matches) {
  slamicp_fix fix = {};
  fix.stamp = from.stamp;
  write_pose(from.pose, fix.pose);
  write_pose(from.predicted, fix.predicted);
  write_covariance(from.covariance, fix.covariance);
  write_point(from.blind_direction, fix.blind_direction);
  fix.probability = from.quality.probability;
  fix.awareness = from.quality.awareness;
  fix.mean_inlier_distance = from.match.mean_inlier_distance;
  fix.stop = static_cast<int32_t>(from.stop());
  fix.usable = from.usable() ? 1 : 0;
  fix.state = static_cast<int32_t>(from.quality.state);
  fix.iterations = from.match.iterations;
  fix.inliers = from.match.inliers;
  fix.points = from.scan.in_robot.size();
  fix.outliers = std::max(from.outliers().size(), from.outliers_in_map().size());
  fix.points_in_robot = numbers_or_null<2>(from.scan.in_robot);
  fix.beams = pointer_or_null(from.scan.beams);
  fix.outlier_indices = pointer_or_null(from.outliers());
  fix.outliers_in_map = numbers_or_null<2>(from.outliers_in_map());
  fix.transformed_scan = numbers_or_null<2>(from.match.transformed_scan);
  copy_matches(from.match.matches, matches);
  fix.matches = pointer_or_null(matches);
  return fix;
}

ObstacleOptions obstacle_options_from(const slamicp_obstacle_options* options) {
  ObstacleOptions made;
  if (options == nullptr) return made;
  check_size(options, "options");
  made.min_points = options->min_points;
  made.min_far_points = options->min_far_points;
  made.range_noise = options->range_noise;
  made.min_incidence_deg = options->min_incidence_deg;
  return made;
}

slamicp_obstacle told(const Obstacle& from) noexcept {
  slamicp_obstacle obstacle = {};
  write_point(from.box.centre, obstacle.centre);
  obstacle.width = from.box.width;
  obstacle.depth = from.box.depth;
  obstacle.heading = from.box.heading;
  obstacle.distance = from.distance;
  write_point(from.nearest, obstacle.nearest);
  write_point(from.shape.centre, obstacle.shape_centre);
  obstacle.shape_width = from.shape.width;
  obstacle.shape_depth = from.shape.depth;
  obstacle.shape_heading = from.shape.heading;
  obstacle.radius = from.shape.radius;
  obstacle.shape = static_cast<int32_t>(from.shape.kind);
  obstacle.ray_class = static_cast<int32_t>(from.ray_class);
  obstacle.width_seen = from.shape.width_seen ? 1 : 0;
  obstacle.depth_seen = from.shape.depth_seen ? 1 : 0;
  obstacle.points = from.points.size();
  obstacle.point_indices = pointer_or_null(from.points);
  return obstacle;
}

}  // namespace
}  // namespace slamicp::c

using namespace slamicp;
using namespace slamicp::c;

slamicp_status slamicp_scan_init(slamicp_scan* scan, size_t size) {
  return initialize(scan, size, default_scan(), "scan");
}

slamicp_status slamicp_localizer_options_init(slamicp_localizer_options* options, size_t size) {
  return initialize(options, size, default_localizer_options(), "options");
}

slamicp_status slamicp_fix_init(slamicp_fix* fix, size_t size) { return initialize(fix, size, {}, "fix"); }

slamicp_status slamicp_obstacle_options_init(slamicp_obstacle_options* options, size_t size) {
  const ObstacleOptions defaults;
  return initialize(
      options, size,
      {sizeof *options, defaults.min_points, defaults.min_far_points, defaults.range_noise, defaults.min_incidence_deg},
      "options");
}

slamicp_status slamicp_obstacle_init(slamicp_obstacle* obstacle, size_t size) {
  return initialize(obstacle, size, {}, "obstacle");
}

slamicp_status slamicp_localizer_create(const slamicp_map* map, const slamicp_localizer_options* options,
                                        slamicp_localizer** localizer) {
  return guarded(SLAMICP_BAD_OPTIONS, [&] {
    need(localizer, "localizer");
    const LocalizerOptions chosen = localizer_options_from(read_or(options, default_localizer_options(), "options"));
    Localizer made = map == nullptr ? Localizer(chosen) : Localizer(plane_of(*map), chosen);
    *localizer = std::make_unique<slamicp_localizer>(std::move(made)).release();
  });
}

void slamicp_localizer_free(slamicp_localizer* localizer) { delete localizer; }

slamicp_status slamicp_localizer_set_pose(slamicp_localizer* localizer, const double* pose) {
  return guarded(SLAMICP_BAD_POSE, [&] {
    need(localizer, "localizer");
    localizer->localizer.set_pose(pose_from<2>(pose, "pose"));
  });
}

slamicp_status slamicp_localizer_set_map(slamicp_localizer* localizer, const slamicp_map* map) {
  return guarded(SLAMICP_BAD_STATE, [&] {
    need(localizer, "localizer");
    need(map, "map");
    localizer->localizer.set_map(plane_of(*map));
  });
}

slamicp_status slamicp_localizer_update(slamicp_localizer* localizer, const slamicp_scan* scan, slamicp_fix* fix) {
  return guarded(SLAMICP_BAD_SCAN, [&] {
    need(localizer, "localizer");
    check_size(scan, "scan");
    if (fix != nullptr) check_size(fix, "fix");
    take_scan(*scan, localizer->scan);
    localizer->has_scan = true;
    localizer->obstacles.clear();
    const Fix& found = localizer->localizer.update(localizer->scan);
    if (fix != nullptr) write(fix, told(found, localizer->matches));
  });
}

slamicp_status slamicp_localizer_fix(slamicp_localizer* localizer, slamicp_fix* fix) {
  return guarded(SLAMICP_BAD_STATE, [&] {
    need(localizer, "localizer");
    check_size(fix, "fix");
    write(fix, told(localizer->localizer.fix(), localizer->matches));
  });
}

slamicp_status slamicp_localizer_recover(slamicp_localizer* localizer, int32_t budget, int32_t* found) {
  return guarded(SLAMICP_BAD_STATE, [&] {
    need(localizer, "localizer");
    need(found, "found");
    if (budget < 1) throw Refusal(SLAMICP_BAD_OPTIONS, "budget must be at least 1; 1000 take about half a millisecond");
    *found = localizer->localizer.recover(budget) ? 1 : 0;
  });
}

slamicp_status slamicp_localizer_find_obstacles(slamicp_localizer* localizer, const slamicp_obstacle_options* options,
                                                size_t* count) {
  return guarded(SLAMICP_BAD_OPTIONS, [&] {
    need(localizer, "localizer");
    need(count, "count");
    const ObstacleOptions chosen = obstacle_options_from(options);
    if (const std::string problem = chosen.problem(); !problem.empty()) throw Refusal(SLAMICP_BAD_OPTIONS, problem);
    if (!localizer->has_scan) throw Refusal(SLAMICP_BAD_STATE, "there was no scan yet: call slamicp_localizer_update");
    localizer->obstacles = find_obstacles(localizer->localizer.fix(), localizer->scan, chosen);
    *count = localizer->obstacles.size();
  });
}

slamicp_status slamicp_localizer_obstacle(slamicp_localizer* localizer, size_t index, slamicp_obstacle* obstacle) {
  return guarded(SLAMICP_BAD_STATE, [&] {
    need(localizer, "localizer");
    check_size(obstacle, "obstacle");
    if (index >= localizer->obstacles.size())
      throw Refusal(SLAMICP_BAD_STATE, "there is no such obstacle; slamicp_localizer_find_obstacles says how many");
    write(obstacle, told(localizer->obstacles[index]));
  });
}
