// SPDX-License-Identifier: Apache-2.0
#pragma once
// The simulated robot in ROS's messages.

#include <cmath>
#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include "simulated_robot.hpp"

namespace slamicp::drive {

inline geometry_msgs::Quaternion turn_by(double theta) {
  geometry_msgs::Quaternion quaternion;
  quaternion.z = std::sin(0.5 * theta);
  quaternion.w = std::cos(0.5 * theta);
  return quaternion;
}

inline geometry_msgs::TransformStamped transform(double stamp, const char* frame, const char* child,
                                                 const PlainPose& pose) {
  geometry_msgs::TransformStamped message;
  message.header.stamp.fromSec(stamp);
  message.header.frame_id = frame;
  message.child_frame_id = child;
  message.transform.translation.x = pose.x;
  message.transform.translation.y = pose.y;
  message.transform.rotation = turn_by(pose.theta);
  return message;
}

/// Odometry at the first beam and at the last.
inline tf2_msgs::TFMessage wheels_of(const Sweep& sweep) {
  tf2_msgs::TFMessage wheels;
  wheels.transforms.push_back(transform(sweep.stamp, "odom", "base_link", sweep.odometry));
  wheels.transforms.push_back(transform(sweep.end, "odom", "base_link", sweep.odometry_at_end));
  return wheels;
}

inline sensor_msgs::LaserScan scan_of(const Sweep& sweep) {
  sensor_msgs::LaserScan scan;
  scan.header.stamp.fromSec(sweep.stamp);
  scan.header.frame_id = "laser";
  scan.angle_min = static_cast<float>(sweep.angle_min);
  scan.angle_increment = static_cast<float>(sweep.angle_increment);
  scan.angle_max = scan.angle_min + scan.angle_increment * static_cast<float>(sweep.ranges.size() - 1);
  scan.time_increment = static_cast<float>(sweep.time_increment);
  scan.range_min = 0.1F;
  scan.range_max = static_cast<float>(sweep.range_max);
  scan.ranges = sweep.ranges;
  return scan;
}

}  // namespace slamicp::drive
