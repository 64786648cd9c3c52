// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <slamicp/io/scan_log.hpp>

#include "io/io_test_support.hpp"
#include "support/bag_writer.hpp"

namespace slamicp::ros_log_test {
namespace {

using io_test::expect_error;
using io_test::put;
using io_test::TemporaryFolder;
using test::pose3;
using test::ScanMessage;

constexpr double pi = std::numbers::pi;

bool has_warning(const ScanLog& log, std::string_view words) {
  return std::any_of(log.warnings.begin(), log.warnings.end(),
                     [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

void expect_near(const Pose2& a, const Pose2& b, double most = 1e-6) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(wrap_angle(a.theta - b.theta), 0.0, most);
}

/// A recording being written.
class RosLog : public ::testing::Test {
 protected:
  void scan(const ScanMessage& message, const std::string& topic = "/scan") {
    write(topic, "sensor_msgs/LaserScan", message.stamp, message.message());
  }
  /// Scans at 0.1, 0.2, ... s after 100 s.
  void scans(int count, ScanMessage message = {}, const std::string& topic = "/scan") {
    for (int i = 0; i < count; ++i) {
      message.stamp = 100.0 + 0.1 * i;
      scan(message, topic);
    }
  }
  void odometry(double stamp, const Pose3& pose, const std::string& child = "base_link",
                const std::string& topic = "/odom") {
    write(topic, "nav_msgs/Odometry", stamp, test::ros1_odometry(stamp, pose, child));
  }
  void transform(double stamp, const char* frame, const char* child, const Pose3& pose, const char* topic = "/tf") {
    write(topic, "tf2_msgs/TFMessage", stamp, test::ros1_transform(stamp, frame, child, pose));
  }
  void write(const std::string& topic, const std::string& type, double stamp, std::string_view body) {
    auto connection = connections_.find(topic);
    if (connection == connections_.end())
      connection = connections_.emplace(topic, writer_.connection(topic, type)).first;
    writer_.message(connection->second, stamp, body);
  }

  ScanLog open(const ScanLogOptions& options = {}) {
    put(path(), writer_.bag());
    return open_scan_log(path(), options);
  }
  std::filesystem::path path() const { return folder_ / "run.bag"; }

 private:
  TemporaryFolder folder_;
  test::BagWriter writer_;
  std::map<std::string, std::uint32_t> connections_;
};

using RosLogTopics = RosLog;
using RosLogLasers = RosLog;
using RosLogOdometry = RosLog;
using RosLogScans = RosLog;

TEST_F(RosLogTopics, TheOnlyOneIsTaken) {
  scans(3, {}, "/base_scan");
  write("/cmd_vel", "geometry_msgs/Twist", 100.0, "not looked at");
  const ScanLog log = open();
  EXPECT_EQ(log.format, "ROS 1 bag");
  EXPECT_EQ(log.size(), 3U);
  EXPECT_EQ(log.lasers, std::vector<std::string>{"/base_scan"});
  EXPECT_EQ(log.messages.at("/base_scan (sensor_msgs/LaserScan)"), 3U);
  EXPECT_EQ(log.messages.at("/cmd_vel (geometry_msgs/Twist)"), 1U);
  EXPECT_TRUE(log.warnings.empty());
}

TEST_F(RosLogTopics, OfSeveralTheOneNamedScan) {
  scans(2, {}, "/robot/scan");
  scans(3, {}, "/robot/scan_filtered");
  EXPECT_EQ(open().size(), 2U);
  EXPECT_EQ(open({.scan_topics = {"robot/scan_filtered"}}).size(), 3U);
}

TEST_F(RosLogTopics, ThatAreInDoubtAreNamed) {
  scans(2, {}, "/front");
  scans(2, {}, "/rear");
  odometry(100.0, Pose3());
  expect_error([&] { open(); }, path().string(), "holds scans of 2 topics: /front, /rear");
  expect_error([&] { open({.scan_topics = {"/side"}}); }, path().string(), "has no topic '/side'");
  expect_error([&] { open({.scan_topics = {"/odom"}}); }, path().string(), "/odom (nav_msgs/Odometry) is of another");
  expect_error([&] { open({.scan_topics = {"/front"}, .odometry_topic = "/front"}); }, path().string(),
               "/front (sensor_msgs/LaserScan) is of another");
  try {
    open({.scan_topics = {"/side"}});
  } catch (const Error& error) {
    EXPECT_EQ(error.mend(), "choose among /front, /rear");
  }
}

TEST_F(RosLogTopics, SeveralBecomeOneLogInTheOrderOfTheirStamps) {
  for (const double stamp : {100.0, 100.2, 100.4}) scan({.stamp = stamp}, "/front");
  for (const double stamp : {100.1, 100.3}) scan({.stamp = stamp}, "/rear");
  const ScanLog log = open({.scan_topics = {"rear", "/front"}});
  ASSERT_EQ(log.size(), 5U);
  EXPECT_EQ(log.lasers, (std::vector<std::string>{"/rear", "/front"}));
  for (std::size_t i = 0; i < log.size(); ++i) {
    EXPECT_NEAR(log[i].stamp, 100.0 + 0.1 * static_cast<double>(i), 1e-6);
    EXPECT_EQ(log[i].laser, i % 2 == 0 ? 1 : 0);
  }
}

TEST_F(RosLogTopics, WithoutScansAreListed) {
  write("/points", "sensor_msgs/PointCloud2", 100.0, "");
  write("/chat", "std_msgs/String", 100.0, "");
  expect_error([&] { open(); }, path().string(),
               "holds no scan; topics: /points (sensor_msgs/PointCloud2), /chat (std_msgs/String)");
}

TEST_F(RosLogLasers, SitWhereTfSaysOverSeveralFrames) {
  transform(100.0, "base_footprint", "/base_link", pose3(0.0, 0.0, 0.1, 0.0, 0.0, 0.0), "/tf_static");
  transform(100.0, "base_link", "tower", pose3(0.2, 0.1, 0.0, 0.0, 0.0, pi / 2), "/tf_static");
  transform(100.0, "tower", "laser", pose3(0.5, 0.0, 0.3, 0.0, 0.0, 0.0));
  odometry(100.0, Pose3(), "/base_footprint");
  scans(2, {.frame = "/laser"});
  const ScanLog log = open();
  expect_near(log[0].T_robot_laser, {0.2, 0.6, pi / 2});
  EXPECT_EQ(log[0].angle_min, -1.0);
  expect_near(open({.base_frame = "tower"})[0].T_robot_laser, {0.5, 0.0, 0.0});
  expect_error([&] { open({.base_frame = "nowhere"}); }, path().string(), "has no frame 'nowhere'");
}

TEST_F(RosLogLasers, ThatTfDoesNotKnowAreToldOf) {
  odometry(100.0, Pose3());
  scans(2);
  const ScanLog log = open();
  EXPECT_TRUE(has_warning(log,
                          "no transform from 'laser' to 'base_link': the laser is taken to sit at the robot's centre; "
                          "give --laser-offset"));
  expect_near(log[0].T_robot_laser, {});
  const ScanLog mended = open({.laser_offset = Pose2{0.1, 0.2, 0.3}});
  EXPECT_FALSE(has_warning(mended, "no transform"));
  expect_near(mended[0].T_robot_laser, {0.1, 0.2, 0.3});
}

TEST_F(RosLogLasers, UpsideDownTurnTheOtherWay) {
  const Pose3 T_base_laser = pose3(0.3, -0.1, 0.4, pi, 0.0, 0.7);
  transform(100.0, "base_link", "laser", T_base_laser, "/tf_static");
  scans(2);
  const ScanLog log = open();
  const LaserScan& scan = log[0];
  EXPECT_EQ(scan.angle_increment, -0.5);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const auto range = static_cast<double>(scan.ranges[i]);
    const double as_recorded = -1.0 + 0.5 * static_cast<double>(i);
    const Point3 wanted = T_base_laser * Point3(range * std::cos(as_recorded), range * std::sin(as_recorded), 0.0);
    const double angle = scan.angle_min + scan.angle_increment * static_cast<double>(i);
    const Point2 found = scan.T_robot_laser * Point2(range * std::cos(angle), range * std::sin(angle));
    EXPECT_NEAR(found.x(), wanted.x(), 1e-9);
    EXPECT_NEAR(found.y(), wanted.y(), 1e-9);
  }
  EXPECT_FALSE(has_warning(log, "tilted"));
}

TEST_F(RosLogLasers, TiltedOrMovingAreToldOf) {
  transform(100.0, "base_link", "neck", pose3(0.1, 0.0, 0.0));
  transform(101.0, "base_link", "neck", pose3(0.1, 0.0, 0.5));
  transform(100.0, "neck", "laser", pose3(0.0, 0.0, 0.0, 0.0, 0.1, 0.0));
  scans(2);
  const ScanLog log = open();
  EXPECT_TRUE(has_warning(log, "from 'laser' to 'base_link' changes: the first is used"));
  EXPECT_TRUE(has_warning(log, "laser 'laser' is tilted by 5.7 deg: it is taken as level"));
  expect_near(log[0].T_robot_laser, {0.1, 0.0, 0.0});
}

TEST_F(RosLogLasers, FramesInARingAreNoTrap) {
  transform(100.0, "a", "b", Pose3());
  transform(100.0, "b", "a", Pose3());
  transform(100.0, "a", "laser", Pose3());
  transform(100.0, "world", "base_link", Pose3());
  transform(100.0, "b", "base_link", Pose3());
  scans(1);
  const ScanLog log = open();
  EXPECT_TRUE(has_warning(log, "no transform from 'laser' to 'base_link'"));
  EXPECT_TRUE(has_warning(log, "frame 'base_link' has several parents in tf: the first is used"));
}

TEST_F(RosLogOdometry, IsThatOfTheScansStamp) {
  odometry(99.9, pose3(0.0, 0.0, 0.0));
  odometry(100.1, pose3(0.2, 0.0, 0.0));
  odometry(100.3, pose3(0.2, 0.0, 1.0));
  scans(4, {.time_increment = 0.01});
  const ScanLog log = open({.laser_offset = Pose2{}});
  expect_near(*log[0].T_odom_robot, {0.1, 0.0, 0.0});
  expect_near(*log[1].T_odom_robot, {0.2, 0.0, 0.0});
  expect_near(*log[2].T_odom_robot, {0.2, 0.0, 0.5});
  expect_near(*log[0].sweep_motion, {0.04, 0.0, 0.0});
  expect_near(*log[1].sweep_motion, {0.0, 0.0, 0.2});
  EXPECT_TRUE(log.warnings.empty());
}

TEST_F(RosLogOdometry, GoesOnForATenthOfASecondAtMost) {
  odometry(100.1, pose3(0.1, 0.0, 0.0));
  odometry(100.2, pose3(0.2, 0.0, 0.0));
  scans(5);  // 100.0 .. 100.4
  const ScanLog log = open({.laser_offset = Pose2{}});
  EXPECT_NEAR(log[0].T_odom_robot->x, 0.0, 1e-6);
  EXPECT_NEAR(log[3].T_odom_robot.value_or(Pose2{}).x, 0.3, 1e-6);
  EXPECT_FALSE(log[4].T_odom_robot.has_value());
  EXPECT_FALSE(log[4].sweep_motion.has_value());
  EXPECT_TRUE(has_warning(log, "odometry does not cover 1 of 5 scans"));
}

TEST_F(RosLogOdometry, IsThatOfTheBaseFrame) {
  transform(100.0, "base_link", "centre", pose3(1.0, 0.0, 0.0), "/tf_static");
  odometry(100.0, pose3(0.0, 0.0, pi / 2));
  odometry(100.1, pose3(0.0, 0.0, pi / 2));
  scans(2, {.frame = "base_link"});
  const ScanLog log = open({.base_frame = "centre"});
  expect_near(*log[0].T_odom_robot, {0.0, 1.0, pi / 2});
  expect_near(log[0].T_robot_laser, {-1.0, 0.0, 0.0});
}

TEST_F(RosLogOdometry, ComesFromTfWhereThereIsNoTopic) {
  for (int i = 0; i < 5; ++i) transform(100.0 + 0.1 * i, "odom", "base_footprint", pose3(0.1 * i, 0.0, 0.2 * i));
  transform(100.0, "base_footprint", "base_link", pose3(0.0, 0.0, 0.1, 0.0, 0.0, 0.0));
  transform(100.0, "base_link", "laser", pose3(0.2, 0.0, 0.0));
  transform(100.0, "map", "odom", pose3(5.0, 5.0, 1.0));
  scans(5);
  const ScanLog log = open();
  EXPECT_TRUE(has_warning(log, "odometry is taken from tf, 'odom' to 'base_footprint'"));
  expect_near(*log[3].T_odom_robot, {0.3, 0.0, 0.6});
  expect_near(log[3].T_robot_laser, {0.2, 0.0, 0.0});
}

TEST_F(RosLogOdometry, OfSeveralTopicsIsTheOneNamedOdom) {
  odometry(100.0, pose3(1.0, 0.0, 0.0), "base_link", "/odom");
  odometry(100.0, pose3(2.0, 0.0, 0.0), "base_link", "/visual");
  scans(1);
  EXPECT_EQ(open()[0].T_odom_robot->x, 1.0);
  EXPECT_EQ(open({.odometry_topic = "visual"})[0].T_odom_robot->x, 2.0);
  odometry(100.0, pose3(3.0, 0.0, 0.0), "base_link", "/a/odom");
  EXPECT_EQ(open()[0].T_odom_robot->x, 1.0);
}

TEST_F(RosLogOdometry, OfSeveralTopicsInDoubtIsNone) {
  odometry(100.0, pose3(1.0, 0.0, 0.0), "base_link", "/wheels");
  odometry(100.0, pose3(2.0, 0.0, 0.0), "base_link", "/visual");
  scans(1);
  const ScanLog log = open();
  EXPECT_FALSE(log[0].T_odom_robot.has_value());
  EXPECT_TRUE(has_warning(log, "several topics, /wheels, /visual: none is used; name one by --odometry-topic"));
}

TEST_F(RosLogScans, ThatAreBrokenAreLeftOut) {
  scans(3);
  scan({.stamp = 100.3, .angle_increment = 0.0});
  write("/scan", "sensor_msgs/LaserScan", 100.4, "cut");
  const ScanLog log = open();
  EXPECT_EQ(log.size(), 3U);
  EXPECT_TRUE(has_warning(log, "2 of 5 messages of /scan left out: a scan's 5 beams all have one direction"));
}

TEST_F(RosLogScans, ThatAreAllBrokenAreAnError) {
  scan({.stamp = 100.0, .angle_increment = 0.0});
  expect_error([&] { open(); }, path().string(), "holds no scan (a scan's 5 beams all have one direction");
  expect_error([&] { open({.scan_topics = {"scan"}}); }, path().string(),
               "no message of /scan (sensor_msgs/LaserScan)");
}

TEST_F(RosLogScans, WithoutAStampGetThatOfTheRecording) {
  write("/scan", "sensor_msgs/LaserScan", 123.25, ScanMessage{.stamp = 0.0}.message());
  const ScanLog log = open();
  EXPECT_EQ(log[0].stamp, 123.25);
  EXPECT_TRUE(has_warning(log, "1 of 1 message of /scan without a stamp: stamped as recorded"));
}

TEST_F(RosLogScans, WithImpossibleBeamTimesHaveNone) {
  scans(5, {.time_increment = 0.1});  // 0.4 s a sweep, every 0.1 s
  const ScanLog log = open();
  EXPECT_EQ(log[0].time_increment, 0.0);
  EXPECT_TRUE(has_warning(log, "/scan: a sweep should take 0.4 s, but scans come every 0.1 s"));
}

TEST_F(RosLogScans, ThatRunBackwardsAreToldOf) {
  scan({.stamp = 100.0});
  scan({.stamp = 99.5});
  EXPECT_TRUE(has_warning(open(), "1 stamp runs backwards, by up to 0.500 s"));
}

TEST_F(RosLogScans, BecomeCarmenAndBack) {
  transform(100.0, "base_link", "laser", pose3(0.2, 0.0, 0.1), "/tf_static");
  odometry(99.0, pose3(1.0, 2.0, 0.5));
  odometry(101.0, pose3(2.0, 2.0, 0.5));
  scans(3);
  const ScanLog log = open();
  const std::filesystem::path carmen = path().parent_path() / "run.clf";
  save_scan_log(carmen, log.scans);
  const ScanLog back = open_scan_log(carmen);
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(back[2].ranges, log[2].ranges);
  EXPECT_NEAR(back[2].stamp, log[2].stamp, 1e-6);
  expect_near(*back[2].T_odom_robot, *log[2].T_odom_robot, 1e-5);
  expect_near(back[2].T_robot_laser, log[2].T_robot_laser, 2e-4);
}

}  // namespace
}  // namespace slamicp::ros_log_test
