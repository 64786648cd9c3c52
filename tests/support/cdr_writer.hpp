// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace slamicp::test {

/// Writes a message as CDR, field by field, by the OMG's words and without the library that reads it.
class CdrWriter {
 public:
  explicit CdrWriter(bool big_endian = false)
      : big_endian_(big_endian), bytes_{'\0', static_cast<char>(big_endian ? 0 : 1), '\0', '\0'} {}

  CdrWriter& u8(std::uint8_t value) { return put(value, 1); }
  CdrWriter& u32(std::uint32_t value) { return put(value, 4); }
  CdrWriter& i32(std::int32_t value) { return put(static_cast<std::uint32_t>(value), 4); }
  CdrWriter& f32(float value) { return put(std::bit_cast<std::uint32_t>(value), 4); }
  CdrWriter& f64(double value) { return put(std::bit_cast<std::uint64_t>(value), 8); }
  CdrWriter& string(std::string_view text) {
    u32(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.append(text).push_back('\0');
    return *this;
  }
  CdrWriter& floats(const std::vector<float>& values) {
    u32(static_cast<std::uint32_t>(values.size()));
    for (const float value : values) f32(value);
    return *this;
  }
  CdrWriter& bytes(std::string_view values) {
    u32(static_cast<std::uint32_t>(values.size()));
    bytes_.append(values);
    return *this;
  }
  CdrWriter& header(std::int32_t seconds, std::uint32_t nanoseconds, std::string_view frame) {
    return i32(seconds).u32(nanoseconds).string(frame);
  }
  /// geometry_msgs/Pose in the plane, facing ahead.
  CdrWriter& pose(double x, double y) { return f64(x).f64(y).f64(0.0).f64(0.0).f64(0.0).f64(0.0).f64(1.0); }

  const std::string& message() const { return bytes_; }

 private:
  CdrWriter& put(std::uint64_t bits, unsigned size) {
    while ((bytes_.size() - 4) % size != 0) bytes_.push_back('\0');
    for (unsigned i = 0; i < size; ++i) {
      const unsigned shift = 8 * (big_endian_ ? size - 1 - i : i);
      bytes_.push_back(static_cast<char>((bits >> shift) & 0xFF));
    }
    return *this;
  }

  bool big_endian_;
  std::string bytes_;
};

/// sensor_msgs/msg/LaserScan, one beam a degree.
inline std::string laser_scan_message(std::int32_t seconds, const std::vector<float>& ranges, bool big_endian = false) {
  CdrWriter out(big_endian);
  out.header(seconds, 500'000'000, "laser");
  const auto beams = static_cast<float>(ranges.size());
  constexpr float degree = 0.0174532925F;
  out.f32(0.0F).f32((beams - 1.0F) * degree).f32(degree).f32(0.0F).f32(0.1F).f32(0.05F).f32(30.0F);
  return out.floats(ranges).floats({}).message();
}

/// nav_msgs/msg/Odometry
inline std::string odometry_message(std::int32_t seconds, double x, double y, bool big_endian = false) {
  CdrWriter out(big_endian);
  out.header(seconds, 0, "odom").string("base_link").pose(x, y);
  for (int i = 0; i < 36 + 6 + 36; ++i) out.f64(0.0);  // covariance, twist, covariance
  return out.message();
}

/// tf2_msgs/msg/TFMessage of one transform
inline std::string transform_message(std::string_view frame, std::string_view child, double x, double y,
                                     bool big_endian = false) {
  return CdrWriter(big_endian).u32(1).header(7, 0, frame).string(child).pose(x, y).message();
}

/// sensor_msgs/msg/PointCloud2 of x and y, in one row
inline std::string point_cloud_message(const std::vector<float>& xy, bool big_endian = false) {
  CdrWriter out(big_endian);
  const auto count = static_cast<std::uint32_t>(xy.size() / 2);
  out.header(9, 0, "lidar").u32(1).u32(count).u32(2);
  out.string("x").u32(0).u8(7).u32(1).string("y").u32(4).u8(7).u32(1);
  out.u8(0).u32(8).u32(8 * count);
  std::string data;
  for (const float value : xy)
    for (unsigned shift = 0; shift < 32; shift += 8)
      data.push_back(static_cast<char>((std::bit_cast<std::uint32_t>(value) >> shift) & 0xFF));
  return out.bytes(data).u8(1).message();
}

}  // namespace slamicp::test
