// SPDX-License-Identifier: Apache-2.0
#include "conversions.hpp"

namespace slamicp::node {
namespace {

template <class Vector>
Position position_of(const Vector& vector) {
  return {vector.x, vector.y, vector.z};
}

Quaternion quaternion_of(const geometry_msgs_msg_dds__Quaternion_& quaternion) {
  return {quaternion.x, quaternion.y, quaternion.z, quaternion.w};
}

}  // namespace

Stamp stamp_of(const builtin_interfaces_msg_dds__Time_& time) { return Stamp::from(time.sec, time.nanosec); }

builtin_interfaces_msg_dds__Time_ to_dds(const Stamp& stamp) {
  return {static_cast<std::int32_t>(stamp.whole_seconds()), static_cast<std::uint32_t>(stamp.rest())};
}

Transform from_dds(const geometry_msgs_msg_dds__TransformStamped_& message) {
  return {stamp_of(message.header.stamp), message.header.frame_id, message.child_frame_id,
          position_of(message.transform.translation), quaternion_of(message.transform.rotation)};
}

Odometry from_dds(const nav_msgs_msg_dds__Odometry_& message) {
  return {stamp_of(message.header.stamp), message.header.frame_id, message.child_frame_id,
          position_of(message.pose.pose.position), quaternion_of(message.pose.pose.orientation)};
}

Scan from_dds(const sensor_msgs_msg_dds__LaserScan_& message) {
  Scan scan;
  scan.stamp = stamp_of(message.header.stamp);
  scan.frame = message.header.frame_id;
  scan.angle_min = message.angle_min;
  scan.angle_increment = message.angle_increment;
  scan.time_increment = message.time_increment;
  scan.scan_time = message.scan_time;
  scan.range_min = message.range_min;
  scan.range_max = message.range_max;
  scan.ranges = message.ranges._buffer;
  scan.count = message.ranges._length;
  return scan;
}

Grid from_dds(const nav_msgs_msg_dds__OccupancyGrid_& message) {
  Grid grid;
  grid.stamp = stamp_of(message.header.stamp);
  grid.frame = message.header.frame_id;
  grid.resolution = static_cast<double>(message.info.resolution);
  grid.width = static_cast<int>(message.info.width);
  grid.height = static_cast<int>(message.info.height);
  grid.origin = position_of(message.info.origin.position);
  grid.orientation = quaternion_of(message.info.origin.orientation);
  grid.cells.assign(message.data._buffer, message.data._buffer + message.data._length);
  return grid;
}

GivenPose from_dds(const geometry_msgs_msg_dds__PoseWithCovarianceStamped_& message) {
  return {stamp_of(message.header.stamp), message.header.frame_id, position_of(message.pose.pose.position),
          quaternion_of(message.pose.pose.orientation)};
}

}  // namespace slamicp::node
