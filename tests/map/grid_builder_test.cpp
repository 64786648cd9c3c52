// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/map/grid_builder.hpp>

#include "support/random.hpp"
#include "support/room.hpp"

namespace slamicp::grid_builder_test {
namespace {

LaserScan one_ray(double range) {
  LaserScan scan;
  scan.range_max = 10.0;
  scan.ranges = {static_cast<float>(range)};
  return scan;
}

CellState state_at(const OccupancyGrid& grid, double x, double y) {
  const std::optional<Cell> cell = grid.cell_at({x, y});
  return cell ? grid.at(*cell) : CellState::unknown;
}

TEST(GridBuilderTest, ARayIsFreeOnItsWayAndOccupiedAtItsEnd) {
  GridBuilder builder({.grid = {.resolution = 0.1, .padding = 0.2}});
  builder.add(one_ray(1.0), {0.05, 0.05, 0.0});
  const OccupancyGrid grid = builder.grid();
  EXPECT_EQ(grid.problem(), "");
  for (int column = 0; column < 10; ++column) EXPECT_EQ(state_at(grid, 0.05 + 0.1 * column, 0.05), CellState::free);
  EXPECT_EQ(state_at(grid, 1.05, 0.05), CellState::occupied);
  EXPECT_EQ(state_at(grid, 1.15, 0.05), CellState::unknown);
  const CellCounts counts = count_cells(grid);
  EXPECT_EQ(counts.free, 10U);
  EXPECT_EQ(counts.occupied, 1U);
  EXPECT_EQ(grid.probability[grid.index(*grid.cell_at({1.05, 0.05}))], 1.0F);
  EXPECT_TRUE(std::isnan(grid.probability[0]));
}

/// Every cell that a densely sampled ray enters, and no other.
TEST(GridBuilderTest, RaysPassTheCellsTheyCross) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const double range = random.uniform(0.01, 3.0);
    const Pose2 pose{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3)};
    GridBuilder builder({.grid = {.resolution = 0.1}});
    builder.add(one_ray(range), pose);
    OccupancyGrid grid = builder.grid();
    constexpr int samples = 5000;
    std::size_t crossed = 0;
    for (int k = 0; k <= samples; ++k) {
      const Point2 point = pose * Point2(static_cast<double>(static_cast<float>(range)) * k / samples, 0.0);
      CellState& cell = grid.cells[grid.index(*grid.cell_at(point))];
      const bool is_end = grid.cell_at(point) == grid.cell_at(pose * Point2(static_cast<float>(range), 0.0));
      if (cell == CellState::unknown) continue;  // seen before
      EXPECT_EQ(cell, is_end ? CellState::occupied : CellState::free);
      cell = CellState::unknown;
      ++crossed;
    }
    EXPECT_GT(crossed, 0U);
    // What sampling may miss is a corner that the ray just touches.
    EXPECT_LE(count_cells(grid).free + count_cells(grid).occupied, 1U);
  }
}

TEST(GridBuilderTest, TheShareOfRaysThatEndDecides) {
  GridBuilder builder({.grid = {.resolution = 0.1}});
  builder.add(one_ray(1.0), {0.05, 0.05, 0.0});
  for (int k = 0; k < 2; ++k) builder.add(one_ray(2.0), {0.05, 0.05, 0.0});
  EXPECT_EQ(state_at(builder.grid(), 1.05, 0.05), CellState::occupied) << "1 of 3";
  for (int k = 0; k < 2; ++k) builder.add(one_ray(2.0), {0.05, 0.05, 0.0});
  EXPECT_EQ(state_at(builder.grid(), 1.05, 0.05), CellState::free) << "1 of 5: somebody walked by";
  EXPECT_EQ(state_at(builder.grid(), 2.05, 0.05), CellState::occupied);
}

TEST(GridBuilderTest, NoRayPassesWhereAnotherOfItsScanEnded) {
  LaserScan scan;
  scan.range_max = 10.0;
  scan.angle_increment = 1e-6;
  scan.ranges = {1.0F, 2.0F, 2.0F, 2.0F, 2.0F};
  GridBuilder builder({.grid = {.resolution = 0.1}});
  builder.add(scan, {0.05, 0.05, 0.0});
  EXPECT_EQ(state_at(builder.grid(), 1.05, 0.05), CellState::occupied);
  EXPECT_EQ(builder.grid().probability[builder.grid().index(*builder.grid().cell_at({1.05, 0.05}))], 1.0F);
}

TEST(GridBuilderTest, WhatNoiseThrowsBehindAWallIsUnknown) {
  GridBuilder builder({.grid = {.resolution = 0.1}});
  for (int k = 0; k < 9; ++k) builder.add(one_ray(1.0), {0.05, 0.05, 0.0});
  builder.add(one_ray(1.1), {0.05, 0.05, 0.0});
  const OccupancyGrid grid = builder.grid();
  EXPECT_EQ(state_at(grid, 1.05, 0.05), CellState::occupied);
  EXPECT_EQ(state_at(grid, 1.15, 0.05), CellState::unknown);
}

