// SPDX-License-Identifier: Apache-2.0
// The mistakes of others (docs: LIBICP, small_gicp and every matcher with a constant gate), as tests of ours.
#include <gtest/gtest.h>

#include <slamicp/registration/icp.hpp>
#include <slamicp/scan/scan_points.hpp>

#include "support/clouds.hpp"
#include "support/room.hpp"

namespace slamicp::icp_gate_test {
namespace {

using test::wall;

constexpr Method methods[] = {Method::point_to_point, Method::point_to_line};

/// Two walls in a corner, seen exactly from the pose (1, 1, 0.2), and one more point somewhere in the map.
IcpResult2 match_with_one_more(const Point2& in_map, const IcpOptions& options) {
  PointCloud2 map = wall({0, 0}, {4, 0}, 0.01);
  test::append(map, wall({0, 0}, {0, 3}, 0.01));
  PointCloud2 seen = wall({0.5, 0}, {3.5, 0}, 0.01);
  test::append(seen, wall({0, 0.5}, {0, 2.5}, 0.01));
  seen.push_back(in_map);
  const Pose2 truth{1, 1, 0.2};
  const IcpResult2 result = Icp<2>(options).align(IndexedPoints<2>(map), test::transformed(truth.inverse(), seen),
                                                  {1.003, 0.998, 0.201}, Outputs::all());
  EXPECT_EQ(result.stop, Stop::converged);
  EXPECT_LT(distance(result.pose, truth).translation, 1e-3);
  return result;
}

PointClass class_of(const Point2& in_map, const IcpOptions& options) {
  return match_with_one_more(in_map, options).matches.back().point_class;
}

TEST(IcpGateTest, APointThreeMetresOffOnTheExtensionOfAWallIsAnOutlier) {
  for (const Method method : methods) {
    for (const Point2& off : {Point2(7, 0), Point2(0, 6), Point2(-3, 0)}) {
      const IcpResult2 result = match_with_one_more(off, {.method = method});
      EXPECT_EQ(result.matches.back().point_class, PointClass::outlier);
      EXPECT_EQ(result.outlier_indices.back(), static_cast<int>(result.matches.size()) - 1);
      EXPECT_EQ(result.inliers, result.matches.size() - 1);
    }
  }
}

TEST(IcpGateTest, BothSidesOfAWallCountAlike) {
  for (const Method method : methods) {
    for (const double side : {1.0, -1.0}) {
      EXPECT_EQ(class_of({2, side * 1.0}, {.method = method}), PointClass::outlier);
      EXPECT_EQ(class_of({2, side * 0.2}, {.method = method}), PointClass::inlier);
    }
  }
}

TEST(IcpGateTest, ThirtyCentimetresAreThirtyNotFiftyFive) {
  for (const Method method : methods) {
    EXPECT_EQ(class_of({2, -0.29}, {.method = method}), PointClass::inlier);
    EXPECT_EQ(class_of({2, -0.31}, {.method = method}), PointClass::outlier);
    EXPECT_EQ(class_of({2, -0.50}, {.method = method}), PointClass::outlier);
  }
}

TEST(IcpGateTest, BetweenTheTwoDistancesAPointIsNeitherOrBoth) {
  const IcpOptions apart{.max_correspondence_distance = 0.3, .outlier_distance = 0.6};
  EXPECT_EQ(class_of({2, -0.2}, apart), PointClass::inlier);
  EXPECT_EQ(class_of({2, -0.4}, apart), PointClass::neither);
  EXPECT_EQ(class_of({2, -0.7}, apart), PointClass::outlier);
  const IcpOptions overlapping{.max_correspondence_distance = 0.3, .outlier_distance = 0.1};
  EXPECT_EQ(class_of({2, -0.05}, overlapping), PointClass::inlier);
  EXPECT_EQ(class_of({2, -0.2}, overlapping), PointClass::both);
  EXPECT_EQ(class_of({2, -0.4}, overlapping), PointClass::outlier);
}

TEST(IcpGateTest, TheShrunkenGateDoesNotDecideWhatAnInlierIs) {
  // 0.2 m off: far beyond the solver's last gate of 5 cm, well within max_correspondence_distance.
  const IcpResult2 result = match_with_one_more({2, -0.2}, {.final_gate = 0.05});
  EXPECT_EQ(result.matches.back().point_class, PointClass::inlier);
  EXPECT_EQ(result.inliers, result.matches.size());
  EXPECT_LT(result.pairs, result.matches.size());
}

TEST(IcpGateTest, AnUnmappedBoxBesideAWallDoesNotPullThePose) {
  const test::Room room = test::simple_room();
  const PointCloud2 map = room.map(0.008);
  test::Room with_box = room;
  with_box.add_box({3.0, 0.14}, 1.2, 0.16, 0.0);  // its face stands 0.22 m before the wall: within the gate of 0.3 m
  const IndexedPoints<2> indexed(map);
  double shrinking = 0.0;
  double constant = 0.0;
  for (int k = 0; k < 10; ++k) {
    const Pose2 truth{1.0 + 0.4 * k, 2.0 + 0.05 * k, -1.5 + 0.1 * k};
    const ScanPoints scan = to_points(with_box.scan(truth));
    const Pose2 guess = truth * Pose2{0.04, -0.03, 0.02};
    const auto error = [&](const IcpOptions& options) {
      return distance(Icp<2>(options).align(indexed, scan.in_robot, guess).pose, truth).translation;
    };
    shrinking = std::max(shrinking, error({}));
    constant = std::max(constant, error({.final_gate = 0.3}));
  }
  EXPECT_LT(shrinking, 0.002);
  EXPECT_GT(constant, 0.010) << "else this test shows nothing";
}

}  // namespace
}  // namespace slamicp::icp_gate_test
