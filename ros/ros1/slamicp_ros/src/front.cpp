// SPDX-License-Identifier: Apache-2.0
#include "front.hpp"

#include <chrono>
#include <nav_msgs/GetMap.h>
#include <ros/callback_queue.h>

namespace slamicp::node {
namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Stamp now() { return stamp_of(ros::Time::now()); }

/// The master's process, by which one that was started again is told; 0: it does not answer.
int master_process() {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getPid", request, response, payload, false)) return 0;
  return payload.getType() == XmlRpc::XmlRpcValue::TypeInt ? static_cast<int>(payload) : 0;
}

}  // namespace

Front::Front(const NodeOptions& options)
    : options_(options), node_(options, ros::param::param<bool>("/use_sim_time", false), seconds) {
  has_map_ = !options.map_file.empty();
  connect();
  master_ = master_process();
}

void Front::connect() {
  advertise();
  subscribe();
}

void Front::advertise() {
  constexpr std::uint32_t queue = 100;  // a listener may be slow for a moment
  if (options_.tf_broadcast) tf_ = handle_.advertise<tf2_msgs::TFMessage>("/tf", queue);
  pose_ = handle_.advertise<geometry_msgs::PoseWithCovarianceStamped>("amcl_pose", queue, true);
  outliers_ = handle_.advertise<sensor_msgs::PointCloud2>("outliers", queue);
  inliers_ = handle_.advertise<sensor_msgs::PointCloud2>("inliers", queue);
  obstacles_ = handle_.advertise<slamicp_msgs::Obstacles>("obstacles", queue);
  markers_ = handle_.advertise<visualization_msgs::MarkerArray>("obstacle_markers", queue);
  status_ = handle_.advertise<slamicp_msgs::Status>("slamicp/status", queue);
  diagnostics_ = handle_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", queue);
  if (options_.mode == "mapping" || !options_.map_file.empty()) {
    map_ = handle_.advertise<nav_msgs::OccupancyGrid>(options_.map_topic, 1, true);
    if (!published_map_.data.empty()) map_.publish(published_map_);
  }
  services_.push_back(handle_.advertiseService("set_map", &Front::set_map, this));
  services_.push_back(handle_.advertiseService("save_map", &Front::save_map, this));
  services_.push_back(handle_.advertiseService("request_nomotion_update", &Front::publish_again, this));
}

void Front::subscribe() {
  const auto promptly = ros::TransportHints().tcpNoDelay();
  for (const bool is_static : {false, true}) {
    const boost::function<void(const tf2_msgs::TFMessage::ConstPtr&)> take_transforms =
        [this, is_static](const tf2_msgs::TFMessage::ConstPtr& message) {
          for (const geometry_msgs::TransformStamped& transform : message->transforms)
            node_.take_transform(from_ros(transform), is_static);
          pump();
        };
    subscribers_.push_back(
        handle_.subscribe<tf2_msgs::TFMessage>(is_static ? "/tf_static" : "/tf", 1000, take_transforms, {}, promptly));
  }
  if (!options_.odom_topic.empty()) {
    const boost::function<void(const nav_msgs::Odometry::ConstPtr&)> take_odometry =
        [this](const nav_msgs::Odometry::ConstPtr& message) {
          node_.take_odometry(from_ros(*message), now());
          pump();
        };
    subscribers_.push_back(
        handle_.subscribe<nav_msgs::Odometry>(options_.odom_topic, 1000, take_odometry, {}, promptly));
  }
  for (std::size_t k = 0; k < options_.scan_topics.size(); ++k) {
    const boost::function<void(const sensor_msgs::LaserScan::ConstPtr&)> take_scan =
        [this, k](const sensor_msgs::LaserScan::ConstPtr& message) {
          node_.take_scan(static_cast<int>(k), from_ros(*message), now());
          pump();
        };
    subscribers_.push_back(
        handle_.subscribe<sensor_msgs::LaserScan>(options_.scan_topics[k], 100, take_scan, {}, promptly));
  }
  const boost::function<void(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr&)> take_pose =
      [this](const geometry_msgs::PoseWithCovarianceStamped::ConstPtr& message) { take(*message); };
  subscribers_.push_back(handle_.subscribe<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 2, take_pose));
  if (options_.mode == "mapping" || !options_.map_file.empty() || !options_.use_map_topic) return;
  const boost::function<void(const nav_msgs::OccupancyGrid::ConstPtr&)> take_map =
      [this](const nav_msgs::OccupancyGrid::ConstPtr& message) {
        if (!has_map_ || !options_.first_map_only) take(*message);
      };
  subscribers_.push_back(handle_.subscribe<nav_msgs::OccupancyGrid>(options_.map_topic, 1, take_map));
}

