// SPDX-License-Identifier: Apache-2.0
#include "cdr.hpp"

#include <cstring>
#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <stdexcept>

namespace slamicp::dds_peer {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

class Out {
 public:
  Out() : cdr_(buffer_, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR) { cdr_.serialize_encapsulation(); }

  template <class Field>
  Out& operator<<(const Field& field) {
    cdr_ << field;
    return *this;
  }
  Out& operator<<(const node::Stamp& stamp) {
    return *this << static_cast<std::int32_t>(stamp.whole_seconds()) << static_cast<std::uint32_t>(stamp.rest());
  }
  Out& operator<<(const node::Position& place) { return *this << place.x << place.y << place.z; }
  Out& operator<<(const node::Quaternion& turn) { return *this << turn.x << turn.y << turn.z << turn.w; }
  Bytes message() const { return {buffer_.getBuffer(), buffer_.getBuffer() + cdr_.getSerializedDataLength()}; }

 private:
  FastBuffer buffer_;
  Cdr cdr_;
};

class In {
 public:
  explicit In(Bytes& message)
      : size_(message.size()),
        buffer_(message.data(), message.size()),
        cdr_(buffer_, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR) {
    cdr_.read_encapsulation();
  }

  template <class Field>
  In& operator>>(Field& field) {
    cdr_ >> field;
    return *this;
  }
  In& operator>>(node::Stamp& stamp) {
    const auto seconds = take<std::int32_t>();
    stamp = node::Stamp::from(seconds, take<std::uint32_t>());
    return *this;
  }
  In& operator>>(node::Position& place) { return *this >> place.x >> place.y >> place.z; }
  In& operator>>(node::Quaternion& turn) { return *this >> turn.x >> turn.y >> turn.z >> turn.w; }
  template <class Field>
  Field take() {
    Field field{};
    *this >> field;
    return field;
  }
  /// Up to three bytes fill the last word.
  void end() const {
    if (cdr_.getSerializedDataLength() + 3 < size_)
      throw std::runtime_error("there is more in it than there should be");
  }

 private:
  std::size_t size_;
  FastBuffer buffer_;
  Cdr cdr_;
};

node::Transform read_transform(In& in) {
  node::Transform transform;
  in >> transform.stamp >> transform.frame >> transform.child >> transform.translation >> transform.rotation;
  return transform;
}

Guid read_guid(In& in, int size) {
  Guid guid;
  for (int k = 0; k < size; ++k) {
    const auto byte = in.take<std::uint8_t>();
    if (k < 16)
      guid[static_cast<std::size_t>(k)] = byte;
    else if (byte != 0)
      throw std::runtime_error("an identity that does not end with zeros");
  }
  return guid;
}

std::vector<Guid> read_guids(In& in, int size) {
  std::vector<Guid> guids(in.take<std::uint32_t>());
  for (Guid& each : guids) each = read_guid(in, size);
  return guids;
}

DrawnMarker read_marker(In& in) {
  DrawnMarker marker;
  in.take<node::Stamp>();
  in >> marker.frame >> marker.ns >> marker.id >> marker.type >> marker.action >> marker.position;
  in.take<node::Quaternion>();
  in >> marker.scale;
  for (int k = 0; k < 3; ++k) in.take<float>();
  in >> marker.alpha;
  in.take<node::Stamp>();  // lifetime
  in.take<bool>();
  if (in.take<std::uint32_t>() != 0 || in.take<std::uint32_t>() != 0)
    throw std::runtime_error("points or colours in a marker");
  in.take<std::string>();  // texture_resource, texture
  in.take<node::Stamp>();
  in.take<std::string>();
  in.take<std::string>();
  in.take<std::vector<std::uint8_t>>();
  if (in.take<std::uint32_t>() != 0) throw std::runtime_error("a texture's places in a marker");
  in.take<std::string>();  // text, mesh_resource, mesh_file
  in.take<std::string>();
  in.take<std::string>();
  in.take<std::vector<std::uint8_t>>();
  in.take<bool>();
  return marker;
}

}  // namespace

Bytes clock_message(const node::Stamp& stamp) { return (Out() << stamp).message(); }

Bytes transforms_message(const std::vector<node::Transform>& transforms) {
  Out out;
  out << static_cast<std::uint32_t>(transforms.size());
  for (const node::Transform& each : transforms)
    out << each.stamp << each.frame << each.child << each.translation << each.rotation;
  return out.message();
}

Bytes odometry_message(const node::Odometry& odometry) {
  const std::array<double, 36> unknown{};
  const node::Position still;
  return (Out() << odometry.stamp << odometry.frame << odometry.child << odometry.translation << odometry.rotation
                << unknown << still << still << unknown)
      .message();
}

Bytes scan_message(const node::Scan& scan) {
  const float angle_max = scan.angle_min + scan.angle_increment * static_cast<float>(scan.count - 1);
  return (Out() << scan.stamp << scan.frame << scan.angle_min << angle_max << scan.angle_increment
                << scan.time_increment << scan.scan_time << scan.range_min << scan.range_max
                << std::vector<float>(scan.ranges, scan.ranges + scan.count) << std::vector<float>())
      .message();
}

Bytes grid_message(const node::Grid& grid) {
  return (Out() << grid.stamp << grid.frame << grid.stamp << static_cast<float>(grid.resolution)
                << static_cast<std::uint32_t>(grid.width) << static_cast<std::uint32_t>(grid.height) << grid.origin
                << grid.orientation << std::vector<std::uint8_t>(grid.cells.begin(), grid.cells.end()))
      .message();
}

