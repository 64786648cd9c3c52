// SPDX-License-Identifier: Apache-2.0
#include "fuzz.hpp"
#include "io/ros_log.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) {
    const auto read = [&](slamicp::RecordingVisitor& visitor) { slamicp::read_ros1_bag(bytes, "fuzz", visitor); };
    const slamicp::ScanLog log = slamicp::make_ros_log("fuzz", "ROS 1 bag", read, {});
    if (log.empty() || log.lasers.size() != 1) std::abort();
    for (const slamicp::LaserScan& scan : log)
      if (scan.laser != 0 || !scan.T_robot_laser.is_finite()) std::abort();
  });
}
