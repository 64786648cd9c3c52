// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace slamicp {

/// The name that a message type has in ROS 1, of the one that it has in ROS 2: "sensor_msgs/LaserScan" of
/// "sensor_msgs/msg/LaserScan".
inline std::string ros1_type(std::string_view type) {
  constexpr std::string_view infix = "/msg/";
  std::string name(type);
  const std::size_t at = name.find(infix);
  if (at != std::string::npos) name.replace(at, infix.size(), "/");
  return name;
}

}  // namespace slamicp
