// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gtest/gtest.h>
#include <string>

#include <slamicp/io/scan_log.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::ros_log_data_test {
namespace {

double odometry_path(const ScanLog& log) {
  double path = 0.0;
  for (std::size_t i = 1; i < log.size(); ++i)
    if (log[i - 1].T_odom_robot && log[i].T_odom_robot)
      path += distance(*log[i - 1].T_odom_robot, *log[i].T_odom_robot).translation;
  return path;
}

void expect_beams(const ScanLog& log, std::size_t beams) {
  for (const LaserScan& scan : log) ASSERT_EQ(scan.ranges.size(), beams);
}

std::size_t scans_of(const ScanLog& log, int laser) {
  return static_cast<std::size_t>(
      std::count_if(log.begin(), log.end(), [&](const LaserScan& scan) { return scan.laser == laser; }));
}

void expect_birmingham(const std::filesystem::path& path, std::size_t scans, double metres) {
  const ScanLog log = open_scan_log(path);
  EXPECT_EQ(log.format, "ROS 1 bag");
  EXPECT_EQ(log.size(), scans);
  EXPECT_EQ(log.messages.at("/odom (nav_msgs/Odometry)"), scans);
  EXPECT_TRUE(log.warnings.empty());
  expect_beams(log, 726);
  EXPECT_NEAR(odometry_path(log), metres, 0.1);
  for (const LaserScan& scan : log) {
    ASSERT_TRUE(scan.T_odom_robot.has_value());
    ASSERT_NEAR(scan.T_robot_laser.x, 0.135, 1e-6);
    ASSERT_NEAR(sweep_time(scan), 0.0708, 1e-3);
  }
}

TEST(RosLogData, BirminghamTrace0) {
  SLAMICP_NEEDS_DATA(path, "hokuyo/birmingham_trace0.bag");
  expect_birmingham(path, 958, 31.7);
}

TEST(RosLogData, BirminghamTrace1) {
  SLAMICP_NEEDS_DATA(path, "hokuyo/birmingham_trace1.bag");
  expect_birmingham(path, 906, 31.5);
}

TEST(RosLogData, ScanToolsDemoWithItsDamagedIndex) {
  SLAMICP_NEEDS_DATA(path, "hokuyo/scan_tools_demo.bag");
  const ScanLog log = open_scan_log(path);
  EXPECT_EQ(log.size(), 360U);
  expect_beams(log, 681);
  EXPECT_NEAR(log.scans.back().stamp - log.scans.front().stamp, 35.8, 0.1);
  ASSERT_EQ(log.warnings.size(), 1U);
  EXPECT_NE(log.warnings[0].find("2 index records with a wrong length"), std::string::npos);
}

TEST(RosLogData, LegTrackerStationary) {
  SLAMICP_NEEDS_DATA(path, "obstacles/leg_positive_1_extracted.bag");
  const ScanLog log = open_scan_log(path);
  EXPECT_EQ(log.size(), 197U);
  expect_beams(log, 768);
  EXPECT_EQ(log.messages.at("/leg_cluster_positions (geometry_msgs/PoseArray)"), 197U);
}

TEST(RosLogData, LegTrackerThreeScanners) {
  SLAMICP_NEEDS_DATA(path, "obstacles/leg_negative_2.bag");
  EXPECT_THROW(open_scan_log(path), Error);
  const ScanLog log = open_scan_log(path, {.scan_topics = {"/left_scan", "/rear_scan", "/right_scan"}});
  EXPECT_EQ(scans_of(log, 0), 435U);
  EXPECT_EQ(scans_of(log, 1), 435U);
  EXPECT_EQ(scans_of(log, 2), 434U);
  EXPECT_TRUE(
      std::is_sorted(log.begin(), log.end(), [](const LaserScan& a, const LaserScan& b) { return a.stamp < b.stamp; }));
  expect_beams(log, 768);
}

TEST(RosLogData, ObstacleDetectorTwoScanners) {
  SLAMICP_NEEDS_DATA(path, "obstacles/obstacle_detector_scans_demo.bag");
  EXPECT_THROW(open_scan_log(path), Error);
  EXPECT_EQ(open_scan_log(path, {.scan_topics = {"front_scan"}}).size(), 331U);
  EXPECT_EQ(open_scan_log(path, {.scan_topics = {"rear_scan"}}).size(), 330U);
}

TEST(RosLogData, CutAnywhereGivesTheFirstScans) {
  SLAMICP_NEEDS_DATA(path, "obstacles/leg_positive_1_extracted.bag");
  const std::string bag = io_test::get(path);
  const ScanLog all = open_scan_log(path);
  const io_test::TemporaryFolder folder;
  for (std::size_t size = 0; size < bag.size(); size += 20'011) {
    io_test::put(folder / "cut.bag", std::string_view(bag).substr(0, size));
    try {
      const ScanLog log = open_scan_log(folder / "cut.bag");
      ASSERT_LE(log.size(), all.size());
      EXPECT_FALSE(log.warnings.empty()) << size;
      for (std::size_t i = 0; i < log.size(); ++i) ASSERT_EQ(log[i].ranges, all[i].ranges) << size;
    } catch (const Error& error) {
      EXPECT_FALSE(error.problem().empty() || error.mend().empty());
    }
  }
}

}  // namespace
}  // namespace slamicp::ros_log_data_test
