// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <slamicp_node/node.hpp>
#include <string>
#include <vector>

#include "cdr.hpp"
#include "fast_dds.hpp"
#include "simulated.hpp"

namespace slamicp::dds_peer {

/// ROS_DOMAIN_ID
std::uint32_t domain();

/// How a robot differs from one that gives tf, a map and the scans of one laser.
struct Setup {
  int scans = 30;
  std::string odometry_map = {};  // a file: in namespace /robot, with odometry by topic and this map
  std::vector<Laser> lasers = {{"scan", "laser"}};
  bool is_mapping = false;
  std::string name = "slamicp";                             // the node's
  double transform_tolerance = 0.1, laser_max_range = 1e9;  // and what it was given
};

/// A simulated robot that speaks Fast DDS. It holds every word of slamicp_dds against slamicp::node_core in this
/// process, which is given the same messages.
class Robot {
 public:
  explicit Robot(const Setup& setup);
  void drive_and_compare();

 private:
  void greet();
  bool hears_state(const std::string& state, const std::function<void()>& meanwhile);
  bool all_topics_are_known() const;
  const node::Output& send(std::size_t number);
  void compare(const node::Output& output, int k);
  void compare_diagnostics();
  void compare_announcement();
  void compare_log();
  void compare_map();

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

}  // namespace slamicp::dds_peer
