// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <slamicp_node/messages.hpp>
#include <string>
#include <vector>

#include "fast_dds.hpp"

/// ROS 2's messages in CDR, written and read field by field, in the order of ROS's .msg files: nothing here knows
/// messages.idl. Reading throws where a message is shorter or longer than it should be.
namespace slamicp::dds_peer {

Bytes clock_message(const node::Stamp& stamp);
Bytes transforms_message(const std::vector<node::Transform>& transforms);
Bytes odometry_message(const node::Odometry& odometry);
Bytes scan_message(const node::Scan& scan);
Bytes grid_message(const node::Grid& grid);
Bytes given_pose_message(const node::GivenPose& pose);

struct Pose {
  node::Stamp stamp;
  std::string frame;
  node::Position position;
  node::Quaternion orientation;
  std::array<double, 36> covariance{};
};
struct Cloud {
  node::Stamp stamp;
  std::string frame;
  std::vector<std::string> fields;
  std::vector<node::Point> points;
};
struct DrawnMarker {
  std::string frame, ns;
  std::int32_t id = 0, type = 0, action = 0;
  node::Position position, scale;
  float alpha = 0.0F;
};
struct Obstacles {
  node::Stamp stamp;
  std::vector<node::Obstacle> obstacles;
};
struct Status {
  node::Stamp stamp;
  std::string state;
  node::Status status;  // but for its state
};
struct Diagnostics {
  std::string name, message;
  std::vector<std::pair<std::string, std::string>> values;
};

struct LogLine {
  int level = 0;
  std::string name, text;
};
/// Who is who: rmw_dds_common/ParticipantEntitiesInfo
struct Announcement {
  Guid participant;
  std::string space, name;  ///< of its only node
  std::vector<Guid> readers, writers;
};

std::vector<node::Transform> read_transforms(Bytes message);
Pose read_pose(Bytes message);
Cloud read_cloud(Bytes message);
std::vector<DrawnMarker> read_markers(Bytes message);
Obstacles read_obstacles(Bytes message);
Status read_status(Bytes message);
node::Grid read_grid(Bytes message);
std::vector<Diagnostics> read_diagnostics(Bytes message);
LogLine read_log_line(Bytes message);
/// @param gid_size  24 until Humble, 16 from Iron on
Announcement read_announcement(Bytes message, int gid_size);

}  // namespace slamicp::dds_peer
