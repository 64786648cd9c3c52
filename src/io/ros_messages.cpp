// SPDX-License-Identifier: Apache-2.0
#include "io/ros_messages.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include <slamicp/error.hpp>

#include "io/binary.hpp"
#include "io/cdr.hpp"
#include "io/ros1_reader.hpp"
#include "io/text.hpp"

namespace slamicp::ros {
namespace {

[[noreturn]] void fail(const std::string& problem, const std::string& where) {
  throw Error(problem, where, "look at what records it, or leave the topic out");
}

/// Reads a message by `description`, which takes the reader of either serialization.
template <class Description>
auto read(Serialization serialization, std::string_view body, const std::string& where, Description&& description) {
  if (serialization == Serialization::ros1) {
    Ros1Reader in(body, where);
    return description(in);
  }
  CdrReader in(body, where);
  return description(in);
}

template <class Reader>
Pose3::Quaternion rotation(Reader& in, const std::string& where) {
  const double x = in.f64();
  const double y = in.f64();
  const double z = in.f64();
  const double w = in.f64();
  const Pose3::Quaternion quaternion(w, x, y, z);
  constexpr double shortest = 0.5, longest = 2.0;  // it should be 1; 0 is what a message has that nobody filled in
  const double length = quaternion.norm();
  if (!(length >= shortest && length <= longest)) fail("a quaternion is no rotation: its length is not 1", where);
  return quaternion.normalized();
}

/// geometry_msgs/Pose, and geometry_msgs/Transform too
template <class Reader>
Pose3 pose(Reader& in, const std::string& where) {
  Pose3 pose;
  for (int axis = 0; axis < 3; ++axis) pose.position[axis] = in.f64();
  if (!pose.position.allFinite()) fail("a position is not finite", where);
  pose.orientation = rotation(in, where);
  return pose;
}

/// Drivers leave limits at 0, or give NaN, where they know none.
void take_limits(double range_min, double range_max, slamicp::LaserScan& scan) {
  if (range_min > 0.0 && std::isfinite(range_min)) scan.range_min = range_min;
  if (range_max > scan.range_min) scan.range_max = range_max;
}

void require_directions(const slamicp::LaserScan& scan, const std::string& where) {
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment))
    fail("a scan's angles are not finite", where);
  if (scan.angle_increment == 0.0 && scan.ranges.size() > 1)
    fail("a scan's " + std::to_string(scan.ranges.size()) + " beams all have one direction: angle_increment is 0",
         where);
}

template <class Reader>
LaserScan laser_scan(Reader& in, const std::string& where) {
  LaserScan message;
  message.header = in.header();
  slamicp::LaserScan& scan = message.scan;
  scan.stamp = message.header.stamp;
  scan.angle_min = static_cast<double>(in.f32());
  message.angle_max = static_cast<double>(in.f32());
  scan.angle_increment = static_cast<double>(in.f32());
  scan.time_increment = static_cast<double>(in.f32());
  message.scan_time = static_cast<double>(in.f32());
  const auto range_min = static_cast<double>(in.f32());
  const auto range_max = static_cast<double>(in.f32());
  take_limits(range_min, range_max, scan);
  in.floats(scan.ranges);
  if (!std::isfinite(scan.time_increment)) scan.time_increment = 0.0;
  require_directions(scan, where);
  return message;
}

template <class Reader>
Odometry odometry(Reader& in, const std::string& where) {
  Odometry message;
  message.header = in.header();
  message.child_frame = in.string();
  message.pose = pose(in, where);
  return message;
}

template <class Reader>
std::vector<Transform> transforms(Reader& in, const std::string& where) {
  std::vector<Transform> message;
  for (std::uint32_t left = in.u32(); left > 0; --left) {
    Transform transform;
    transform.header = in.header();
    transform.child_frame = in.string();
    transform.pose = pose(in, where);
    message.push_back(std::move(transform));
  }
  return message;
}

/// One coordinate of a PointCloud2: where it stands in a point's bytes.
struct Coordinate {
  std::uint32_t offset = 0;
  std::size_t size = 0;  ///< 0: there is none
};

