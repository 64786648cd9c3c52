// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include <slamicp/io/carmen_log.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::carmen_log_test {
namespace {

using io_test::expect_error;

constexpr double pi = std::numbers::pi;

std::string flaser(std::size_t beams, const std::string& range = "2.5", const std::string& poses = "0 0 0 1 2 0.5",
                   const std::string& stamp = "10.5") {
  std::string line = "FLASER " + std::to_string(beams);
  for (std::size_t i = 0; i < beams; ++i) line += ' ' + range;
  return line + ' ' + poses + ' ' + stamp + " host 1.25\n";
}

const std::string robotlaser =
    "ROBOTLASER1 0 -1.5 3.0 1.5 29.9 0.01 0 3 1.0 29.9 30.0 2 7 8 1.1 2.0 0.0 1.0 2.0 0.0 0.1 0.2 0 0 0 12.25 h 3\n";

TEST(CarmenLog, ReadsFlaserWithItsAnglesByBeamCount) {
  struct Case {
    std::size_t beams;
    double increment;
  };
  for (const auto& [beams, increment] :
       {Case{180, pi / 180}, Case{181, pi / 180}, Case{360, pi / 360}, Case{361, pi / 360}, Case{5, pi / 4}}) {
    const ScanLog log = parse_carmen_log(flaser(beams), "run.clf");
    ASSERT_EQ(log.size(), 1U);
    EXPECT_EQ(log[0].ranges.size(), beams);
    EXPECT_DOUBLE_EQ(log[0].angle_min, -pi / 2);
    EXPECT_DOUBLE_EQ(log[0].angle_increment, increment);
    EXPECT_EQ(log[0].stamp, 10.5);
    EXPECT_EQ(log[0].T_odom_robot->y, 2.0);
  }
}

TEST(CarmenLog, ReadsRobotlaserAndTakesMaxRangeAsNoReturn) {
  const ScanLog log = parse_carmen_log(robotlaser, "run.clf");
  ASSERT_EQ(log.size(), 1U);
  const LaserScan& scan = log[0];
  EXPECT_EQ(scan.angle_min, -1.5);
  EXPECT_EQ(scan.angle_increment, 1.5);
  EXPECT_EQ(scan.stamp, 12.25);
  EXPECT_DOUBLE_EQ(scan.T_robot_laser.x, 0.1);
  EXPECT_TRUE(is_return(scan, scan.ranges[0]));
  EXPECT_FALSE(is_return(scan, scan.ranges[1]));
  EXPECT_FALSE(is_return(scan, scan.ranges[2]));
}

TEST(CarmenLog, KeepsFileOrderCountsMessagesAndSkipsComments) {
  const std::string text = "# a comment\nPARAM robot_use_laser on 1 h 1\nODOM 0 0 0 0 0 0 1 h 1\n\n" +
                           flaser(5, "1", "1 1 0 1 1 0", "5.0") + flaser(5, "2", "1 1 0 1 1 0", "4.25") +
                           "\x01\x02 strange\n";
  const ScanLog log = parse_carmen_log(text, "run.clf");
  ASSERT_EQ(log.size(), 2U);
  EXPECT_EQ(log[1].stamp, 4.25);
  EXPECT_EQ(log.messages.at("FLASER"), 2U);
  EXPECT_EQ(log.messages.at("ODOM"), 1U);
  EXPECT_EQ(log.messages.at("PARAM"), 1U);
  EXPECT_EQ(log.messages.at("other"), 1U);
  ASSERT_EQ(log.warnings.size(), 1U);
  EXPECT_EQ(log.warnings[0], "1 stamp runs backwards, by up to 0.750 s: scans are kept in the order of the file");
}

TEST(CarmenLog, IsRangeIterableAsTemporary) {
  std::size_t count = 0;
  for (const LaserScan& scan : parse_carmen_log(flaser(5) + flaser(5), "run.clf")) count += scan.ranges.size();
  EXPECT_EQ(count, 10U);
}

TEST(CarmenLog, TakesTheLaserOffsetAsMedianOfRoundedPoses) {
  std::string text;
  for (const char* poses : {"-0.040001 0.000001 0 0 0 0", "1.0 1.959999 1.570796 1.0 2.0 1.570796",
                            "2.040001 3.0 3.141593 2.0 3.0 3.141593"})
    text += flaser(5, "1", poses);
  const ScanLog log = parse_carmen_log(text, "run.clf");
  for (const LaserScan& scan : log) {
    EXPECT_DOUBLE_EQ(scan.T_robot_laser.x, -0.04);
    EXPECT_EQ(scan.T_robot_laser.y, 0.0);
    EXPECT_EQ(scan.T_robot_laser.theta, 0.0);
  }
  EXPECT_TRUE(log.warnings.empty());
}

TEST(CarmenLog, TakesNoOffsetFromACorrectedLog) {
  std::string text;
  for (int i = 0; i < 9; ++i)
    text +=
        flaser(5, "1", std::to_string(i) + " 0 0 " + std::to_string(1.3 * i) + " " + std::to_string(0.2 * i) + " 0");
  const ScanLog log = parse_carmen_log(text, "run.clf");
  EXPECT_EQ(log[3].T_robot_laser.x, 0.0);
  ASSERT_EQ(log.warnings.size(), 1U);
  EXPECT_NE(log.warnings[0].find("do not follow the odometry"), std::string::npos);
}

TEST(CarmenLog, OptionOverridesTheLaserOffset) {
  const ScanLog log = parse_carmen_log(robotlaser, "run.clf", {.laser_offset = Pose2{0.2, 0.0, pi}});
  EXPECT_EQ(log[0].T_robot_laser.x, 0.2);
  expect_error(
      [] {
        parse_carmen_log(robotlaser, "run.clf", {.laser_offset = Pose2{NAN, 0, 0}});
      },
      "ScanLogOptions", "laser_offset");
}

TEST(CarmenLog, FindsTheNoReturnConstantOfSickLidars) {
  const ScanLog log = parse_carmen_log("FLASER 5 1.0 81.83 81.90 36.5 81.91 0 0 0 1 2 0 10.5 host 1\n", "run.clf");
  EXPECT_FALSE(is_return(log[0], 81.83F));
  EXPECT_FALSE(is_return(log[0], 81.91F));
  EXPECT_TRUE(is_return(log[0], 36.5F));
}

TEST(CarmenLog, FindsAnyDominantFarConstant) {
  std::string text;
  for (int i = 0; i < 30; ++i)
    text += "FLASER 5 1.0 50.0 4" + std::to_string(6 + i % 3) + ".0 2.0 1.5 0 0 0 1 2 0 10.5 host 1\n";
  ScanLog log = parse_carmen_log(text, "run.clf");
  EXPECT_TRUE(is_return(log[0], 50.0F)) << "46, 47, 48 m are a third as common: a wall, not a constant";
  text.clear();
  for (int i = 0; i < 30; ++i) text += "FLASER 5 1.0 50.0 30.0 50.0 1.5 0 0 0 1 2 0 10.5 host 1\n";
  log = parse_carmen_log(text, "run.clf");
  EXPECT_FALSE(is_return(log[0], 50.0F));
  EXPECT_TRUE(is_return(log[0], 30.0F));
  EXPECT_EQ(log.warnings.at(0), "60 readings are a constant, 50 m, that says no return: dropped");
}

TEST(CarmenLog, UsesOneKindWhereALoggerWroteBoth) {
  const ScanLog log = parse_carmen_log(flaser(5) + robotlaser, "run.clf");
  ASSERT_EQ(log.size(), 1U);
  EXPECT_EQ(log[0].angle_min, -1.5);
  ASSERT_EQ(log.warnings.size(), 1U);
}

TEST(CarmenLog, MalformedMessagesNameFileLineAndMending) {
  const auto fails = [](const std::string& line, std::string_view what) {
    expect_error([&] { parse_carmen_log("# header\n" + line + "\n" + flaser(5), "run.clf"); }, "run.clf:2", what);
  };
  fails("FLASER", "ends before its number of readings");
  fails("FLASER x 1 2", "number of readings is not a whole number: 'x'");
  fails("FLASER -3 1 2", "number of readings is not a whole number: '-3'");
  fails("FLASER 0 0 0 0 0 0 0 1 h 1", "without readings");
  fails("FLASER 4000000000 1 2", "more than the line holds");
  fails("FLASER 5 1 2", "ends at range 2 of 5");
  fails("FLASER 2 1 two 0 0 0 0 0 0 1 h 1", "range 1 is not a number: 'two'");
  fails("FLASER 2 1 2 0 0 0 0 0", "ends before its robot pose");
  fails("FLASER 2 1 2 0 0 0 0 nan 0 1 h 1", "robot pose is not a number: 'nan'");
  fails("FLASER 2 1 2 0 0 0 0 0 0", "ends before its ipc_timestamp");
  fails("FLASER 2 1 2 0 0 0 0 0 0 1.5", "ends before its ipc_hostname");
  fails("ROBOTLASER1 0 -1.5 0 0 30 0.01 0 1 1.0", "angular_resolution and field of view are both 0");
  fails("ROBOTLASER1 0 -1.5 3 1.5 30 0.01 0 1 1.0 7 1 2", "ends at range 2 of 7");
}

TEST(CarmenLog, ACutLastLineIsAWarning) {
  const std::string whole = flaser(5);
  for (std::size_t length = 8; length < whole.size() - 6; ++length) {
    const ScanLog log = parse_carmen_log(whole + whole.substr(0, length), "run.clf");
    if (log.size() == 2) {  // the host name may be cut, the stamp may not
      EXPECT_EQ(log[1].stamp, 10.5);
      continue;
    }
    EXPECT_EQ(log.size(), 1U) << length;
    EXPECT_NE(log.warnings.at(0).find("line 2, the last, is cut"), std::string::npos);
  }
}

TEST(CarmenLog, TakesCrlfAndNoFinalNewline) {
  std::string text = "# dos\r\n" + flaser(5) + flaser(5);
  text.insert(text.find("1.25\n") + 4, "\r");
  text.pop_back();
  EXPECT_EQ(parse_carmen_log(text, "run.clf").size(), 2U);
}

TEST(CarmenLog, WithoutScansSaysWhatItHolds) {
  expect_error([] { parse_carmen_log("", "run.clf"); }, "run.clf", "holds no scan");
  expect_error([] { parse_carmen_log("# header only\n", "run.clf"); }, "run.clf", "holds no scan");
  expect_error([] { parse_carmen_log("ODOM 0 0 0 0 0 0 1 h 1\nODOM 1\n", "run.clf"); }, "run.clf", "2 ODOM");
}

std::vector<LaserScan> some_scans() {
  std::vector<LaserScan> scans(2);
  for (LaserScan& scan : scans) {
    scan.angle_min = -0.75 * pi;
    scan.angle_increment = pi / 720;
    scan.range_min = 0.1;
    scan.range_max = 30.0;
    scan.ranges = {
        1.2345678F, 0.05F, 0.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        30.0F,      29.8F};
    scan.T_robot_laser = {0.123, -0.04, 3.141592653589793};
    scan.T_odom_robot = Pose2{1.0 / 3.0, 2.0, -0.7};
  }
  scans[0].stamp = 976052905.167303;
  scans[1].stamp = 976052906.5;
  return scans;
}

TEST(CarmenLog, WhatIsWrittenComesBack) {
  const std::vector<LaserScan> scans = some_scans();
  const ScanLog log = parse_carmen_log(carmen_log_text(scans), "run.clf");
  ASSERT_EQ(log.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(log[i].stamp, scans[i].stamp);
    EXPECT_EQ(log[i].angle_min, scans[i].angle_min);
    EXPECT_EQ(log[i].angle_increment, scans[i].angle_increment);
    EXPECT_EQ(log[i].T_odom_robot->x, scans[i].T_odom_robot->x);
    EXPECT_NEAR(log[i].T_robot_laser.x, 0.123, 1e-12);
    EXPECT_NEAR(std::abs(log[i].T_robot_laser.theta), pi, 1e-12);
    for (std::size_t beam = 0; beam < scans[i].ranges.size(); ++beam) {
      const bool returned = is_return(scans[i], scans[i].ranges[beam]);
      EXPECT_EQ(is_return(log[i], log[i].ranges[beam]), returned) << beam;
      if (!returned) continue;
      EXPECT_EQ(log[i].ranges[beam], scans[i].ranges[beam]);
    }
  }
  EXPECT_TRUE(log.warnings.empty()) << log.warnings[0];
}

TEST(CarmenLog, ScansWithoutOdometryComeBackWithout) {
  std::vector<LaserScan> scans = some_scans();
  for (LaserScan& scan : scans) scan.T_odom_robot.reset();
  const ScanLog log = parse_carmen_log(carmen_log_text(scans), "run.clf");
  EXPECT_FALSE(log[0].T_odom_robot);
  EXPECT_NEAR(log[0].T_robot_laser.x, 0.123, 1e-12);
}

TEST(CarmenLog, RefusesToWriteWhatIsNoScan) {
  std::vector<LaserScan> scans = some_scans();
  scans[1].ranges.clear();
  expect_error([&] { carmen_log_text(scans); }, "CARMEN log", "scan 1 has no beams");
  scans = some_scans();
  scans[0].angle_increment = 0.0;
  expect_error([&] { carmen_log_text(scans); }, "CARMEN log", "scan 0 has an angle_increment");
}

}  // namespace
}  // namespace slamicp::carmen_log_test
