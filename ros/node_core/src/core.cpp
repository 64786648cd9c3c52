// SPDX-License-Identifier: Apache-2.0
#include "core.hpp"

#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/geometry/planar.hpp>
#include <slamicp/scan/laser_mount.hpp>

#include "outputs.hpp"

namespace slamicp::node {
namespace {

RangeFilter ranges_of(const NodeOptions& options) { return {options.min_range, options.max_range}; }

GridBuilderOptions builder_options(const NodeOptions& options) {
  GridBuilderOptions builder;
  builder.grid.resolution = options.resolution;
  builder.ranges = ranges_of(options);
  return builder;
}

}  // namespace

LocalizerOptions localizer_options(const NodeOptions& options) {
  LocalizerOptions localizer;
  localizer.max_correspondence_distance = options.max_correspondence_distance;
  if (options.outlier_distance > 0.0) localizer.outlier_distance = options.outlier_distance;
  if (options.obstacle_distance > 0.0) localizer.obstacle_distance = options.obstacle_distance;
  localizer.max_iterations = options.max_iterations;
  localizer.ranges = ranges_of(options);
  localizer.use_odometry = options.use_odometry;
  localizer.deskew = options.deskew;
  return localizer;
}

MapperOptions mapper_options(const NodeOptions& options) {
  MapperOptions mapper;
  mapper.initial_pose = {options.initial_pose_x, options.initial_pose_y, wrap_angle(options.initial_pose_a)};
  mapper.max_iterations = options.max_iterations;
  mapper.ranges = ranges_of(options);
  mapper.use_odometry = options.use_odometry;
  mapper.deskew = options.deskew;
  return mapper;
}

Node::Core::Core(const NodeOptions& chosen, bool played, std::function<double()> watch)
    : options(chosen),
      clock_is_played(played),
      stopwatch(std::move(watch)),
      frames(chosen.odom_frame_id, chosen.base_frame_id),
      queue(chosen.scan_topics.size()),
      builder(builder_options(chosen)),
      start{chosen.initial_pose_x, chosen.initial_pose_y, wrap_angle(chosen.initial_pose_a)},
      has_pose(!chosen.wait_for_initial_pose) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "NodeOptions");
  if (is_mapping()) mapper.emplace(mapper_options(options));
}

void Node::Core::note_clock(double now) {
  if (clock_set && now < clock - 1.0) {
    clock_went_back = true;
    queue.arrive_again(now);
    last_scan = now;
    next_map = now;
  }
  clock = now;
  clock_set = true;
}

void Node::Core::begin_again(double stamp) {
  ++restarts;
  wheels.begin_again(stamp);
  frozen.clear();
  tracker.clear();
  // A recording begins where it began. A clock that was set moves no robot.
  const bool is_recording = clock_is_played || !clock_went_back;
  clock_went_back = false;
  if (is_mapping()) {
    mapping_is_over = mapping_is_over || is_recording;
    return;
  }
  if (!localizer) return;
  localizer->set_pose(is_recording ? start : localizer->fix().pose);
  localized = localized && !is_recording;
}

void Node::Core::use_map(PointMap2::Pointer map) {
  ++maps;
  tracker.clear();
  if (localizer) {
    localizer->set_map(std::move(map));
    return;
  }
  localizer.emplace(std::move(map), localizer_options(options));
  localizer->set_pose(start);
}

void Node::Core::set_pose(const Pose2& pose) {
  if (!localized) start = pose;
  has_pose = true;
  frozen.clear();
  tracker.clear();
  if (localizer) localizer->set_pose(pose);
}

Node::Core::Ready Node::Core::ready(const WaitingScan& waiting, double now) {
  const bool time_is_up = now - waiting.arrived >= options.odometry_wait;
  if (!is_mapping() && (!localizer || !has_pose)) {
    ++without_map;
    return Ready::give_up;
  }
  if (mapping_is_over) return Ready::give_up;
  const std::optional<Pose3> mount = frames.mount(options.base_frame_id, waiting.frame);
  if (!mount) {
    missing_frame = waiting.frame;
    if (time_is_up) ++without_frame;
    return time_is_up ? Ready::give_up : Ready::wait;
  }
  missing_frame.clear();
  T_base_laser = *mount;
  waits_for_odometry = options.use_odometry && !wheels.ever();
  if (!options.use_odometry || wheels.reach(waiting.scan.stamp + sweep_time(waiting.scan))) return Ready::yes;
  if (!time_is_up) return Ready::wait;
  if (wheels.ever()) return Ready::yes;
  ++without_odometry;
  return Ready::give_up;
}

void Node::Core::set_odometry_of(LaserScan& scan) {
  if (!options.use_odometry) return;
  if (!slamicp::set_odometry(wheels.track(), scan)) ++without_odometry;
  // What wheels said before a jump and what they say now have nothing to do with each other.
  if (wheels.jumps() != odometry_jumps) scan.T_odom_robot.reset();
  odometry_jumps = wheels.jumps();
}

void Node::Core::find_transform(const WaitingScan& waiting, const Pose2& T_map_base) {
  output.frame = options.global_frame_id;
  output.transform_stamp = {waiting.stamp.nanoseconds + Stamp::from_seconds(options.transform_tolerance).nanoseconds};
  if (!options.use_odometry) {
    output.has_transform = true;
    output.child = options.base_frame_id;
    output.transform = to_message(T_map_base);
    return;
  }
  const std::optional<Pose2> T_odom_base = wheels.track().at(waiting.scan.stamp);
  output.has_transform = T_odom_base.has_value();
  if (!T_odom_base) return;
  output.child = options.odom_frame_id;
  output.transform = to_message(T_map_base * T_odom_base->inverse());
  frozen.add(waiting.scan.stamp, T_map_base, *T_odom_base);
}

void Node::Core::localize(WaitingScan& waiting, double now) {
  LaserScan& scan = waiting.scan;
  apply(laser_mount(T_base_laser), scan);
  set_odometry_of(scan);
  output.stamp = waiting.stamp;
  output.scan_frame = waiting.frame;
  output.status.waited = now - waiting.arrived;
  output.status.had_odometry = scan.T_odom_robot.has_value();
  if (is_mapping()) {
    map_it(waiting);
    return;
  }

  const double began = time();
  const Fix& fix = localizer->update(scan);
  const double found_pose = time();
  const std::span<const slamicp::Obstacle> found = finder.find(fix, scan);
  const std::span<const Track> tracks = tracker.update(fix, scan, found);
  output.status.obstacle_seconds = time() - found_pose;
  output.status.localization_seconds = found_pose - began;
  localized = true;

  tell_fix(fix, output);
  tell_points(fix, T_base_laser, output);
  tell_obstacles(found, tracks, output);
  find_transform(waiting, fix.pose);
  if (!options.recover || !localizer->recover(options.recover_places)) return;
  ++recoveries;
  tracker.clear();
}

void Node::Core::map_it(WaitingScan& waiting) {
  const double began = time();
  const Fix& fix = mapper->add(waiting.scan);
  output.status.localization_seconds = time() - began;
  output.status.obstacle_seconds = 0.0;
  tell_fix(fix, output);
  tell_points(fix, T_base_laser, output);
  output.obstacles.clear();
  find_transform(waiting, fix.pose);
  if (mapper->keyframes() == keyframes) return;
  keyframes = mapper->keyframes();
  builder.add(fix.scan.in_robot, planar(T_base_laser).translation(), fix.pose);
}

}  // namespace slamicp::node
