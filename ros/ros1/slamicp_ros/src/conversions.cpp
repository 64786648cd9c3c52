// SPDX-License-Identifier: Apache-2.0
#include "conversions.hpp"

#include <algorithm>
#include <cstring>
#include <slamicp_node/fields.hpp>
#include <slamicp_node/marker.hpp>

namespace slamicp::node {
namespace {

geometry_msgs::Quaternion to_ros(const Quaternion& quaternion) {
  geometry_msgs::Quaternion message;
  message.x = quaternion.x;
  message.y = quaternion.y;
  message.z = quaternion.z;
  message.w = quaternion.w;
  return message;
}

sensor_msgs::PointField field(const char* name, std::uint32_t offset) {
  sensor_msgs::PointField told;
  told.name = name;
  told.offset = offset;
  told.datatype = sensor_msgs::PointField::FLOAT32;
  told.count = 1;
  return told;
}

visualization_msgs::Marker to_ros(const Marker& drawn) {
  visualization_msgs::Marker marker;
  marker.type = drawn.is_round ? visualization_msgs::Marker::CYLINDER : visualization_msgs::Marker::CUBE;
  marker.pose.position.x = drawn.position.x;
  marker.pose.position.y = drawn.position.y;
  marker.pose.position.z = drawn.position.z;
  marker.pose.orientation = to_ros(drawn.orientation);
  marker.scale.x = drawn.scale.x;
  marker.scale.y = drawn.scale.y;
  marker.scale.z = drawn.scale.z;
  marker.color.r = drawn.red;
  marker.color.g = drawn.green;
  marker.color.b = drawn.blue;
  marker.color.a = drawn.alpha;
  return marker;
}

}  // namespace

Stamp stamp_of(const ros::Time& time) { return Stamp::from(time.sec, time.nsec); }

ros::Time to_ros(const Stamp& stamp) {
  return ros::Time(static_cast<std::uint32_t>(stamp.whole_seconds()), static_cast<std::uint32_t>(stamp.rest()));
}

Transform from_ros(const geometry_msgs::TransformStamped& message) {
  return transform_of(message, stamp_of(message.header.stamp));
}

Odometry from_ros(const nav_msgs::Odometry& message) { return odometry_of(message, stamp_of(message.header.stamp)); }

Scan from_ros(const sensor_msgs::LaserScan& message) {
  return scan_of(message, stamp_of(message.header.stamp), message.ranges.data(), message.ranges.size());
}

Grid from_ros(const nav_msgs::OccupancyGrid& message) {
  return grid_of(message, stamp_of(message.header.stamp), message.data);
}

GivenPose from_ros(const geometry_msgs::PoseWithCovarianceStamped& message) {
  return given_pose_of(message, stamp_of(message.header.stamp));
}

geometry_msgs::PoseWithCovarianceStamped pose_to_ros(const Output& output, const std::string& frame) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.stamp = to_ros(output.stamp);
  message.header.frame_id = frame;
  message.pose.pose.position.x = output.pose.x;
  message.pose.pose.position.y = output.pose.y;
  message.pose.pose.orientation = to_ros(turn_by(output.pose.theta));
  std::copy(output.covariance.begin(), output.covariance.end(), message.pose.covariance.begin());
  return message;
}

geometry_msgs::TransformStamped transform_to_ros(const Output& output) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = to_ros(output.transform_stamp);
  message.header.frame_id = output.frame;
  message.child_frame_id = output.child;
  message.transform.translation.x = output.transform.x;
  message.transform.translation.y = output.transform.y;
  message.transform.rotation = to_ros(turn_by(output.transform.theta));
  return message;
}

sensor_msgs::PointCloud2 to_ros(const std::vector<Point>& points, const Output& output) {
  static_assert(sizeof(Point) == 3 * sizeof(float), "a point is what the cloud's fields say");
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = to_ros(output.stamp);
  cloud.header.frame_id = output.scan_frame;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.fields = {field("x", 0), field("y", 4), field("z", 8)};
  cloud.point_step = sizeof(Point);
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = 1U;
  cloud.data.resize(cloud.row_step);
  if (!points.empty()) std::memcpy(cloud.data.data(), points.data(), cloud.row_step);
  return cloud;
}

slamicp_msgs::Obstacles obstacles_to_ros(const Output& output, const std::string& frame) {
  slamicp_msgs::Obstacles message;
  message.header.stamp = to_ros(output.stamp);
  message.header.frame_id = frame;
  for (const Obstacle& obstacle : output.obstacles) {
    slamicp_msgs::Obstacle told;
    fill_numbers(obstacle, told);
    told.kind = obstacle.kind;
    told.state = obstacle.state;
    message.obstacles.push_back(told);
  }
  return message;
}

visualization_msgs::MarkerArray markers_to_ros(const Output& output, const std::string& frame, std::size_t shown) {
  visualization_msgs::MarkerArray message;
  for (std::size_t k = 0; k < std::max(shown, output.obstacles.size()); ++k) {
    const bool is_there = k < output.obstacles.size();
    visualization_msgs::Marker marker =
        is_there ? to_ros(marker_of(output.obstacles[k])) : visualization_msgs::Marker();
    marker.action = is_there ? visualization_msgs::Marker::ADD : visualization_msgs::Marker::DELETE;
    marker.header.stamp = to_ros(output.stamp);
    marker.header.frame_id = frame;
    marker.ns = "obstacles";
    marker.id = static_cast<std::int32_t>(k);
    if (!is_there) marker.pose.orientation.w = 1.0;
    message.markers.push_back(marker);
  }
  return message;
}

slamicp_msgs::Status to_ros(const Status& status, const Stamp& stamp, const std::string& frame) {
  slamicp_msgs::Status message;
  message.header.stamp = to_ros(stamp);
  message.header.frame_id = frame;
  fill_numbers(status, message);
  message.state = to_string(status.state);
  message.tracking = status.tracking;
  message.stop = status.stop;
  message.carried_by = status.carried_by;
  return message;
}

nav_msgs::OccupancyGrid to_ros(const Grid& grid) {
  nav_msgs::OccupancyGrid message;
  message.header.stamp = to_ros(grid.stamp);
  message.header.frame_id = grid.frame;
  message.info.map_load_time = message.header.stamp;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.width);
  message.info.height = static_cast<std::uint32_t>(grid.height);
  message.info.origin.position.x = grid.origin.x;
  message.info.origin.position.y = grid.origin.y;
  message.info.origin.orientation.z = grid.orientation.z;
  message.info.origin.orientation.w = grid.orientation.w;
  message.data = grid.cells;
  return message;
}

diagnostic_msgs::DiagnosticArray to_ros(const Diagnostic& diagnostic, const ros::Time& now, const std::string& name) {
  diagnostic_msgs::DiagnosticStatus status;
  status.level = static_cast<std::int8_t>(diagnostic.level);
  status.name = name;
  status.hardware_id = "none";
  status.message = diagnostic.message;
  for (const auto& [key, value] : diagnostic.values) {
    diagnostic_msgs::KeyValue pair;
    pair.key = key;
    pair.value = value;
    status.values.push_back(pair);
  }
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = now;
  message.status.push_back(status);
  return message;
}

}  // namespace slamicp::node
