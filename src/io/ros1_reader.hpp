// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/ros_messages.hpp"

namespace slamicp::ros {

/// Takes a message of ROS 1 apart, field by field. Each function gives the next field; Error, at `where`, if the
/// message ends before it. What a length says is believed only as far as the message goes.
class Ros1Reader {
 public:
  /// @param body  it and `where` must outlive the reader
  Ros1Reader(std::string_view body, const std::string& where) noexcept : rest_(body), where_(where) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(bits(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(bits(4)); }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
  float f32();
  double f64();
  bool boolean() { return u8() != 0; }
  std::string string() { return std::string(bytes()); }
  /// An array of float32 with its length.
  void floats(std::vector<float>& numbers);
  /// An array of bytes with its length; good as long as `body` is.
  std::string_view bytes() { return take(u32()); }
  /// time [s]
  double stamp();
  /// std_msgs/Header
  Header header();

  /// Bytes not taken yet.
  std::size_t remaining() const noexcept { return rest_.size(); }

 private:
  std::string_view take(std::size_t size);
  std::uint64_t bits(std::size_t size);

  std::string_view rest_;
  const std::string& where_;
};

}  // namespace slamicp::ros
