// SPDX-License-Identifier: Apache-2.0
#include "io/cdr.hpp"

#include <gtest/gtest.h>

#include "io/io_test_support.hpp"
#include "support/cdr_writer.hpp"

namespace slamicp::cdr_test {
namespace {

using io_test::expect_error;
using ros::CdrReader;
using test::CdrWriter;

const std::string where = "run.db3, /scan";

#ifdef SLAMICP_WITH_CDR

class Cdr : public ::testing::TestWithParam<bool> {
 protected:
  static bool big_endian() { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(ByteOrders, Cdr, ::testing::Bool(),
                         [](const auto& order) { return order.param ? "BigEndian" : "LittleEndian"; });

TEST_P(Cdr, FieldsAreAlignedAndComeAsWritten) {
  CdrWriter out(big_endian());
  out.u8(200).u32(4'000'000'000U).u8(1).f64(-1.5e300).u8(7).f32(0.25F).i32(-2).string("laser").f64(3.25).string("");
  out.floats({1.0F, 2.5F}).u8(9).bytes("ab\0c").u32(5).floats({}).f64(8.0);
  CdrReader in(out.message(), where);
  EXPECT_EQ(in.u8(), 200);
  EXPECT_EQ(in.u32(), 4'000'000'000U);
  EXPECT_TRUE(in.boolean());
  EXPECT_EQ(in.f64(), -1.5e300);
  EXPECT_EQ(in.u8(), 7);
  EXPECT_EQ(in.f32(), 0.25F);
  EXPECT_EQ(in.i32(), -2);
  EXPECT_EQ(in.string(), "laser");
  EXPECT_EQ(in.f64(), 3.25);
  EXPECT_EQ(in.string(), "");
  std::vector<float> numbers;
  in.floats(numbers);
  EXPECT_EQ(numbers, (std::vector<float>{1.0F, 2.5F}));
  EXPECT_EQ(in.u8(), 9);
  EXPECT_EQ(in.bytes(), "ab");  // the literal ends there
  EXPECT_EQ(in.u32(), 5U);
  in.floats(numbers);
  EXPECT_TRUE(numbers.empty());
  EXPECT_EQ(in.f64(), 8.0);
  EXPECT_EQ(in.remaining(), 0U);
}

TEST_P(Cdr, HeaderHasStampAndFrame) {
  const std::string message = CdrWriter(big_endian()).header(-1, 250'000'000, "map").message();
  const ros::Header header = CdrReader(message, where).header();
  EXPECT_DOUBLE_EQ(header.stamp, -0.75);
  EXPECT_EQ(header.frame, "map");
}

TEST_P(Cdr, ALaserScanComesAsWritten) {
  const std::string message = test::laser_scan_message(3, {1.0F, 2.0F, 0.5F}, big_endian());
  const ros::LaserScan read = ros::read_laser_scan(Serialization::cdr, message, where);
  EXPECT_EQ(read.header.frame, "laser");
  EXPECT_DOUBLE_EQ(read.scan.stamp, 3.5);
  EXPECT_EQ(read.scan.ranges, (std::vector<float>{1.0F, 2.0F, 0.5F}));
  EXPECT_NEAR(read.scan.angle_increment, 0.0174532925, 1e-8);
  EXPECT_FLOAT_EQ(static_cast<float>(read.scan.range_max), 30.0F);
  EXPECT_FLOAT_EQ(static_cast<float>(read.scan_time), 0.1F);
}

TEST_P(Cdr, OdometryTransformsAndCloudsComeAsWritten) {
  const ros::Odometry odometry =
      ros::read_odometry(Serialization::cdr, test::odometry_message(5, 1.5, -2.0, big_endian()), where);
  EXPECT_EQ(odometry.child_frame, "base_link");
  EXPECT_EQ(odometry.pose.position, Point3(1.5, -2.0, 0.0));
  const auto transforms = ros::read_transforms(
      Serialization::cdr, test::transform_message("base_link", "laser", 0.2, 0.1, big_endian()), where);
  ASSERT_EQ(transforms.size(), 1U);
  EXPECT_EQ(transforms[0].child_frame, "laser");
  EXPECT_EQ(transforms[0].pose.position, Point3(0.2, 0.1, 0.0));
  const ros::PointCloud cloud = ros::read_point_cloud(
      Serialization::cdr, test::point_cloud_message({1.0F, 2.0F, 3.0F, 4.0F}, big_endian()), where);
  ASSERT_EQ(cloud.points.size(), 2U);
  EXPECT_EQ(cloud.points[1], Point3(3.0, 4.0, 0.0));
}

TEST_P(Cdr, CutAnywhereIsAnError) {
  const std::string whole = test::laser_scan_message(3, {1.0F, 2.0F, 0.5F}, big_endian());
  const std::size_t needed = whole.size() - 4;  // the empty intensities are not looked at
  for (std::size_t size = 0; size < needed; ++size)
    expect_error([&] { ros::read_laser_scan(Serialization::cdr, whole.substr(0, size), where); }, where, "message");
  EXPECT_NO_THROW(ros::read_laser_scan(Serialization::cdr, whole.substr(0, needed), where));
}

TEST_P(Cdr, AbsurdLengthsAreNotBelieved) {
  const std::string message = CdrWriter(big_endian()).u32(0xFFFFFFFFU).u32(1).message();
  expect_error([&] { CdrReader(message, where).string(); }, where, "4294967295 elements");
  expect_error([&] { CdrReader(message, where).bytes(); }, where, "do not fit into 4 bytes");
  std::vector<float> numbers;
  expect_error([&] { CdrReader(message, where).floats(numbers); }, where, "4294967295 elements");
  const std::string two = CdrWriter(big_endian()).u32(2).f32(1.0F).message();
  expect_error([&] { CdrReader(two, where).floats(numbers); }, where, "2 elements");
}

TEST_P(Cdr, ABooleanIsZeroOrOne) {
  const std::string message = CdrWriter(big_endian()).u8(2).message();
  expect_error([&] { CdrReader(message, where).boolean(); }, where, "broken field");
}

TEST(CdrHeader, OtherRepresentationsAreNamed) {
  const std::string parameter_list("\0\3\0\0\0\0\0\0", 8);
  expect_error([&] { CdrReader(parameter_list, where).u32(); }, where, "no plain CDR");
  expect_error([&] { CdrReader("", where).u32(); }, where, "hold no header");
}

#else

TEST(Cdr, ABuildWithoutItSaysSo) {
  const std::string message = CdrWriter().u32(1).message();
  expect_error([&] { CdrReader(message, where).u32(); }, where, "built without Fast-CDR");
}

#endif

}  // namespace
}  // namespace slamicp::cdr_test