TEST(GridBuilderTest, WhatIsNoReturnSaysNothing) {
  GridBuilder builder;
  builder.add(one_ray(0.0), {});
  builder.add(one_ray(10.0), {});
  builder.add(one_ray(test::nan), {});
  EXPECT_THROW(builder.grid(), Error);
  builder.add(one_ray(1.0), {});
  EXPECT_EQ(count_cells(builder.grid()).occupied, 1U);
}

TEST(GridBuilderTest, TheOrderOfScansDoesNotMatterWhileTheGridGrows) {
  const test::Room room = test::simple_room();
  test::Random random(3);
  std::vector<std::pair<LaserScan, Pose2>> scans;
  for (int k = 0; k < 20; ++k) {
    const Pose2 pose{random.uniform(0.5, 3.3), random.uniform(0.5, 3.5), random.uniform(-3, 3)};
    scans.emplace_back(room.scan(pose, 0.0, 0.01, &random), pose);
  }
  GridBuilder there, back;
  for (const auto& [scan, pose] : scans) there.add(scan, pose);
  for (auto one = scans.rbegin(); one != scans.rend(); ++one) back.add(one->first, one->second);
  const OccupancyGrid a = there.grid(), b = back.grid();
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.T_map_grid.x, b.T_map_grid.x);
  EXPECT_EQ(a.width, b.width);
}

struct Offsets {
  double mean = 0.0;  ///< towards the free side [m]
  double rms = 0.0;   ///< [m]
  std::size_t count = 0;
};

/// How far points lie from the walls of the simple room, corners left out.
Offsets offsets_of(const PointCloud2& points, const test::Room& room) {
  Offsets offsets;
  for (const Point2& point : points) {
    double nearest = 1.0;
    for (std::size_t k = 0; k < room.walls.size(); ++k) {
      const Point2 along = room.walls[k].b - room.walls[k].a;
      const Point2 from_a = point - room.walls[k].a;
      const double length = along.norm();
      const double along_it = from_a.dot(along) / length;
      if (along_it < 0.1 || along_it > length - 0.1) continue;
      const double left = (along.x() * from_a.y() - along.y() * from_a.x()) / length;
      const double inwards = k < 8 ? left : -left;  // the first eight enclose the room, the others its pillar
      if (std::abs(inwards) < std::abs(nearest)) nearest = inwards;
    }
    if (std::abs(nearest) > 0.2) continue;
    offsets.mean += nearest;
    offsets.rms += nearest * nearest;
    ++offsets.count;
  }
  offsets.mean /= static_cast<double>(offsets.count);
  offsets.rms = std::sqrt(offsets.rms / static_cast<double>(offsets.count));
  return offsets;
}

/// Scans of a known room, 1 cm noise, grids of 5 cm that lie any way: are the walls where they are? The best that
/// single cells can do is 5 cm / sqrt(12) = 14.4 mm.
TEST(GridBuilderTest, WallPointsOfAGridLieOnTheWallsOfTheWorld) {
  const test::Room room = test::simple_room();
  PointCloud2 walls;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    test::Random random(seed);
    const Pose2 origin{random.uniform(-1, 1), random.uniform(-1, 1), seed % 3 == 0 ? 0.0 : random.uniform(-3, 3)};
    GridBuilder builder({.grid = {.resolution = 0.05, .origin = origin}});
    for (int k = 0; k < 40; ++k) {
      const Pose2 pose{random.uniform(0.5, 3.3), random.uniform(0.5, 3.5), random.uniform(-3, 3)};
      builder.add(room.scan(pose, 0.0, 0.01, &random), pose);
    }
    const OccupancyGrid grid = builder.grid();
    for (const Point2& point : wall_points(grid)) walls.push_back(point);
  }
  const Offsets offsets = offsets_of(walls, room);
  EXPECT_GT(offsets.count, 2000U);
  EXPECT_LT(std::abs(offsets.mean), 0.002);
  EXPECT_LT(offsets.rms, 0.012);
}

TEST(GridBuilderTest, RefusesWhatItCannotDo) {
  EXPECT_THROW(GridBuilder({.occupied_share = 0.0}), Error);
  EXPECT_THROW(GridBuilder({.grid = {.resolution = -1.0}}), Error);
  GridBuilder builder;
  EXPECT_THROW(builder.add(one_ray(1.0), {test::nan, 0.0, 0.0}), Error);
  builder.add(one_ray(1.0), {});
  EXPECT_THROW(builder.add(one_ray(1.0), {1e6, 1e6, 0.0}), Error);
  EXPECT_EQ(count_cells(builder.grid()).occupied, 1U) << "what was there stays";
}

}  // namespace
}  // namespace slamicp::grid_builder_test