Bytes given_pose_message(const node::GivenPose& pose) {
  return (Out() << pose.stamp << pose.frame << pose.position << pose.orientation << std::array<double, 36>()).message();
}

std::vector<node::Transform> read_transforms(Bytes message) {
  In in(message);
  std::vector<node::Transform> transforms(in.take<std::uint32_t>());
  for (node::Transform& each : transforms) each = read_transform(in);
  in.end();
  return transforms;
}

Pose read_pose(Bytes message) {
  In in(message);
  Pose pose;
  in >> pose.stamp >> pose.frame >> pose.position >> pose.orientation >> pose.covariance;
  in.end();
  return pose;
}

Cloud read_cloud(Bytes message) {
  In in(message);
  Cloud cloud;
  in >> cloud.stamp >> cloud.frame;
  const auto height = in.take<std::uint32_t>(), width = in.take<std::uint32_t>();
  cloud.fields.resize(in.take<std::uint32_t>());
  for (std::string& field : cloud.fields) {
    in >> field;
    const auto offset = in.take<std::uint32_t>();
    const auto type = in.take<std::uint8_t>();
    const auto count = in.take<std::uint32_t>();
    field += "@" + std::to_string(offset) + (type == 7 && count == 1 ? "" : "?");
  }
  const bool is_big_endian = in.take<bool>();
  const auto point_step = in.take<std::uint32_t>(), row_step = in.take<std::uint32_t>();
  const auto data = in.take<std::vector<std::uint8_t>>();
  const bool is_dense = in.take<bool>();
  in.end();
  if (height != 1 || is_big_endian || point_step != sizeof(node::Point) || row_step != width * point_step ||
      data.size() != row_step || !is_dense)
    throw std::runtime_error("a cloud whose sizes do not fit");
  cloud.points.resize(width);
  if (width > 0) std::memcpy(cloud.points.data(), data.data(), data.size());
  return cloud;
}

std::vector<DrawnMarker> read_markers(Bytes message) {
  In in(message);
  std::vector<DrawnMarker> markers(in.take<std::uint32_t>());
  for (DrawnMarker& each : markers) each = read_marker(in);
  in.end();
  return markers;
}

Obstacles read_obstacles(Bytes message) {
  In in(message);
  Obstacles told;
  in >> told.stamp;
  in.take<std::string>();
  told.obstacles.resize(in.take<std::uint32_t>());
  for (node::Obstacle& each : told.obstacles) {
    each.id = in.take<std::int32_t>();
    in >> each.kind >> each.state >> each.x >> each.y >> each.heading >> each.width >> each.depth >> each.radius >>
        each.velocity_x >> each.velocity_y >> each.distance;
    each.points = in.take<std::int32_t>();
  }
  in.end();
  return told;
}

Status read_status(Bytes message) {
  In in(message);
  Status told;
  node::Status& status = told.status;
  in >> told.stamp;
  in.take<std::string>();
  in >> told.state >> status.tracking >> status.stop >> status.usable >> status.probability >> status.awareness >>
      status.blind >> status.blind_x >> status.blind_y >> status.carried_by;
  for (int* const count : {&status.points, &status.inliers, &status.outliers, &status.iterations})
    *count = in.take<std::int32_t>();
  in >> status.localization_seconds >> status.obstacle_seconds >> status.waited >> status.had_odometry >>
      status.scans >> status.dropped >> status.recoveries;
  in.end();
  return told;
}

node::Grid read_grid(Bytes message) {
  In in(message);
  node::Grid grid;
  in >> grid.stamp >> grid.frame;
  in.take<node::Stamp>();
  grid.resolution = static_cast<double>(in.take<float>());
  grid.width = static_cast<int>(in.take<std::uint32_t>());
  grid.height = static_cast<int>(in.take<std::uint32_t>());
  in >> grid.origin >> grid.orientation;
  const auto cells = in.take<std::vector<std::uint8_t>>();
  in.end();
  for (const std::uint8_t cell : cells) grid.cells.push_back(static_cast<std::int8_t>(cell));
  return grid;
}

std::vector<Diagnostics> read_diagnostics(Bytes message) {
  In in(message);
  in.take<node::Stamp>();
  in.take<std::string>();
  std::vector<Diagnostics> all(in.take<std::uint32_t>());
  for (Diagnostics& each : all) {
    in.take<std::uint8_t>();
    in >> each.name >> each.message;
    in.take<std::string>();
    each.values.resize(in.take<std::uint32_t>());
    for (auto& [key, value] : each.values) in >> key >> value;
  }
  in.end();
  return all;
}

LogLine read_log_line(Bytes message) {
  In in(message);
  LogLine line;
  in.take<node::Stamp>();
  line.level = in.take<std::uint8_t>();
  in >> line.name >> line.text;
  in.take<std::string>();  // file, function, line
  in.take<std::string>();
  in.take<std::uint32_t>();
  in.end();
  return line;
}

Announcement read_announcement(Bytes message, int gid_size) {
  In in(message);
  Announcement told;
  told.participant = read_guid(in, gid_size);
  if (in.take<std::uint32_t>() != 1) throw std::runtime_error("not one node in an announcement");
  in >> told.space >> told.name;
  told.readers = read_guids(in, gid_size);
  told.writers = read_guids(in, gid_size);
  in.end();
  return told;
}

}  // namespace slamicp::dds_peer
