// SPDX-License-Identifier: Apache-2.0
#include "conversions.hpp"

#include <slamicp_node/fields.hpp>

namespace slamicp::node {
Stamp stamp_of(const builtin_interfaces_msg_dds__Time_& time) { return Stamp::from(time.sec, time.nanosec); }

builtin_interfaces_msg_dds__Time_ to_dds(const Stamp& stamp) {
  return {static_cast<std::int32_t>(stamp.whole_seconds()), static_cast<std::uint32_t>(stamp.rest())};
}

Transform from_dds(const geometry_msgs_msg_dds__TransformStamped_& message) {
  return transform_of(message, stamp_of(message.header.stamp));
}

Odometry from_dds(const nav_msgs_msg_dds__Odometry_& message) {
  return odometry_of(message, stamp_of(message.header.stamp));
}

Scan from_dds(const sensor_msgs_msg_dds__LaserScan_& message) {
  return scan_of(message, stamp_of(message.header.stamp), message.ranges._buffer, message.ranges._length);
}

Grid from_dds(const nav_msgs_msg_dds__OccupancyGrid_& message) {
  return grid_of(message, stamp_of(message.header.stamp),
                 {message.data._buffer, message.data._buffer + message.data._length});
}

GivenPose from_dds(const geometry_msgs_msg_dds__PoseWithCovarianceStamped_& message) {
  return given_pose_of(message, stamp_of(message.header.stamp));
}

}  // namespace slamicp::node
