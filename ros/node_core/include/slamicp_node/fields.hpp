// SPDX-License-Identifier: Apache-2.0
#pragma once
// C++17: fronts whose headers know no C++20 include this.

#include <slamicp_node/messages.hpp>

/// The fields that messages of ROS 1 and of ROS 2 have by the same names, in whatever structs. Stamps, texts and lists,
/// which they have differently, are the fronts' own.
namespace slamicp::node {

template <class Vector>
Position position_of(const Vector& vector) {
  return {vector.x, vector.y, vector.z};
}

template <class Turn>
Quaternion quaternion_of(const Turn& turn) {
  return {turn.x, turn.y, turn.z, turn.w};
}

template <class Message>
Transform transform_of(const Message& message, const Stamp& stamp) {
  return {stamp, message.header.frame_id, message.child_frame_id, position_of(message.transform.translation),
          quaternion_of(message.transform.rotation)};
}

template <class Message>
Odometry odometry_of(const Message& message, const Stamp& stamp) {
  return {stamp, message.header.frame_id, message.child_frame_id, position_of(message.pose.pose.position),
          quaternion_of(message.pose.pose.orientation)};
}

template <class Message>
GivenPose given_pose_of(const Message& message, const Stamp& stamp) {
  return {stamp, message.header.frame_id, position_of(message.pose.pose.position),
          quaternion_of(message.pose.pose.orientation)};
}

/// @param ranges  the message's: they stay its own
template <class Message>
Scan scan_of(const Message& message, const Stamp& stamp, const float* ranges, std::size_t count) {
  Scan scan;
  scan.stamp = stamp;
  scan.frame = message.header.frame_id;
  scan.angle_min = message.angle_min;
  scan.angle_increment = message.angle_increment;
  scan.time_increment = message.time_increment;
  scan.scan_time = message.scan_time;
  scan.range_min = message.range_min;
  scan.range_max = message.range_max;
  scan.ranges = ranges;
  scan.count = count;
  return scan;
}

template <class Message>
Grid grid_of(const Message& message, const Stamp& stamp, std::vector<std::int8_t> cells) {
  Grid grid;
  grid.stamp = stamp;
  grid.frame = message.header.frame_id;
  grid.resolution = static_cast<double>(message.info.resolution);
  grid.width = static_cast<int>(message.info.width);
  grid.height = static_cast<int>(message.info.height);
  grid.origin = position_of(message.info.origin.position);
  grid.orientation = quaternion_of(message.info.origin.orientation);
  grid.cells = std::move(cells);
  return grid;
}

/// All but its kind and state.
template <class Message>
void fill_numbers(const Obstacle& obstacle, Message& message) {
  message.id = obstacle.id;
  message.x = obstacle.x;
  message.y = obstacle.y;
  message.heading = obstacle.heading;
  message.width = obstacle.width;
  message.depth = obstacle.depth;
  message.radius = obstacle.radius;
  message.velocity_x = obstacle.velocity_x;
  message.velocity_y = obstacle.velocity_y;
  message.distance = obstacle.distance;
  message.points = obstacle.points;
}

/// All but its header, state, tracking, stop and carried_by.
template <class Message>
void fill_numbers(const Status& status, Message& message) {
  message.usable = status.usable;
  message.probability = status.probability;
  message.awareness = status.awareness;
  message.blind = status.blind;
  message.blind_x = status.blind_x;
  message.blind_y = status.blind_y;
  message.points = status.points;
  message.inliers = status.inliers;
  message.outliers = status.outliers;
  message.iterations = status.iterations;
  message.localization_seconds = status.localization_seconds;
  message.obstacle_seconds = status.obstacle_seconds;
  message.waited = status.waited;
  message.had_odometry = status.had_odometry;
  message.scans = status.scans;
  message.dropped = status.dropped;
  message.recoveries = status.recoveries;
}

}  // namespace slamicp::node
