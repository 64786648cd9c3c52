// SPDX-License-Identifier: Apache-2.0
// slamicp_dds_peer WHAT: a simulated robot that speaks Fast DDS, in ROS_DOMAIN_ID.
//   start      where the robot starts in the map: x y theta
//   map FILE   writes the map
//   tf         gives map, tf and scans, and hears what slamicp_dds says of them
//   odom FILE  gives the clock, odometry, a first pose and scans in namespace /robot; the node has the map FILE
//   lasers     as tf, with two lasers
//   amcl       as tf; the node has amcl's name and the parameters of dds_test.py's file for nav2's
//   mapping    as tf, without a map: hears the one that the node makes
//   lesser     gives tf and a map with less than ROS 2 gives: the node must not hear them
// All but the last hold every word of the node against slamicp::node_core in this process, which is given the same
// messages.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numbers>
#include <slamicp_node/marker.hpp>
#include <slamicp_node/node.hpp>
#include <stdexcept>
#include <thread>

#include <slamicp/io/map_file.hpp>
#include <slamicp/map/occupancy_grid.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "cdr.hpp"
#include "fast_dds.hpp"
#include "room.hpp"

namespace slamicp::dds_peer {
namespace {

using node::room;
using node::Stamp;

constexpr Stamp before{999500000000};  // the first scan

/// What the map does not have stands beside the way.
SimulatedRun drive() {
  World world = room();
  world.pillars.push_back({{6.0, 2.5}, 0.2});
  DriveOptions options;
  options.speed = 0.5;
  options.lidar.beams = 541;
  options.lidar.angle_increment = 270.0 / 540.0 * std::numbers::pi / 180.0;
  options.lidar.angle_min = -135.0 * std::numbers::pi / 180.0;
  options.lidar.rate = 10.0;
  options.lidar.sweep_time = 0.025;
  const std::vector<Point2> way{{2.0, 3.0}, {5.0, 4.0}, {9.5, 4.0}, {10.5, 2.5}};
  SimulatedRun run = simulate_drive(world, way, options);
  for (LaserScan& scan : run.scans) scan.stamp += 1000.0;
  return run;
}

PointCloud2 wall_samples() {
  Random random(1);
  return sample_map(room(), 0.02, 0.0, random);
}

node::Grid map_grid() {
  const OccupancyGrid cells = to_occupancy_grid(wall_samples(), {.resolution = 0.05, .origin = {0.025, 0.025, 0.0}});
  node::Grid grid;
  grid.frame = "map";
  grid.resolution = static_cast<double>(0.05F);  // as the message has it
  grid.width = cells.width;
  grid.height = cells.height;
  grid.origin = {cells.T_map_grid.x, cells.T_map_grid.y, 0.0};
  for (const CellState cell : cells.cells)
    grid.cells.push_back(cell == CellState::occupied ? std::int8_t{100}
                         : cell == CellState::free   ? std::int8_t{0}
                                                     : std::int8_t{-1});
  return grid;
}

node::Transform transform(double stamp, const std::string& frame, const std::string& child, const Pose2& pose) {
  return {Stamp::from_seconds(stamp), frame, child, {pose.x, pose.y, 0.0}, node::turn_by(pose.theta)};
}

/// Of a laser that sits turned by so much in the robot's middle, and sees what the simulated one sees.
struct Laser {
  std::string topic, frame;
  double turn = 0.0;  // [rad]
};

node::Scan message_of(const LaserScan& scan, const Laser& laser) {
  node::Scan message;
  message.stamp = Stamp::from_seconds(scan.stamp);
  message.frame = laser.frame;
  message.angle_min = static_cast<float>(scan.angle_min - laser.turn);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  message.time_increment = static_cast<float>(scan.time_increment);
  message.range_min = 0.1F;
  message.range_max = 30.0F;
  message.ranges = scan.ranges.data();
  message.count = scan.ranges.size();
  return message;
}

void must(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

bool operator==(const node::Position& a, const node::Position& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool operator==(const node::Quaternion& a, const node::Quaternion& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}
bool operator==(const Stamp& a, const Stamp& b) { return a.nanoseconds == b.nanoseconds; }
bool same(const std::vector<node::Point>& a, const std::vector<node::Point>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(node::Point)) == 0);
}

template <class Ready>
void wait_for(const Ready& ready, const std::string& what) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point until = Clock::now() + std::chrono::seconds(60);
  while (!ready()) {
    must(Clock::now() < until, "nobody says: " + what);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::uint32_t domain() { return static_cast<std::uint32_t>(std::atoi(std::getenv("ROS_DOMAIN_ID"))); }

/// How a robot differs from one that gives tf, a map and the scans of one laser.
struct Setup {
  int scans = 30;
  std::string odometry_map = {};  // a file: in namespace /robot, with odometry by topic and this map
  std::vector<Laser> lasers = {{"scan", "laser"}};
  bool is_mapping = false;
  std::string name = "slamicp";                             // the node's
  double transform_tolerance = 0.1, laser_max_range = 1e9;  // and what it was given
};

class Robot {
 public:
  explicit Robot(const Setup& setup)
      : setup_(setup),
        has_odometry_topic_(!setup.odometry_map.empty()),
        space_(has_odometry_topic_ ? "rt/robot/" : "rt/"),
        dds_(domain()),
        run_(drive()),
        node_(options(setup, run_), has_odometry_topic_) {
    for (const Laser& laser : setup.lasers)
      scans_.push_back(dds_.writer(space_ + laser.topic, "sensor_msgs::msg::dds_::LaserScan_", sensor_data));
  }

  void drive_and_compare() {
    greet();
    for (int k = 0; k < setup_.scans; ++k) compare(send(static_cast<std::size_t>(k)), k);
    compare_diagnostics();
    compare_announcement();
    compare_log();
    if (has_odometry_topic_ || setup_.is_mapping) compare_map();
    std::printf("agree: %d scans, %zu outliers and %zu obstacles in all\n", setup_.scans, outliers_in_all_,
                obstacles_in_all_);
  }

 private:
  static node::NodeOptions options(const Setup& setup, const SimulatedRun& run) {
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

  /// Until the node has all that it needs for scans, and both know each other's topics.
  void greet() {
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
    wait_for(
        [&] {
          const bool hears_all = pose_.speakers() > 0 && outliers_.speakers() > 0 && inliers_.speakers() > 0 &&
                                 obstacles_.speakers() > 0 && markers_.speakers() > 0 && tf_out_.speakers() > 1;
          return hears_all &&
                 std::all_of(scans_.begin(), scans_.end(), [](const auto& each) { return each.is_heard(); }) &&
                 (has_odometry_topic_ ? odometry_ : tf_).is_heard();
        },
        "all topics");
    Bytes bytes;
    while (pose_.take(bytes)) must(false, "a pose without a scan");
  }

  bool hears_state(const std::string& state, const std::function<void()>& meanwhile) {
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
  const node::Output& send(std::size_t number) {
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

  /// The message of a topic that has this stamp.
  template <class Read, class StampOf>
  auto next(const FastDds::Reader& reader, const Read& read, const StampOf& stamp_of, const Stamp& wanted,
            const std::string& what) {
    Bytes bytes;
    decltype(read(bytes)) message;
    wait_for([&] { return reader.take(bytes) && (message = read(bytes), stamp_of(message) == wanted); }, what);
    return message;
  }

  void compare(const node::Output& output, int k) {
    const std::string at = " of scan " + std::to_string(k);
    const auto stamp_of = [](const auto& message) { return message.stamp; };
    const Pose pose = next(pose_, read_pose, stamp_of, output.stamp, "amcl_pose" + at);
    must(pose.frame == "map" && pose.position == node::Position{output.pose.x, output.pose.y, 0.0} &&
             pose.orientation == node::turn_by(output.pose.theta),
         "another pose" + at);
    must(pose.covariance == output.covariance, "another covariance" + at);
    must(output.status.usable, "not usable" + at);

    const auto stamp_of_first = [](const std::vector<node::Transform>& all) {  // we hear our own too
      return all.at(0).frame == "map" ? all.at(0).stamp : Stamp{-1};
    };
    const node::Transform tf = next(tf_out_, read_transforms, stamp_of_first, output.transform_stamp, "tf" + at).at(0);
    must(tf.frame == "map" && tf.child == "odom" &&
             tf.translation == node::Position{output.transform.x, output.transform.y, 0.0} &&
             tf.rotation == node::turn_by(output.transform.theta),
         "another transform" + at);

    for (const bool is_outliers : {true, false}) {
      const Cloud cloud = next(is_outliers ? outliers_ : inliers_, read_cloud, stamp_of, output.stamp, "cloud" + at);
      must(cloud.frame == output.scan_frame && cloud.fields == std::vector<std::string>{"x@0", "y@4", "z@8"},
           "a cloud's fields");
      must(same(cloud.points, is_outliers ? output.outliers : output.inliers), "another cloud" + at);
    }
    outliers_in_all_ += output.outliers.size();

    const Obstacles told = next(obstacles_, read_obstacles, stamp_of, output.stamp, "obstacles" + at);
    must(told.obstacles.size() == output.obstacles.size(), "other obstacles" + at);
    for (std::size_t i = 0; i < told.obstacles.size(); ++i) {
      const node::Obstacle &a = told.obstacles[i], &b = output.obstacles[i];
      must(a.id == b.id && a.kind == b.kind && a.state == b.state && a.x == b.x && a.y == b.y &&
               a.heading == b.heading && a.width == b.width && a.depth == b.depth && a.radius == b.radius &&
               a.velocity_x == b.velocity_x && a.velocity_y == b.velocity_y && a.distance == b.distance &&
               a.points == b.points,
           "another obstacle" + at);
    }
    obstacles_in_all_ += told.obstacles.size();
    compare_markers(output, at);

    const auto [stamp, state, status] = next(status_, read_status, stamp_of, output.stamp, "status" + at);
    const node::Status& ours = output.status;
    must(state == node::to_string(ours.state) && status.tracking == ours.tracking && status.stop == ours.stop &&
             status.usable == ours.usable && status.probability == ours.probability &&
             status.awareness == ours.awareness && status.blind == ours.blind && status.blind_x == ours.blind_x &&
             status.blind_y == ours.blind_y && status.carried_by == ours.carried_by && status.points == ours.points &&
             status.inliers == ours.inliers && status.outliers == ours.outliers &&
             status.iterations == ours.iterations && status.had_odometry == ours.had_odometry &&
             status.scans == ours.scans && status.dropped == 0 && status.recoveries == ours.recoveries,
         "another status" + at + ": " + state + ", " + status.tracking + ", " + status.stop + ", " + status.carried_by +
             (status.had_odometry ? ", with" : ", without") + " odometry, " + std::to_string(status.inliers) +
             " inliers, " + std::to_string(status.scans) + " scans, " + std::to_string(status.dropped) +
             " dropped; not " + node::to_string(ours.state) + ", " + ours.tracking + ", " + ours.stop + ", " +
             std::to_string(ours.inliers));
    must(status.localization_seconds > 0.0, "no stopwatch");
  }

  void compare_markers(const node::Output& output, const std::string& at) {
    Bytes bytes;
    wait_for([&] { return markers_.take(bytes); }, "obstacle_markers" + at);
    const std::vector<DrawnMarker> drawn = read_markers(bytes);
    must(drawn.size() >= output.obstacles.size(), "too few markers" + at);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      constexpr std::int32_t add = 0, remove = 2, cube = 1, cylinder = 3;
      must(drawn[i].ns == "obstacles" && drawn[i].id == static_cast<std::int32_t>(i) && drawn[i].frame == "map",
           "another marker" + at);
      const bool is_there = i < output.obstacles.size();
      must(drawn[i].action == (is_there ? add : remove), "a marker's action" + at);
      if (!is_there) continue;
      const node::Marker marker = node::marker_of(output.obstacles[i]);
      must(drawn[i].type == (marker.is_round ? cylinder : cube) && drawn[i].position == marker.position &&
               drawn[i].scale == marker.scale && drawn[i].alpha == marker.alpha,
           "another marker" + at);
    }
  }

  void compare_diagnostics() {
    Bytes bytes;
    wait_for([&] { return diagnostics_.take(bytes); }, "diagnostics");
    const std::vector<Diagnostics> told = read_diagnostics(bytes);
    must(told.size() == 1 && !told[0].values.empty() &&
             told[0].name == (has_odometry_topic_ ? "robot/" : "") + setup_.name + ": localization",
         "other diagnostics");
  }

  /// What `ros2 node list` and `ros2 node info` go by: in Humble's spelling for the robot with a namespace.
  void compare_announcement() {
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
  void compare_log() {
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
  void compare_map() {
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
    must(grid.frame == "map" && grid.width == ours->width && grid.height == ours->height &&
             grid.origin == ours->origin && grid.cells == ours->cells &&
             grid.resolution == static_cast<double>(static_cast<float>(ours->resolution)),
         "another map");
  }

  static constexpr Quality sensor_data{false, false, 5}, motion{true, false, 100}, latched{true, true, 1};
  static constexpr Quality usual{true, false, 200};

  Setup setup_;
  bool has_odometry_topic_;
  std::string space_;
  FastDds dds_;
  SimulatedRun run_;
  node::Node node_;
  std::size_t outliers_in_all_ = 0, obstacles_in_all_ = 0;

  FastDds::Writer clock_ = dds_.writer("rt/clock", "rosgraph_msgs::msg::dds_::Clock_", sensor_data);
  FastDds::Writer mount_ = dds_.writer("rt/tf_static", "tf2_msgs::msg::dds_::TFMessage_", latched);
  FastDds::Writer tf_ = dds_.writer("rt/tf", "tf2_msgs::msg::dds_::TFMessage_", motion);
  FastDds::Writer odometry_ = dds_.writer(space_ + "odom", "nav_msgs::msg::dds_::Odometry_", motion);
  std::vector<FastDds::Writer> scans_;
  FastDds::Writer map_ = dds_.writer("rt/map", "nav_msgs::msg::dds_::OccupancyGrid_", latched);
  FastDds::Writer given_pose_ =
      dds_.writer(space_ + "initialpose", "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_", usual);
  FastDds::Reader pose_ =
      dds_.reader(space_ + "amcl_pose", "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_", latched);
  FastDds::Reader tf_out_ = dds_.reader("rt/tf", "tf2_msgs::msg::dds_::TFMessage_", motion);
  FastDds::Reader outliers_ = dds_.reader(space_ + "outliers", "sensor_msgs::msg::dds_::PointCloud2_", sensor_data);
  FastDds::Reader inliers_ = dds_.reader(space_ + "inliers", "sensor_msgs::msg::dds_::PointCloud2_", usual);
  FastDds::Reader obstacles_ = dds_.reader(space_ + "obstacles", "slamicp_msgs::msg::dds_::Obstacles_", usual);
  FastDds::Reader markers_ =
      dds_.reader(space_ + "obstacle_markers", "visualization_msgs::msg::dds_::MarkerArray_", usual);
  FastDds::Reader status_ = dds_.reader(space_ + "slamicp/status", "slamicp_msgs::msg::dds_::Status_", usual);
  FastDds::Reader diagnostics_ = dds_.reader("rt/diagnostics", "diagnostic_msgs::msg::dds_::DiagnosticArray_", usual);
  FastDds::Reader given_map_ = dds_.reader(space_ + "map", "nav_msgs::msg::dds_::OccupancyGrid_", latched);
  FastDds::Reader log_ = dds_.reader("rt/rosout", "rcl_interfaces::msg::dds_::Log_", {true, true, 100});
  FastDds::Reader announcement_ =
      dds_.reader("ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_", latched);
};

/// The node must go on waiting for a map that is offered all the time, but to those alone who were there before.
void offer_less() {
  FastDds dds(domain());
  const FastDds::Writer tf = dds.writer("rt/tf", "tf2_msgs::msg::dds_::TFMessage_", {false, false, 10});
  const FastDds::Writer map = dds.writer("rt/map", "nav_msgs::msg::dds_::OccupancyGrid_", {true, false, 1});
  const FastDds::Reader status =
      dds.reader("rt/slamicp/status", "slamicp_msgs::msg::dds_::Status_", {true, false, 200});
  for (int heard = 0; heard < 2; ++heard) {
    Bytes bytes;
    wait_for(
        [&] {
          map.write(grid_message(map_grid()));
          return status.take(bytes);
        },
        "status");
    must(read_status(bytes).state == "waiting_for_map", read_status(bytes).state);
  }
  must(!tf.is_heard() && !map.is_heard(), "the node hears what promises less than it asks for");
}

int run(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "start") {
    const Pose2 pose = drive().truth.front().pose;
    std::printf("%.17g %.17g %.17g\n", pose.x, pose.y, pose.theta);
  } else if (what == "map" && argc == 3) {
    save_map(argv[2], *PointMap2::create(wall_samples()));
  } else if (what == "tf") {
    Robot({.scans = 100}).drive_and_compare();
  } else if (what == "odom" && argc == 3) {
    Robot({.scans = 100, .odometry_map = argv[2], .name = "localization"}).drive_and_compare();
  } else if (what == "lasers") {
    Robot({.lasers = {{"front", "laser"}, {"back", "laser_behind", 2.5}}}).drive_and_compare();
  } else if (what == "amcl") {
    Robot({.name = "amcl", .transform_tolerance = 1.0, .laser_max_range = 100.0}).drive_and_compare();
  } else if (what == "mapping") {
    Robot({.is_mapping = true}).drive_and_compare();
  } else if (what == "lesser") {
    offer_less();
  } else {
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace slamicp::dds_peer

int main(int argc, char** argv) {
  try {
    return slamicp::dds_peer::run(argc, argv);
  } catch (const std::exception& problem) {
    std::printf("%s\n", problem.what());
    return 1;
  }
}
