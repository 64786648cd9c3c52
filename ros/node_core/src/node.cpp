// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <slamicp_node/node.hpp>

#include <slamicp/error.hpp>
#include <slamicp/geometry/planar.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/occupancy_map_file.hpp>

#include "core.hpp"
#include "grids.hpp"

namespace slamicp::node {
namespace {

bool is_yaml(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  return ending == ".yaml" || ending == ".yml";
}

}  // namespace

Node::Node(const NodeOptions& options, bool clock_is_played, std::function<double()> stopwatch)
    : core_(std::make_unique<Core>(options, clock_is_played, std::move(stopwatch))) {
  const std::string& file = core_->options.map_file;
  if (file.empty()) return;
  core_->use_map(load_map(file));
  const OccupancyGrid grid =
      is_yaml(file) ? load_occupancy_map(file).grid
                    : to_occupancy_grid(core_->localizer->map()->points(), {.resolution = options.resolution});
  to_message(grid, core_->grid);
  core_->grid.frame = options.global_frame_id;
  core_->has_grid = core_->grid_is_new = true;
}

Node::~Node() = default;
Node::Node(Node&&) noexcept = default;
Node& Node::operator=(Node&&) noexcept = default;

void Node::take_transform(const Transform& transform, bool is_static) {
  const std::optional<MotionTrack::Sample> sample = core_->frames.add(transform, is_static);
  if (sample && core_->options.use_odometry && core_->options.odom_topic.empty()) core_->wheels.add(*sample);
}

void Node::take_odometry(const Odometry& odometry, Stamp now) {
  core_->note_clock(now.seconds());
  const std::optional<Pose3> pose = pose_of(odometry.translation, odometry.rotation);
  if (!pose || !core_->options.use_odometry) return;
  Pose2 T_odom_base = planar(*pose);
  const std::string child = without_slash(odometry.child), base = without_slash(core_->options.base_frame_id);
  if (!child.empty() && child != base)
    if (const std::optional<Pose3> mount = core_->frames.mount(child, base)) T_odom_base = T_odom_base * planar(*mount);
  core_->wheels.add({odometry.stamp.seconds(), T_odom_base});
}

void Node::take_scan(int topic, const Scan& scan, Stamp now) {
  const double time = now.seconds();
  core_->note_clock(time);
  const ScanQueue::Taken taken = core_->queue.add(topic, scan, time);
  if (taken == ScanQueue::Taken::again) core_->begin_again(scan.stamp.seconds());
  core_->last_scan = time;
  core_->heard_scan = true;
}

bool Node::take_map(const Grid& grid, std::string& problem) {
  if (core_->is_mapping()) {
    problem = "the node is mapping: it makes its own map";
    return false;
  }
  try {
    PointCloud2 walls = wall_points(to_occupancy(grid));
    if (walls.empty()) throw Error("the map has no wall", "map", "occupied cells are 65 and above");
    core_->use_map(PointMap2::create(std::move(walls)));
  } catch (const Error& error) {
    problem = error.what();
    return false;
  }
  core_->grid = grid;
  core_->has_grid = true;
  core_->grid_is_new = false;
  return true;
}

bool Node::take_pose(const GivenPose& given, std::string& problem) {
  const std::optional<Pose3> pose = pose_of(given.position, given.orientation);
  const std::string frame = without_slash(given.frame), wanted = without_slash(core_->options.global_frame_id);
  if (core_->is_mapping())
    problem = "the node is mapping: the first pose fixes the map's frame";
  else if (!pose)
    problem = "the pose is not finite, or its quaternion is zero";
  else if (!frame.empty() && frame != wanted)
    problem = "the pose is in '" + frame + "', not in '" + wanted + "'";
  else {
    core_->set_pose(planar(*pose));
    return true;
  }
  return false;
}

const Output* Node::step(Stamp now) {
  Core& core = *core_;
  const double time = now.seconds();
  core.note_clock(time);
  while (!core.queue.empty()) {
    const Core::Ready ready = core.ready(core.queue.front(), time);
    if (ready == Core::Ready::wait) return nullptr;
    if (ready == Core::Ready::give_up) {
      core.queue.pop();
      continue;
    }
    core.localize(core.queue.front(), time);
    core.queue.pop();
    core.has_output = true;
    Status& status = core.output.status;
    status.scans = core.queue.taken();
    status.dropped = core.queue.dropped() + core.without_frame;
    status.recoveries = core.recoveries;
    status.state = state(now);
    return &core.output;
  }
  return nullptr;
}

const Output* Node::last() const { return core_->has_output ? &core_->output : nullptr; }

const NodeOptions& Node::options() const { return core_->options; }

const Grid* Node::new_map(Stamp now) {
  Core& core = *core_;
  const double time = now.seconds();
  if (core.is_mapping() && core.keyframes != core.published_keyframes && time >= core.next_map) {
    core.published_keyframes = core.keyframes;
    core.next_map = time + core.options.map_update_interval;
    to_message(core.builder.grid(), core.grid);
    core.grid.frame = core.options.global_frame_id;
    core.grid.stamp = core.output.stamp;
    core.has_grid = core.grid_is_new = true;
  }
  if (!core.grid_is_new) return nullptr;
  core.grid_is_new = false;
  return &core.grid;
}

bool Node::save_map(const std::string& file, std::string& problem) const {
  const Core& core = *core_;
  const PointMap2::Pointer map = core.is_mapping() ? core.mapper->refined_map()
                                 : core.localizer  ? core.localizer->map()
                                                   : nullptr;
  if (!map) {
    problem = "there is no map yet";
    return false;
  }
  try {
    if (!is_yaml(file))
      slamicp::save_map(file, *map);
    else if (core.is_mapping())
      save_occupancy_map(file, core.builder.grid());
    else
      save_occupancy_map(file, to_occupancy(core.grid));
  } catch (const std::exception& error) {
    problem = error.what();
    return false;
  }
  return true;
}

}  // namespace slamicp::node
