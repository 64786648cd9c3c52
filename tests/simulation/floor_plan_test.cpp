// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <string_view>

#include <slamicp/error.hpp>
#include <slamicp/simulation/floor_plan.hpp>
#include <slamicp/simulation/lidar.hpp>

namespace slamicp::floor_plan_test {
namespace {

/// '#' occupied, '.' free, '?' unknown; the first row is the top.
OccupancyGrid grid_of(const std::vector<std::string_view>& rows) {
  OccupancyGrid grid;
  grid.width = static_cast<int>(rows[0].size());
  grid.height = static_cast<int>(rows.size());
  grid.resolution = 0.1;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char c : *row)
      grid.cells.push_back(c == '#' ? CellState::occupied : c == '.' ? CellState::free : CellState::unknown);
  return grid;
}

double farthest_wall_point(const World& world, const OccupancyGrid& grid) {
  double farthest = 0.0;
  for (const Point2& point : wall_points(grid)) farthest = std::max(farthest, distance_to_walls(world, point));
  return farthest;
}

bool has_wall(const World& world, const Point2& a, const Point2& b) {
  return std::any_of(world.walls.begin(), world.walls.end(), [&](const Segment& wall) {
    return (wall.a.isApprox(a) && wall.b.isApprox(b)) || (wall.a.isApprox(b) && wall.b.isApprox(a));
  });
}

TEST(FloorPlan, ARoomHasFourWallsThroughTheMiddlesOfItsCells) {
  OccupancyGrid grid = grid_of({"??????", "######", "#....#", "#....#", "######", "??????"});
  const World world = with_floor_plan({}, grid);
  EXPECT_EQ(world.walls.size(), 4U);
  EXPECT_TRUE(world.pillars.empty());
  EXPECT_TRUE(has_wall(world, {0.05, 0.15}, {0.05, 0.45})) << "into the corners, which no ray reaches";
  EXPECT_TRUE(has_wall(world, {0.05, 0.15}, {0.55, 0.15}));
}

TEST(FloorPlan, AThinWallIsOneWallAndALoneCellAPillar) {
  const World world = with_floor_plan({}, grid_of({".........", ".#####...", ".........", ".......#.", "........."}));
  ASSERT_EQ(world.walls.size(), 1U);
  EXPECT_TRUE(has_wall(world, {0.15, 0.35}, {0.55, 0.35}));
  ASSERT_EQ(world.pillars.size(), 1U);
  EXPECT_TRUE(world.pillars[0].centre.isApprox(Point2(0.75, 0.15)));
  EXPECT_DOUBLE_EQ(world.pillars[0].radius, 0.05);
}

TEST(FloorPlan, AThickBlockHasFourSidesAndAHoleItsOwn) {
  EXPECT_EQ(with_floor_plan({}, grid_of({"......", ".####.", ".####.", ".####.", "......"})).walls.size(), 4U);
  const World ring =
      with_floor_plan({}, grid_of({".......", ".#####.", ".#####.", ".##.##.", ".#####.", ".#####.", "......."}));
  EXPECT_GE(ring.walls.size(), 8U);
}

TEST(FloorPlan, CellsThatTouchAtACornerLetNoRayThrough) {
  const OccupancyGrid grid = grid_of({".....#", "....#.", "...#..", "..#...", ".#....", "#....."});
  const World world = with_floor_plan({}, grid);
  EXPECT_EQ(world.walls.size(), 1U);
  EXPECT_LT(farthest_wall_point(world, grid), 1e-9);
}

TEST(FloorPlan, ASlantedWallHasFewPiecesAndStaysNearItsCells) {
  OccupancyGrid grid;
  grid.width = 200;
  grid.height = 80;
  grid.resolution = 0.05;
  grid.T_map_grid = {3.0, -2.0, 0.5};
  grid.cells.assign(200U * 80U, CellState::free);
  for (int column = 5; column < 195; ++column)
    grid.cells[grid.index({column, 10 + static_cast<int>(0.3 * column)})] = CellState::occupied;
  const World world = with_floor_plan({}, grid);
  EXPECT_LE(world.walls.size(), 8U);
  EXPECT_LT(farthest_wall_point(world, grid), 0.8 * 0.05 + 1e-9);
}

TEST(FloorPlan, RandomCellsAreAllThereAndAllWallsStandInThem) {
  Random random(5);
  for (int run = 0; run < 200; ++run) {
    OccupancyGrid grid;
    grid.width = 20;
    grid.height = 15;
    const double share = random.uniform(0.05, 0.7);
    for (int k = 0; k < 300; ++k)
      grid.cells.push_back(random.uniform() < share ? CellState::occupied
                           : random.uniform() < 0.8 ? CellState::free
                                                    : CellState::unknown);
    const World world = with_floor_plan({}, grid);
    EXPECT_LT(farthest_wall_point(world, grid), 0.8 * grid.resolution + 1e-9) << "run " << run;
    const PointCloud2 cells = cell_centres(grid);
    for (const Segment& wall : world.walls) {
      for (const Point2& end : {wall.a, wall.b}) {
        const auto holds = [&](const Point2& cell) { return (cell - end).norm() < 0.708 * grid.resolution; };
        EXPECT_TRUE(std::any_of(cells.begin(), cells.end(), holds)) << "run " << run;
      }
    }
  }
}

TEST(FloorPlan, TheLidarSeesTheWallPoints) {
  // What one localizes in is where the lidar sees it.
  const OccupancyGrid grid = grid_of({"????????????", "?##########?", "?#........#?", "?#........#?", "?#...##...#?",
                                      "?#...##...#?", "?#........#?", "?##########?", "????????????"});
  const World world = with_floor_plan({}, grid);
  const LidarModel lidar = hokuyo_utm30lx();
  std::vector<double> ranges;
  const Pose2 T_map_laser{0.35, 0.45, 0.7};
  true_ranges(world, T_map_laser, lidar, ranges);
  const PointCloud2 cells = cell_centres(grid);
  int returns = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (std::isinf(ranges[i])) continue;
    ++returns;
    const double angle = lidar.angle_min + static_cast<double>(i) * lidar.angle_increment;
    const Point2 hit = T_map_laser * Point2(ranges[i] * std::cos(angle), ranges[i] * std::sin(angle));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point2& cell : cells) nearest = std::min(nearest, (cell - hit).norm());
    EXPECT_LT(nearest, 0.0501 * std::numbers::sqrt2) << "beam " << i;
  }
  EXPECT_GT(returns, 1000);
}

TEST(FloorPlan, RefusesWhatIsNoPlan) {
  EXPECT_THROW(with_floor_plan({}, {}), Error);
  EXPECT_THROW(with_floor_plan({}, grid_of({"...", "..."})), Error);
}

}  // namespace
}  // namespace slamicp::floor_plan_test
