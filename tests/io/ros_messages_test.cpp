// SPDX-License-Identifier: Apache-2.0
#include "io/ros_messages.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "io/io_test_support.hpp"
#include "support/ros1_writer.hpp"

namespace slamicp::ros_messages_test {
namespace {

using io_test::expect_error;
using ros::read_laser_scan;
using ros::read_odometry;
using ros::read_point_cloud;
using ros::read_transforms;
using test::pose3;
using test::Ros1Writer;
using test::ScanMessage;

constexpr const char* where = "run.bag";
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

ros::LaserScan read(const ScanMessage& scan) { return read_laser_scan(Serialization::ros1, scan.message(), where); }

TEST(RosLaserScan, ComesWithAllOfIt) {
  const ScanMessage wanted{.stamp = 1600000000.125,
                           .frame = "front_laser",
                           .angle_min = -2.0,
                           .angle_increment = 0.25,
                           .time_increment = 0.001,
                           .scan_time = 0.05,
                           .range_min = 0.25,
                           .range_max = 8.0,
                           .ranges = {1.5F, nan, 3.0F}};
  const ros::LaserScan message = read(wanted);
  EXPECT_EQ(message.header.frame, "front_laser");
  EXPECT_EQ(message.header.stamp, 1600000000.125);
  EXPECT_EQ(message.scan.stamp, 1600000000.125);
  EXPECT_EQ(message.scan.angle_min, -2.0);
  EXPECT_EQ(message.angle_max, -1.5);
  EXPECT_EQ(message.scan.angle_increment, 0.25);
  EXPECT_NEAR(message.scan.time_increment, 0.001, 1e-9);
  EXPECT_NEAR(message.scan_time, 0.05, 1e-8);
  EXPECT_EQ(message.scan.range_min, 0.25);
  EXPECT_EQ(message.scan.range_max, 8.0);
  ASSERT_EQ(message.scan.ranges.size(), 3U);
  EXPECT_EQ(message.scan.ranges[2], 3.0F);
  EXPECT_TRUE(std::isnan(message.scan.ranges[1]));
}

TEST(RosLaserScan, LimitsThatSayNothingAreNone) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(read({.range_min = 0.0, .range_max = 0.0}).scan.range_max, LaserScan().range_max);
  EXPECT_EQ(read({.range_min = std::nan(""), .range_max = std::nan("")}).scan.range_min, 0.0);
  EXPECT_EQ(read({.range_max = std::nan("")}).scan.range_max, LaserScan().range_max);
  EXPECT_EQ(read({.range_max = infinity}).scan.range_max, infinity);
  EXPECT_EQ(read({.time_increment = std::nan("")}).scan.time_increment, 0.0);
}

TEST(RosLaserScan, WithoutDirectionsIsAnError) {
  expect_error([] { read({.angle_increment = 0.0}); }, where, "5 beams all have one direction");
  expect_error([] { read({.angle_min = std::nan("")}); }, where, "angles are not finite");
  expect_error([] { read({.angle_increment = std::nan("")}); }, where, "angles are not finite");
  EXPECT_EQ(read({.angle_increment = 0.0, .ranges = {1.0F}}).scan.ranges.size(), 1U);
  EXPECT_TRUE(read({.angle_increment = 0.0, .ranges = {}}).scan.ranges.empty());
}

TEST(RosLaserScan, CutAnywhereBeforeTheIntensitiesIsAnError) {
  const std::string message = ScanMessage().message();
  const std::size_t intensities = message.size() - 4 - 5 * 4;
  for (std::size_t size = 0; size < intensities; ++size)
    EXPECT_THROW(read_laser_scan(Serialization::ros1, std::string_view(message).substr(0, size), where), Error) << size;
  EXPECT_NO_THROW(read_laser_scan(Serialization::ros1, std::string_view(message).substr(0, intensities), where));
}

TEST(RosOdometry, ComesWithItsPoseAndFrames) {
  const Pose3 pose = pose3(1.0, -2.0, 0.5, 0.1, 0.2, 2.5);
  const ros::Odometry message =
      read_odometry(Serialization::ros1, test::ros1_odometry(12.5, pose, "base_footprint"), where);
  EXPECT_EQ(message.header.frame, "odom");
  EXPECT_EQ(message.child_frame, "base_footprint");
  EXPECT_EQ(message.header.stamp, 12.5);
  EXPECT_NEAR(distance(message.pose, pose).translation, 0.0, 1e-12);
  EXPECT_NEAR(distance(message.pose, pose).rotation, 0.0, 1e-7);
}

TEST(RosOdometry, WithoutARotationIsAnError) {
  Pose3 pose;
  pose.orientation = Pose3::Quaternion(0.0, 0.0, 0.0, 0.0);
  expect_error([&] { read_odometry(Serialization::ros1, test::ros1_odometry(1.0, pose), where); }, where,
               "quaternion is no rotation");
  pose = Pose3();
  pose.position.x() = std::nan("");
  expect_error([&] { read_odometry(Serialization::ros1, test::ros1_odometry(1.0, pose), where); }, where,
               "position is not finite");
}

TEST(RosTransforms, ComeAll) {
  Ros1Writer out;
  out.u32(2).header(1.0, "base").string("laser").pose(pose3(0.1, 0.2, 0.3));
  out.header(2.0, "odom").string("base").pose(pose3(1.0, 2.0, 3.0));
  const std::vector<ros::Transform> transforms = read_transforms(Serialization::ros1, out.message(), where);
  ASSERT_EQ(transforms.size(), 2U);
  EXPECT_EQ(transforms[0].header.frame, "base");
  EXPECT_EQ(transforms[0].child_frame, "laser");
  EXPECT_EQ(transforms[1].header.stamp, 2.0);
  EXPECT_EQ(transforms[1].pose.position.y(), 2.0);
  expect_error([] { read_transforms(Serialization::ros1, Ros1Writer().u32(4'000'000'000U).message(), where); }, where,
               "cut");
}

/// A PointCloud2 of x, y and z as float32 and float64 with a field between, two rows.
std::string cloud_message(std::uint32_t point_step, std::uint32_t row_step, std::uint32_t height,
                          std::string_view data) {
  Ros1Writer out;
  out.header(3.0, "lidar").u32(height).u32(2).u32(4);
  out.string("x").u32(0).u8(7).u32(1);
  out.string("rgb").u32(4).u8(6).u32(1);
  out.string("y").u32(8).u8(8).u32(1);
  out.string("z").u32(16).u8(7).u32(1);
  return out.u8(0).u32(point_step).u32(row_step).string(data).u8(1).message();
}

TEST(RosPointCloud, FindsItsFields) {
  Ros1Writer data;
  for (int i = 0; i < 4; ++i) {
    data.f32(i == 2 ? std::nan("") : i).u32(9).f64(10.0 + i).f32(20.0 + i);
    if (i == 1) data.u32(0);  // a row ends with four bytes more
  }
  const ros::PointCloud cloud = read_point_cloud(Serialization::ros1, cloud_message(20, 44, 2, data.message()), where);
  EXPECT_EQ(cloud.header.frame, "lidar");
  ASSERT_EQ(cloud.points.size(), 3U);
  EXPECT_EQ(cloud.points[1], Point3(1.0, 11.0, 21.0));
  EXPECT_EQ(cloud.points[2], Point3(3.0, 13.0, 23.0));
}

TEST(RosPointCloud, ThatCannotBeIsAnError) {
  const auto read_cloud = [](const std::string& message) { read_point_cloud(Serialization::ros1, message, where); };
  const std::string data(80, '\0');
  EXPECT_NO_THROW(read_cloud(cloud_message(20, 40, 2, data)));
  expect_error([&] { read_cloud(cloud_message(19, 40, 2, data)); }, where, "fields reach beyond its points");
  expect_error([&] { read_cloud(cloud_message(20, 39, 2, data)); }, where, "rows overlap");
  expect_error([&] { read_cloud(cloud_message(20, 41, 2, data)); }, where, "less data than its points need");
  expect_error([&] { read_cloud(cloud_message(20, 40, 0xFFFFFFFF, data)); }, where, "less data than its points need");
  expect_error([&] { read_cloud(cloud_message(0xFFFFFFFF, 0xFFFFFFFF, 1, data)); }, where, "less data");
  Ros1Writer flat;
  flat.header(3.0, "lidar").u32(1).u32(1).u32(1).string("x").u32(0).u8(7).u32(1).u8(0).u32(4).u32(4).string("1234");
  expect_error([&] { read_cloud(flat.message()); }, where, "has no field x or y");
}

}  // namespace
}  // namespace slamicp::ros_messages_test
