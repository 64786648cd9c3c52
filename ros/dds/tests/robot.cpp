// SPDX-License-Identifier: Apache-2.0
#include "robot.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <slamicp_node/marker.hpp>

#include "agreement.hpp"
#include "expect.hpp"

namespace slamicp::dds_peer {

using node::Stamp;

std::uint32_t domain() { return static_cast<std::uint32_t>(std::atoi(std::getenv("ROS_DOMAIN_ID"))); }

namespace {

node::NodeOptions options(const Setup& setup, const SimulatedRun& run) {
  node::NodeOptions chosen;
  chosen.odometry_wait = 10.0;
  chosen.transform_tolerance = setup.transform_tolerance;
  chosen.max_range = setup.laser_max_range;
  chosen.map_file = setup.odometry_map;
  chosen.wait_for_initial_pose = !setup.odometry_map.empty();
  chosen.scan_topics.assign(setup.lasers.size(), "");
  if (setup.is_mapping) chosen.mode = "mapping";
  if (!setup.odometry_map.empty()) {
    chosen.odom_topic = "odom";
  } else {
    chosen.initial_pose_x = run.truth.front().pose.x;
    chosen.initial_pose_y = run.truth.front().pose.y;
    chosen.initial_pose_a = run.truth.front().pose.theta;
  }
  return chosen;
}

}  // namespace

Robot::Robot(const Setup& setup)
    : setup_(setup),
      has_odometry_topic_(!setup.odometry_map.empty()),
      space_(has_odometry_topic_ ? "rt/robot/" : "rt/"),
      dds_(domain()),
      run_(drive()),
      node_(options(setup, run_), has_odometry_topic_) {
  for (const Laser& laser : setup.lasers)
    scans_.push_back(dds_.writer(space_ + laser.topic, "sensor_msgs::msg::dds_::LaserScan_", sensor_data));
}

void Robot::drive_and_compare() {
  greet();
  for (int k = 0; k < setup_.scans; ++k) compare(send(static_cast<std::size_t>(k)), k);
  compare_diagnostics();
  compare_announcement();
  compare_log();
  if (has_odometry_topic_ || setup_.is_mapping) compare_map();
  std::printf("agree: %d scans, %zu outliers and %zu obstacles in all\n", setup_.scans, outliers_in_all_,
              obstacles_in_all_);
}

/// Until the node has all that it needs for scans, and both know each other's topics.
void Robot::greet() {
  std::vector<node::Transform> mounts;
  for (const Laser& each : setup_.lasers)
    mounts.push_back(transform(0.0, "base_link", each.frame, {0.0, 0.0, each.turn}));
  mount_.write(transforms_message(mounts));
  for (const node::Transform& each : mounts) node_.take_transform(each, true);
  std::string problem;
  if (has_odometry_topic_) {
    wait_for([&] { return hears_state("waiting_for_pose", [&] { clock_.write(clock_message(before)); }); },
             "waiting_for_pose");
    const Pose2& start = run_.truth.front().pose;
    const node::GivenPose pose{before, "map", {start.x, start.y, 0.0}, node::turn_by(start.theta)};
    must(node_.take_pose(pose, problem), problem);
    wait_for([&] { return hears_state("waiting_for_scan", [&] { given_pose_.write(given_pose_message(pose)); }); },
             "waiting_for_scan");
  } else if (setup_.is_mapping) {
    wait_for([&] { return hears_state("waiting_for_scan", [] {}); }, "waiting_for_scan");
  } else {
    const node::Grid grid = map_grid();
    map_.write(grid_message(grid));
    must(node_.take_map(grid, problem), problem);
    wait_for([&] { return hears_state("waiting_for_scan", [] {}); }, "waiting_for_scan");
  }
  wait_for([&] { return all_topics_are_known(); }, "all topics");
  Bytes bytes;
  while (pose_.take(bytes)) must(false, "a pose without a scan");
}

bool Robot::all_topics_are_known() const {
  for (const FastDds::Reader* const each : {&pose_, &outliers_, &inliers_, &obstacles_, &markers_})
    if (each->speakers() == 0) return false;
  if (tf_out_.speakers() < 2) return false;  // we speak there ourselves
  return std::all_of(scans_.begin(), scans_.end(), [](const auto& each) { return each.is_heard(); }) &&
         (has_odometry_topic_ ? odometry_ : tf_).is_heard();
}

bool Robot::hears_state(const std::string& state, const std::function<void()>& meanwhile) {
  meanwhile();
  Bytes bytes;
  bool heard = false;
  while (status_.take(bytes)) {
    const Status told = read_status(bytes);
    // Played time is ours.
    heard = told.state == state && (!has_odometry_topic_ || told.stamp == before);
  }
  return heard;
}

/// The scan to both nodes, with the odometry at its first and its last beam.
const node::Output& Robot::send(std::size_t number) {
  const LaserScan& scan = run_.scans[number];
  const std::size_t turn = number % setup_.lasers.size();  // whose
  const double end = scan.stamp + sweep_time(scan);
  const Pose2 T_odom_end = *scan.T_odom_robot * scan.sweep_motion.value_or(Pose2());
  const std::vector<node::Transform> wheels{transform(scan.stamp, "odom", "base_link", *scan.T_odom_robot),
                                            transform(end + 1e-3, "odom", "base_link", T_odom_end)};
  const node::Scan message = message_of(scan, setup_.lasers[turn]);
  if (has_odometry_topic_) {
    // Not the scan's own stamp: a status of the waiting node might have it.
    clock_.write(clock_message({message.stamp.nanoseconds + 1000000}));
    for (const node::Odometry& each : wheels) {
      odometry_.write(odometry_message(each));
      node_.take_odometry(each, message.stamp);
    }
  } else {
    tf_.write(transforms_message(wheels));
    for (const node::Transform& each : wheels) node_.take_transform(each, false);
  }
  scans_[turn].write(scan_message(message));
  node_.take_scan(static_cast<int>(turn), message, message.stamp);
  const node::Output* const output = node_.step(message.stamp);
  must(output != nullptr, "the node core waits");
  return *output;
}

namespace {

/// The message of a topic that has this stamp.
template <class Read, class StampOf>
auto next(const FastDds::Reader& reader, const Read& read, const StampOf& stamp_of, const Stamp& wanted,
          const std::string& what) {
  Bytes bytes;
  decltype(read(bytes)) message;
  wait_for([&] { return reader.take(bytes) && (message = read(bytes), stamp_of(message) == wanted); }, what);
  return message;
}

}  // namespace

void Robot::compare(const node::Output& output, int k) {
  const std::string at = " of scan " + std::to_string(k);
  must(output.status.usable, "not usable" + at);
  const auto stamp_of = [](const auto& message) { return message.stamp; };
  const auto next_of = [&](const FastDds::Reader& reader, const auto& read, const char* what) {
    return next(reader, read, stamp_of, output.stamp, what + at);
  };
  const auto stamp_of_first = [](const std::vector<node::Transform>& all) {  // we hear our own too
    return all.at(0).frame == "map" ? all.at(0).stamp : Stamp{-1};
  };
  must_agree(next_of(pose_, read_pose, "amcl_pose"), output, at);
  must_agree(next(tf_out_, read_transforms, stamp_of_first, output.transform_stamp, "tf" + at).at(0), output, at);
  must_agree(next_of(outliers_, read_cloud, "outliers"), output.outliers, output.scan_frame, at);
  must_agree(next_of(inliers_, read_cloud, "inliers"), output.inliers, output.scan_frame, at);
  must_agree(next_of(obstacles_, read_obstacles, "obstacles"), output, at);
  must_agree(next_of(status_, read_status, "status"), output, at);
  Bytes markers;
  wait_for([&] { return markers_.take(markers); }, "obstacle_markers" + at);
  must_agree(read_markers(markers), output, at);
  outliers_in_all_ += output.outliers.size();
  obstacles_in_all_ += output.obstacles.size();
}

void Robot::compare_diagnostics() {
  Bytes bytes;
  wait_for([&] { return diagnostics_.take(bytes); }, "diagnostics");
  const std::vector<Diagnostics> told = read_diagnostics(bytes);
  must(told.size() == 1 && !told[0].values.empty() &&
           told[0].name == (has_odometry_topic_ ? "robot/" : "") + setup_.name + ": localization",
       "other diagnostics");
}

/// What `ros2 node list` and `ros2 node info` go by: in Humble's spelling for the robot with a namespace.
void Robot::compare_announcement() {
  const int gid_size = has_odometry_topic_ ? 24 : 16;
  Bytes bytes;
  wait_for([&] { return announcement_.take(bytes); }, "ros_discovery_info");
  const Announcement told = read_announcement(bytes, gid_size);
  must(told.space == (has_odometry_topic_ ? "/robot" : "/") && told.name == setup_.name,
       "another node: " + told.space + ", " + told.name);
  Guid participant = pose_.speaker();
  constexpr std::array<std::uint8_t, 4> entity_of_participants{0, 0, 1, 0xc1};  // RTPS 2.5, table 9.1
  std::copy(entity_of_participants.begin(), entity_of_participants.end(), participant.begin() + 12);
  must(told.participant == participant, "another participant");
  must(dds_.user_data(participant) == "enclave=/;", "user data: " + dds_.user_data(participant));
  for (const FastDds::Reader* const each : {&pose_, &outliers_, &inliers_, &obstacles_, &markers_, &status_})
    must(std::count(told.writers.begin(), told.writers.end(), each->speaker()) == 1, "a writer that is not told of");
  for (const FastDds::Writer& each : scans_)
    must(std::count(told.readers.begin(), told.readers.end(), each.listener()) == 1, "a reader that is not told of");
  const bool gives_map = has_odometry_topic_ || setup_.is_mapping, takes_map = !gives_map;
  // amcl_pose, clouds, obstacles, markers, status, diagnostics, log and tf; tf, tf_static and initialpose.
  must(told.writers.size() == (gives_map ? 10U : 9U), std::to_string(told.writers.size()) + " writers");
  must(told.readers.size() == 3 + scans_.size() + (takes_map ? 1U : 0U) + (has_odometry_topic_ ? 2U : 0U),
       std::to_string(told.readers.size()) + " readers");
}

/// Its first line was written before we came to know the node.
void Robot::compare_log() {
  Bytes bytes;
  wait_for([&] { return log_.take(bytes); }, "rosout");
  const LogLine line = read_log_line(bytes);
  constexpr int info = 20;
  const std::string node = (has_odometry_topic_ ? "/robot/" : "/") + setup_.name;
  must(line.level == info && line.name == (has_odometry_topic_ ? "robot." : "") + setup_.name &&
           line.text.rfind("node " + node + ", listed as ", 0) == 0,
       "another log: " + line.name + ": " + line.text);
}

/// That of the file, published before we came to know the node; or the last one of those made on the way.
void Robot::compare_map() {
  const node::Grid* const ours = node_.new_map(Stamp::from_seconds(1e6));
  must(ours != nullptr, "the node core has no map");
  node::Grid grid;
  wait_for(
      [&] {
        Bytes bytes;
        if (!given_map_.take(bytes)) return false;
        grid = read_grid(bytes);
        return grid.cells == ours->cells || !setup_.is_mapping;
      },
      "map");
  must(grid.frame == "map" && grid.width == ours->width && grid.height == ours->height && grid.origin == ours->origin &&
           grid.cells == ours->cells && grid.resolution == static_cast<double>(static_cast<float>(ours->resolution)),
       "another map");
}

}  // namespace slamicp::dds_peer
