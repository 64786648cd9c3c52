// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <messages.h>
#include <slamicp_node/messages.hpp>

/// From the messages of ROS 2, as idlc makes them of messages.idl, to those of the node: field by field, nothing else.
/// What goes out is in publications.cpp.
namespace slamicp::node {

Stamp stamp_of(const builtin_interfaces_msg_dds__Time_& time);
builtin_interfaces_msg_dds__Time_ to_dds(const Stamp& stamp);

Transform from_dds(const geometry_msgs_msg_dds__TransformStamped_& message);
Odometry from_dds(const nav_msgs_msg_dds__Odometry_& message);
/// Its ranges are the message's.
Scan from_dds(const sensor_msgs_msg_dds__LaserScan_& message);
Grid from_dds(const nav_msgs_msg_dds__OccupancyGrid_& message);
GivenPose from_dds(const geometry_msgs_msg_dds__PoseWithCovarianceStamped_& message);

}  // namespace slamicp::node
