// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <slamicp_msgs/Obstacles.h>
#include <slamicp_msgs/Status.h>
#include <slamicp_node/messages.hpp>
#include <string>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

/// Between the messages of ROS and those of the node: field by field, nothing else.
namespace slamicp::node {

Stamp stamp_of(const ros::Time& time);
ros::Time to_ros(const Stamp& stamp);

Transform from_ros(const geometry_msgs::TransformStamped& message);
Odometry from_ros(const nav_msgs::Odometry& message);
/// Its ranges are the message's.
Scan from_ros(const sensor_msgs::LaserScan& message);
Grid from_ros(const nav_msgs::OccupancyGrid& message);
GivenPose from_ros(const geometry_msgs::PoseWithCovarianceStamped& message);

geometry_msgs::PoseWithCovarianceStamped pose_to_ros(const Output& output, const std::string& frame);
geometry_msgs::TransformStamped transform_to_ros(const Output& output);
sensor_msgs::PointCloud2 to_ros(const std::vector<Point>& points, const Output& output);
slamicp_msgs::Obstacles obstacles_to_ros(const Output& output, const std::string& frame);
/// @param shown  how many markers the last message had: those that are no more are deleted
visualization_msgs::MarkerArray markers_to_ros(const Output& output, const std::string& frame, std::size_t shown);
slamicp_msgs::Status to_ros(const Status& status, const Stamp& stamp, const std::string& frame);
nav_msgs::OccupancyGrid to_ros(const Grid& grid);
diagnostic_msgs::DiagnosticArray to_ros(const Diagnostic& diagnostic, const ros::Time& now, const std::string& name);

}  // namespace slamicp::node
