// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <slamicp/io/relations_file.hpp>
#include <slamicp/io/trajectory_file.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::trajectory_file_test {
namespace {

using io_test::expect_error;

TEST(TrajectoryFile, RoundTrips) {
  const io_test::TemporaryFolder folder;
  Trajectory trajectory;
  for (int i = 0; i < 100; ++i)
    trajectory.push_back({976052905.167303 + i, {0.1 * i, 10000.123456, wrap_angle(0.1 * i)}});
  trajectory.push_back({0.0, {-1e-9, -2.0, 3.14159265358979}});
  save_trajectory(folder / "a.tum", trajectory);
  const Trajectory back = load_trajectory(folder / "a.tum");
  ASSERT_EQ(back.size(), trajectory.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_NEAR(back[i].stamp, trajectory[i].stamp, 1e-6);
    EXPECT_NEAR(back[i].pose.x, trajectory[i].pose.x, 1e-6);
    EXPECT_NEAR(back[i].pose.y, trajectory[i].pose.y, 1e-6);
    EXPECT_NEAR(wrap_angle(back[i].pose.theta - trajectory[i].pose.theta), 0.0, 1e-8);
  }
  EXPECT_EQ(back[0].stamp, 976052905.167303) << "relations are looked up by equal stamps";
}

TEST(TrajectoryFile, WritesTheFormatToTheLetter) {
  const Trajectory trajectory{{1.5, {1.0, -0.0, 0.0}}};
  EXPECT_EQ(trajectory_text(trajectory), "1.500000 1.000000 0.000000 0 0 0 0.000000000 1.000000000\n");
}

TEST(TrajectoryFile, ReadsCommentsCommasCrlfAndNoFinalNewline) {
  const Trajectory trajectory =
      parse_trajectory("# stamp x y z\r\n\r\n1,2,3,0,0,0,0,1\r\n 2  3 4 9 0 0 0.70710678 0.70710678", "a.tum");
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_NEAR(trajectory[1].pose.theta, std::numbers::pi / 2, 1e-8);
  EXPECT_TRUE(parse_trajectory("", "a.tum").empty());
  EXPECT_TRUE(parse_trajectory("# header only\n", "a.tum").empty());
}

TEST(TrajectoryFile, Mistakes) {
  const auto fails = [](const char* line, std::string_view what) {
    expect_error([&] { parse_trajectory(std::string("# header\n") + line, "a.tum"); }, "a.tum:2", what);
  };
  fails("1 2 3 0 0 0 1", "7 values, not 8");
  fails("1 2 3 0 0 0 0 1 5", "9 values, not 8");
  fails("1 2 x 0 0 0 0 1", "value 3 is not a number: 'x'");
  fails("1 2 nan 0 0 0 0 1", "value 3 is not a number: 'nan'");
  fails("1 2 3 0 0 0 0 0", "not of length 1");
  const Trajectory broken{{1.0, {NAN, 0.0, 0.0}}};
  expect_error([&] { trajectory_text(broken); }, "trajectory", "pose 0 is not finite");
}

TEST(RelationsFile, ReadsAndRefuses) {
  const std::vector<Relation> relations = parse_relations("1.5 2.5 1 2 0 0 0 0.5\r\n3 4 1 2 0 0 0 4\n", "a.relations");
  ASSERT_EQ(relations.size(), 2U);
  EXPECT_EQ(relations[0].stamp_a, 1.5);
  EXPECT_EQ(relations[0].stamp_b, 2.5);
  EXPECT_EQ(relations[0].T_a_b.y, 2.0);
  EXPECT_EQ(relations[0].T_a_b.theta, 0.5);
  EXPECT_LT(relations[1].T_a_b.theta, 0.0);
  expect_error([] { parse_relations("1 2 3\n", "a.relations"); }, "a.relations:1", "3 values, not 8");
}

}  // namespace
}  // namespace slamicp::trajectory_file_test
