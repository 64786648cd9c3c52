// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nav_msgs/SetMap.h>
#include <ros/ros.h>
#include <slamicp_msgs/SaveMap.h>
#include <slamicp_node/node.hpp>
#include <std_srvs/Empty.h>
#include <string>
#include <tf2_msgs/TFMessage.h>
#include <vector>

#include "conversions.hpp"

namespace slamicp::node {

/// The node's topics and services in ROS 1. All in one thread.
class Front {
 public:
  explicit Front(const NodeOptions& options);

  /// Until ROS is shut down.
  void spin();

 private:
  void connect();
  void subscribe();
  void advertise();
  void disconnect();
  /// Steps the node as long as it has something, and publishes that.
  void pump();
  void publish(const Output& output);
  void now_and_then();
  void publish_state();
  void ask_for_map();
  void save_pose();
  void see_whether_the_master_is_another();

  bool set_map(nav_msgs::SetMap::Request& request, nav_msgs::SetMap::Response& response);
  bool save_map(slamicp_msgs::SaveMap::Request& request, slamicp_msgs::SaveMap::Response& response);
  bool publish_again(std_srvs::Empty::Request& request, std_srvs::Empty::Response& response);
  bool take(const nav_msgs::OccupancyGrid& map);
  void take(const geometry_msgs::PoseWithCovarianceStamped& pose);

  NodeOptions options_;
  ros::NodeHandle handle_;
  Node node_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Publisher tf_, pose_, outliers_, inliers_, obstacles_, markers_, status_, diagnostics_, map_;
  nav_msgs::OccupancyGrid published_map_;
  std::size_t markers_shown_ = 0;
  bool has_map_ = false;
  int master_ = 0;  // its process
  ros::WallTime next_second_;
  ros::WallTime next_saved_;
};

}  // namespace slamicp::node
