// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/geometry/pose.hpp>
#include <slamicp/scan/laser_scan.hpp>

#include "io/recording.hpp"

/// The ROS messages that a log of scans is made of. One description of each serves ROS 1 and ROS 2: the fields are the
/// same, but for the header's sequence number.
namespace slamicp::ros {

struct Header {
  double stamp = 0.0;  ///< [s]
  std::string frame;
};

/// sensor_msgs/LaserScan
struct LaserScan {
  Header header;
  slamicp::LaserScan scan;  ///< ranges, angles, limits, stamp, time_increment
  double angle_max = 0.0;   ///< [rad]
  double scan_time = 0.0;   ///< between sweeps [s]
};

/// nav_msgs/Odometry
struct Odometry {
  Header header;
  std::string child_frame;
  Pose3 pose;  ///< T_header.frame_child_frame
};

/// geometry_msgs/TransformStamped, of tf2_msgs/TFMessage and tf/tfMessage
struct Transform {
  Header header;
  std::string child_frame;
  Pose3 pose;  ///< T_header.frame_child_frame
};

/// sensor_msgs/PointCloud2
struct PointCloud {
  Header header;
  PointCloud3 points;  ///< those that are finite; z = 0 where it has none
};

/// Each throws Error, with `where`, if the body is cut or absurd.
LaserScan read_laser_scan(Serialization serialization, std::string_view body, const std::string& where);
Odometry read_odometry(Serialization serialization, std::string_view body, const std::string& where);
std::vector<Transform> read_transforms(Serialization serialization, std::string_view body, const std::string& where);
PointCloud read_point_cloud(Serialization serialization, std::string_view body, const std::string& where);

}  // namespace slamicp::ros
