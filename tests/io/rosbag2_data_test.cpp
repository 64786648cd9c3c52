// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <map>

#include <slamicp/io/scan_log.hpp>

#include "io/io_test_support.hpp"
#include "support/recorded.hpp"

namespace slamicp::rosbag2_data_test {
namespace {

TEST(Rosbag2Data, MacFirstFloorMessages) {
  SLAMICP_NEEDS_DATA(path, "maps_localization/macfirst_floor_take_2_0.db3");
  test::Recorded recorded;
  read_rosbag2(path, recorded);
  std::map<std::string, int> counts;
  for (const auto& message : recorded.messages) ++counts[message.topic];
  const std::map<std::string, int> expected{
      {"/robot_description", 1}, {"/cmd_vel", 192}, {"/tf_static", 2}, {"/scan", 357}, {"/tf", 953}, {"/odom", 920}};
  EXPECT_EQ(counts, expected);
  EXPECT_TRUE(recorded.warnings.empty());
}

TEST(Rosbag2Data, MacFirstFloorLog) {
  SLAMICP_NEEDS_DATA(path, "maps_localization/macfirst_floor_take_2_0.db3");
  const ScanLog log = open_scan_log(path);
  EXPECT_EQ(log.size(), 357U);
  EXPECT_EQ(log.format, "rosbag2");
  std::size_t with_odometry = 0;
  for (const LaserScan& scan : log) {
    ASSERT_EQ(scan.ranges.size(), 720U);
    with_odometry += scan.T_odom_robot ? 1U : 0U;
  }
  EXPECT_EQ(with_odometry, 356U);
  // By tf, rplidar_link to base_link.
  EXPECT_NEAR(log[0].T_robot_laser.x, 0.0039, 1e-4);
  EXPECT_NEAR(log[0].T_robot_laser.theta, 1.5708, 1e-3);
}

}  // namespace
}  // namespace slamicp::rosbag2_data_test
