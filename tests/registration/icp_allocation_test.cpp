// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/registration/icp.hpp>

#include "support/allocations.hpp"
#include "support/room.hpp"

namespace slamicp::icp_allocation_test {
namespace {

using test::Random;

/// A corridor of many tiles, and what a robot in it sees.
struct Corridor {
  test::Room room;
  IndexedPoints<2> map;

  Corridor() {
    room.walls = {{{-5.0, 0.0}, {60.0, 0.0}}, {{-5.0, 2.5}, {60.0, 2.5}}, {{-5.0, 0.0}, {-5.0, 2.5}}};
    for (int k = 0; k < 12; ++k) room.add_box({5.0 * k, k % 2 == 0 ? 0.4 : 2.1}, 0.3, 0.4, 0.2 * k);
    map = IndexedPoints<2>(room.map(0.03));
  }

  /// Some of it nothing that the map knows.
  PointCloud2 scan(const Pose2& pose, int size) const {
    PointCloud2 points;
    for (int i = 0; i < size; ++i) {
      const double angle = 2.0 * test::pi * i / size;
      const double range = (i % 7 == 0 ? 0.5 : 1.0) * room.range(pose, angle);
      points.emplace_back(range * std::cos(angle), range * std::sin(angle));
    }
    points[5].setConstant(test::nan);
    points[6] = {1e300, 0.0};
    return points;
  }
};

std::vector<InstructionSet> all_sets() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::portable, InstructionSet::sse4,
                                   InstructionSet::avx2, InstructionSet::avx512, InstructionSet::neon})
    if (is_available(set)) sets.push_back(set);
  return sets;
}

class IcpAllocationTest : public ::testing::TestWithParam<InstructionSet> {};

TEST_P(IcpAllocationTest, AfterTheFirstScanOfASizeNothing) {
  const Corridor corridor;
  for (const Method method : {Method::point_to_point, Method::point_to_line}) {
    Icp<2> icp({.method = method, .instruction_set = GetParam()});
    const Outputs wanted{.outlier_indices = true, .outliers_in_map = true};
    const auto allocations_at = [&](const IndexedPoints<2>& map, const Pose2& pose, int size) {
      const PointCloud2 scan = corridor.scan(pose, size);
      return test::allocations_of([&] { icp.align(map, scan, pose * Pose2{0.02, -0.01, 0.01}, wanted); });
    };
    EXPECT_GT(allocations_at(corridor.map, {-4.0, 1.2, 0.0}, 541), 0) << "else nothing was counted";
    for (int k = 0; k < 120; k += test::one_in) {  // across tiles of 0.8 m, and out of the first window of them
      ASSERT_EQ(allocations_at(corridor.map, {-4.0 + 0.45 * k, 1.2, 0.05 * k}, 541 - k), 0) << k;
      ASSERT_TRUE(icp.result().usable()) << k;
      ASSERT_GT(icp.result().outlier_indices.size(), 20U);
    }
    EXPECT_EQ(allocations_at(corridor.map, {400.0, -300.0, 1.0}, 541), 0) << "nothing there, all outliers";
    EXPECT_EQ(icp.result().stop, Stop::no_overlap);
    EXPECT_GT(icp.result().outlier_indices.size(), 500U);

    // Another map, and another.
    IndexedPoints<2> grown = corridor.map;
    for (int k = 0; k < 10; ++k) {
      const Pose2 pose{5.0 * k, 1.2, 0.3 * k};
      ASSERT_EQ(allocations_at(grown, pose, 541), 0);
      const std::size_t outliers = icp.result().outlier_indices.size();
      grown = grown.with_added(icp.result().outliers_in_map);
      ASSERT_EQ(allocations_at(grown, pose, 541), 0);
      ASSERT_LT(icp.result().outlier_indices.size(), outliers) << "the map was not the new one";
    }
    // One whose cells are built while it is in use.
    const IndexedPoints<2> lazy(to_cloud<2>(corridor.map.points()), {}, {.eager = false});
    do {
      ASSERT_EQ(allocations_at(lazy, {5.0, 1.2, 0.0}, 541), 0);
    } while (lazy.cells().build(10, {5.0, 1.2}) > 0);

    icp.reserve(2000);
    EXPECT_GT(allocations_at(corridor.map, {5.0, 1.2, 0.0}, 2000), -1);
    EXPECT_EQ(allocations_at(corridor.map, {25.0, 1.2, 0.0}, 2000), 0);
  }
}

TEST_P(IcpAllocationTest, NothingEitherWithAllThatCanBeAskedFor) {
  const Corridor corridor;
  Icp<2> icp({.instruction_set = GetParam()});
  for (int k = 0; k < 20; ++k) {
    const Pose2 pose{2.0 * k, 1.2, 0.1 * k};
    const PointCloud2 scan = corridor.scan(pose, 400 - 2 * k);
    const int count = test::allocations_of([&] { icp.align(corridor.map, scan, pose, Outputs::all()); });
    EXPECT_EQ(count > 0, k == 0) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, IcpAllocationTest, ::testing::ValuesIn(all_sets()),
                         [](const auto& set) { return std::string(to_string(set.param)); });

}  // namespace
}  // namespace slamicp::icp_allocation_test