void Front::disconnect() {
  subscribers_.clear();
  services_.clear();
  for (ros::Publisher* const each :
       {&tf_, &pose_, &outliers_, &inliers_, &obstacles_, &markers_, &status_, &diagnostics_, &map_})
    *each = ros::Publisher();
}

void Front::spin() {
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    pump();
    now_and_then();
  }
}

void Front::pump() {
  while (const Output* const output = node_.step(now())) publish(*output);
}

void Front::publish(const Output& output) {
  const std::string& frame = options_.global_frame_id;
  if (options_.tf_broadcast && output.has_transform) {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(transform_to_ros(output));
    tf_.publish(message);
  }
  pose_.publish(pose_to_ros(output, frame));
  if (outliers_.getNumSubscribers() > 0) outliers_.publish(to_ros(output.outliers, output));
  if (inliers_.getNumSubscribers() > 0) inliers_.publish(to_ros(output.inliers, output));
  if (obstacles_.getNumSubscribers() > 0) obstacles_.publish(obstacles_to_ros(output, frame));
  if (markers_.getNumSubscribers() > 0) markers_.publish(markers_to_ros(output, frame, markers_shown_));
  markers_shown_ = output.obstacles.size();
  if (status_.getNumSubscribers() > 0) status_.publish(to_ros(output.status, output.stamp, frame));
}

void Front::now_and_then() {
  if (const Grid* const grid = node_.new_map(now())) {
    published_map_ = to_ros(*grid);
    map_.publish(published_map_);
  }
  const ros::WallTime wall = ros::WallTime::now();
  if (options_.save_pose_rate > 0.0 && wall >= next_saved_) {
    next_saved_ = wall + ros::WallDuration(1.0 / options_.save_pose_rate);
    save_pose();
  }
  if (wall < next_second_) return;
  next_second_ = wall + ros::WallDuration(1.0);
  publish_state();
  ask_for_map();
  see_whether_the_master_is_another();
}

void Front::publish_state() {
  const Diagnostic diagnostic = node_.diagnostic(now());
  diagnostics_.publish(to_ros(diagnostic, ros::Time::now(), ros::this_node::getName().substr(1) + ": localization"));
  const State state = node_.state(now());
  if (state == State::localizing || state == State::mapping || state == State::recovering) return;
  Status status;
  if (const Output* const last = node_.last()) status = last->status;
  status.state = state;
  status_.publish(to_ros(status, now(), options_.global_frame_id));
  if (diagnostic.level > 0) ROS_WARN_STREAM_THROTTLE(10.0, diagnostic.message);
}

void Front::ask_for_map() {
  if (has_map_ || options_.use_map_topic || options_.mode == "mapping") return;
  if (!ros::service::exists("static_map", false)) return;
  nav_msgs::GetMap exchange;
  if (ros::service::call("static_map", exchange)) take(exchange.response.map);
}

void Front::save_pose() {
  const Output* const last = node_.last();
  if (last == nullptr || options_.mode == "mapping" || !last->status.usable) return;
  ros::param::set("~initial_pose_x", last->pose.x);
  ros::param::set("~initial_pose_y", last->pose.y);
  ros::param::set("~initial_pose_a", last->pose.theta);
}

/// A master that was started again knows no node: this one tells it anew what it takes and gives.
void Front::see_whether_the_master_is_another() {
  const int process = master_process();
  if (process == 0 || process == master_) return;
  if (master_ != 0) {
    ROS_WARN("the master was started again: registering anew");
    disconnect();
    connect();
  }
  master_ = process;
}

bool Front::take(const nav_msgs::OccupancyGrid& map) {
  std::string problem;
  if (!node_.take_map(from_ros(map), problem)) {
    ROS_ERROR_STREAM("map: " << problem);
    return false;
  }
  has_map_ = true;
  ROS_INFO("took a map of %u x %u cells", map.info.width, map.info.height);
  return true;
}

void Front::take(const geometry_msgs::PoseWithCovarianceStamped& pose) {
  std::string problem;
  if (!node_.take_pose(from_ros(pose), problem)) ROS_ERROR_STREAM("initialpose: " << problem);
}

bool Front::set_map(nav_msgs::SetMap::Request& request, nav_msgs::SetMap::Response& response) {
  response.success = take(request.map);
  if (response.success) take(request.initial_pose);
  return true;
}

bool Front::save_map(slamicp_msgs::SaveMap::Request& request, slamicp_msgs::SaveMap::Response& response) {
  response.success = node_.save_map(request.file, response.message);
  return true;
}

bool Front::publish_again(std_srvs::Empty::Request& /*request*/, std_srvs::Empty::Response& /*response*/) {
  if (const Output* const last = node_.last()) publish(*last);
  return true;
}

}  // namespace slamicp::node
