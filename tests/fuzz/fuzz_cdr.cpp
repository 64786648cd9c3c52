// SPDX-License-Identifier: Apache-2.0
#include "fuzz.hpp"
#include "io/ros_messages.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slamicp;
  const auto run = [&](auto read) {
    fuzz::run(data, size, [&](std::string_view bytes) { read(Serialization::cdr, bytes, "fuzz"); });
  };
  run(ros::read_laser_scan);
  run(ros::read_odometry);
  run(ros::read_transforms);
  run(ros::read_point_cloud);
  return 0;
}
