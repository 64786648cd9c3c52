// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp::test {

/// Writes a message as ROS 1 has it, field by field.
class Ros1Writer {
 public:
  Ros1Writer& u8(std::uint8_t value) { return put(value, 1); }
  Ros1Writer& u32(std::uint32_t value) { return put(value, 4); }
  Ros1Writer& f32(double value) { return put(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4); }
  Ros1Writer& f64(double value) { return put(std::bit_cast<std::uint64_t>(value), 8); }
  Ros1Writer& string(std::string_view text) {
    u32(static_cast<std::uint32_t>(text.size()));
    bytes_.append(text);
    return *this;
  }
  Ros1Writer& stamp(double seconds) {
    const double whole = std::floor(seconds);
    return u32(static_cast<std::uint32_t>(whole)).u32(static_cast<std::uint32_t>(std::lround((seconds - whole) * 1e9)));
  }
  Ros1Writer& header(double seconds, std::string_view frame) { return u32(7).stamp(seconds).string(frame); }
  Ros1Writer& floats(const std::vector<float>& values) {
    u32(static_cast<std::uint32_t>(values.size()));
    for (const float value : values) f32(static_cast<double>(value));
    return *this;
  }
  Ros1Writer& pose(const Pose3& pose) {
    for (int axis = 0; axis < 3; ++axis) f64(pose.position[axis]);
    return f64(pose.orientation.x()).f64(pose.orientation.y()).f64(pose.orientation.z()).f64(pose.orientation.w());
  }

  const std::string& message() const { return bytes_; }

 private:
  Ros1Writer& put(std::uint64_t bits, unsigned size) {
    for (unsigned shift = 0; shift < 8 * size; shift += 8) bytes_.push_back(static_cast<char>((bits >> shift) & 0xFF));
    return *this;
  }

  std::string bytes_;
};

/// A pose in space: roll, pitch and yaw [rad] about the fixed axes.
inline Pose3 pose3(double x, double y, double z, double roll, double pitch, double yaw) {
  Pose3 pose;
  pose.position = {x, y, z};
  pose.orientation = Eigen::AngleAxisd(yaw, Point3::UnitZ()) * Eigen::AngleAxisd(pitch, Point3::UnitY()) *
                     Eigen::AngleAxisd(roll, Point3::UnitX());
  return pose;
}
inline Pose3 pose3(double x, double y, double yaw) { return pose3(x, y, 0.0, 0.0, 0.0, yaw); }

/// What a test says of a sensor_msgs/LaserScan.
struct ScanMessage {
  double stamp = 0.0;
  std::string frame = "laser";
  double angle_min = -1.0, angle_increment = 0.5;
  double time_increment = 0.0, scan_time = 0.1;
  double range_min = 0.1, range_max = 30.0;
  std::vector<float> ranges = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F};

  std::string message() const {
    Ros1Writer out;
    out.header(stamp, frame).f32(angle_min).f32(angle_min + angle_increment * static_cast<double>(ranges.size() - 1));
    out.f32(angle_increment).f32(time_increment).f32(scan_time).f32(range_min).f32(range_max);
    return out.floats(ranges).floats(ranges).message();  // intensities too
  }
};

/// nav_msgs/Odometry
inline std::string ros1_odometry(double stamp, const Pose3& pose, std::string_view child = "base_link") {
  Ros1Writer out;
  out.header(stamp, "odom").string(child).pose(pose);
  for (int i = 0; i < 36 + 6 + 36; ++i) out.f64(0.0);  // covariance, twist, covariance
  return out.message();
}

/// tf2_msgs/TFMessage of one transform
inline std::string ros1_transform(double stamp, std::string_view frame, std::string_view child, const Pose3& pose) {
  return Ros1Writer().u32(1).header(stamp, frame).string(child).pose(pose).message();
}

}  // namespace slamicp::test