/// How a PointCloud2 lays out its bytes.
struct Layout {
  std::array<Coordinate, 3> coordinates;
  std::uint64_t height = 0, width = 0;
  bool big_endian = false;
  std::uint64_t point_step = 0, row_step = 0;
};

/// sensor_msgs/PointField[]
template <class Reader>
std::array<Coordinate, 3> coordinates(Reader& in, const std::string& where) {
  constexpr std::uint8_t float32 = 7, float64 = 8;
  std::array<Coordinate, 3> found;
  for (std::uint32_t left = in.u32(); left > 0; --left) {
    const std::string name = in.string();
    const std::uint32_t offset = in.u32();
    const std::uint8_t type = in.u8();
    in.u32();  // how many of them
    if (name != "x" && name != "y" && name != "z") continue;
    if (type != float32 && type != float64) fail("a cloud's " + name + " is no float32 or float64", where);
    found[static_cast<std::size_t>(name[0] - 'x')] = {offset, type == float32 ? 4U : 8U};
  }
  if (found[0].size == 0 || found[1].size == 0) fail("a cloud has no field x or y", where);
  return found;
}

void require_layout(const Layout& layout, std::string_view data, const std::string& where) {
  for (const Coordinate& coordinate : layout.coordinates)
    if (coordinate.offset + std::uint64_t{coordinate.size} > layout.point_step)
      fail("a cloud's fields reach beyond its points of " + text::count_of(layout.point_step, "byte"), where);
  if (layout.width == 0 || layout.height == 0) return;
  // Each of the numbers has 32 bits: products fit.
  const std::uint64_t row = layout.width * layout.point_step;
  if (layout.height > 1 && layout.row_step < row) fail("a cloud's rows overlap", where);
  const std::uint64_t before_last = (layout.height - 1) * layout.row_step;
  if (row > data.size() || before_last > data.size() - row) fail("a cloud has less data than its points need", where);
}

PointCloud3 points(const Layout& layout, std::string_view data) {
  PointCloud3 points;
  const auto number = [&](std::size_t at, const Coordinate& coordinate) {
    if (coordinate.size == 0) return 0.0;
    const binary::Kind kind{binary::Kind::Class::real, coordinate.size};
    return binary::read_number(data, at + coordinate.offset, kind, layout.big_endian);
  };
  for (std::uint64_t row = 0; row < layout.height; ++row)
    for (std::uint64_t column = 0; column < layout.width; ++column) {
      const auto at = static_cast<std::size_t>(row * layout.row_step + column * layout.point_step);
      const Point3 point(number(at, layout.coordinates[0]), number(at, layout.coordinates[1]),
                         number(at, layout.coordinates[2]));
      if (point.allFinite()) points.push_back(point);
    }
  return points;
}

template <class Reader>
PointCloud point_cloud(Reader& in, const std::string& where) {
  PointCloud message;
  message.header = in.header();
  Layout layout;
  layout.height = in.u32();
  layout.width = in.u32();
  layout.coordinates = coordinates(in, where);
  layout.big_endian = in.boolean();
  layout.point_step = in.u32();
  layout.row_step = in.u32();
  const std::string_view data = in.bytes();
  require_layout(layout, data, where);
  if (layout.width > 0) message.points = points(layout, data);
  return message;
}

}  // namespace

LaserScan read_laser_scan(Serialization serialization, std::string_view body, const std::string& where) {
  return read(serialization, body, where, [&](auto& in) { return laser_scan(in, where); });
}

Odometry read_odometry(Serialization serialization, std::string_view body, const std::string& where) {
  return read(serialization, body, where, [&](auto& in) { return odometry(in, where); });
}

std::vector<Transform> read_transforms(Serialization serialization, std::string_view body, const std::string& where) {
  return read(serialization, body, where, [&](auto& in) { return transforms(in, where); });
}

PointCloud read_point_cloud(Serialization serialization, std::string_view body, const std::string& where) {
  return read(serialization, body, where, [&](auto& in) { return point_cloud(in, where); });
}

}  // namespace slamicp::ros
