// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/ros_messages.hpp"

namespace slamicp::ros {

/// Takes a message of ROS 2 apart, field by field: plain CDR in either byte order, as its encapsulation header says, by
/// Fast-CDR. Each function gives the next field; Error, at `where`, if the message ends before it or it cannot be. What
/// a length says is believed only as far as the message goes.
class CdrReader {
 public:
  /// Throws Error where the header is of no plain CDR, and in a build without Fast-CDR.
  /// @param body  header and fields; it and `where` must outlive the reader
  CdrReader(std::string_view body, const std::string& where);
  CdrReader(CdrReader&&) noexcept;
  ~CdrReader();

  std::uint8_t u8();
  std::uint32_t u32();
  std::int32_t i32();
  float f32();
  double f64();
  bool boolean();
  std::string string();
  /// A sequence of float32.
  void floats(std::vector<float>& numbers);
  /// A sequence of bytes; good as long as `body` is.
  std::string_view bytes();
  /// builtin_interfaces/Time [s]
  double stamp();
  /// std_msgs/Header
  Header header();

  /// Bytes not taken yet.
  std::size_t remaining() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slamicp::ros
