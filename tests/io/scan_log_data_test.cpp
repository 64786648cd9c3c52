// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gtest/gtest.h>

#include <slamicp/io/scan_log.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::scan_log_data_test {
namespace {

std::size_t farther_than(const ScanLog& log, float limit) {
  std::size_t count = 0;
  for (const LaserScan& scan : log)
    count += static_cast<std::size_t>(std::count_if(
        scan.ranges.begin(), scan.ranges.end(), [&](float range) { return range > limit && is_return(scan, range); }));
  return count;
}

bool has_warning(const ScanLog& log, std::string_view words) {
  return std::any_of(log.warnings.begin(), log.warnings.end(),
                     [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

TEST(ScanLogData, Intel) {
  SLAMICP_NEEDS_DATA(path, "slam_benchmark/intel.clf");
  const ScanLog log = open_scan_log(path);
  EXPECT_EQ(log.size(), 13631U);
  EXPECT_EQ(log.messages.at("ODOM"), 26915U);
  EXPECT_TRUE(has_warning(log, "631 stamps run backwards, by up to 0.897 s"));
  EXPECT_TRUE(has_warning(log, "68313 readings are a constant, 81.83 m"));
  EXPECT_EQ(farther_than(log, 30.0F), 0U);
  EXPECT_EQ(log[0].T_robot_laser.x, 0.0);
}

TEST(ScanLogData, Fr079) {
  SLAMICP_NEEDS_DATA(path, "slam_benchmark/fr079.clf");
  const ScanLog log = open_scan_log(path);
  EXPECT_EQ(log.size(), 4934U);
  EXPECT_TRUE(has_warning(log, "36881 readings are a constant, 81.91 m"));
  EXPECT_EQ(farther_than(log, 40.0F), 0U);
  for (const LaserScan& scan : log) {
    ASSERT_DOUBLE_EQ(scan.T_robot_laser.x, -0.04);
    ASSERT_EQ(scan.T_robot_laser.y, 0.0);
    ASSERT_EQ(scan.ranges.size(), 360U);
  }
}

TEST(ScanLogData, FlyingUtm30) {
  SLAMICP_NEEDS_DATA(path, "hokuyo/flying-rsise_utm30lx.csv");
  const ScanLog log = open_scan_log(path);
  EXPECT_EQ(log.size(), 190U);
  EXPECT_EQ(log[0].ranges.size(), 1081U);
  EXPECT_NEAR(log[0].angle_min, -2.35619449615, 1e-8);
  EXPECT_NEAR(log[0].angle_increment, 0.00436332309619, 1e-9);
  EXPECT_FALSE(is_return(log[0], log[0].ranges[0]));
  EXPECT_TRUE(has_warning(log, "line 191, the last, is cut: 542 of 1081 ranges"));
}

TEST(ScanLogData, Corridor) {
  SLAMICP_NEEDS_DATA(path, "corridor/ranges_box.csv");
  const ScanLog log = open_scan_log(path);
  EXPECT_EQ(log.size(), 300U);
  EXPECT_EQ(log[299].ranges.size(), 1081U);
  EXPECT_TRUE(log.warnings.empty());
}

}  // namespace
}  // namespace slamicp::scan_log_data_test
