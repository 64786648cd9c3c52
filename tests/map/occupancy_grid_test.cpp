// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/map/occupancy_grid.hpp>

#include "support/random.hpp"

namespace slamicp::occupancy_grid_test {
namespace {

/// Rows from the top, as one sees them: '#' occupied, '.' free, ' ' unknown.
OccupancyGrid drawn(const std::vector<std::string>& rows, double resolution = 1.0, const Pose2& T_map_grid = {}) {
  OccupancyGrid grid;
  grid.width = static_cast<int>(rows.front().size());
  grid.height = static_cast<int>(rows.size());
  grid.resolution = resolution;
  grid.T_map_grid = T_map_grid;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char c : *row)
      grid.cells.push_back(c == '#' ? CellState::occupied : c == '.' ? CellState::free : CellState::unknown);
  return grid;
}

TEST(OccupancyGridTest, CellsAndPointsOfATurnedGridFindEachOther) {
  const OccupancyGrid grid = drawn({"#. ", "..#"}, 0.5, {1.0, 2.0, 0.5 * test::pi});
  EXPECT_EQ(grid.problem(), "");
  EXPECT_EQ(grid.at({0, 1}), CellState::occupied);
  EXPECT_EQ(grid.at({2, 0}), CellState::occupied);
  EXPECT_EQ(grid.at({2, 1}), CellState::unknown);
  EXPECT_EQ(grid.at({3, 0}), CellState::unknown) << "outside";
  // Columns go along the map's y, rows against its x.
  EXPECT_TRUE(grid.centre({2, 0}).isApprox(Point2(1.0 - 0.25, 2.0 + 1.25)));
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column) {
      const Cell cell{column, row};
      EXPECT_EQ(grid.cell_at(grid.centre(cell)), cell);
    }
  EXPECT_FALSE(grid.cell_at({1.1, 2.1}).has_value());
  EXPECT_FALSE(grid.cell_at({test::nan, 2.1}).has_value());
  EXPECT_FALSE(grid.cell_at({-1e300, test::infinity}).has_value());
  const CellCounts counts = count_cells(grid);
  EXPECT_EQ(counts.occupied, 2U);
  EXPECT_EQ(counts.free, 3U);
  EXPECT_EQ(counts.unknown, 1U);
}

TEST(OccupancyGridTest, NamesTheFirstRuleBroken) {
  OccupancyGrid grid = drawn({"#."});
  grid.cells.pop_back();
  EXPECT_NE(grid.problem().find("width x height"), std::string::npos);
  grid = drawn({"#."});
  grid.probability = {0.5F};
  EXPECT_NE(grid.problem().find("probability"), std::string::npos);
  grid = drawn({"#."}, 0.0);
  EXPECT_NE(grid.problem().find("resolution"), std::string::npos);
  grid = drawn({"#."}, 1.0, {test::nan, 0.0, 0.0});
  EXPECT_NE(grid.problem().find("origin"), std::string::npos);
  EXPECT_NE(OccupancyGrid{}.problem(), "");
}

TEST(OccupancyGridTest, WallsAreTheOccupiedCellsBesideFreeOnes) {
  const OccupancyGrid grid = drawn({"#####",  //
                                    "#####",  //
                                    "#####",  // only the lowest row of the thick wall is seen
                                    "....#",  //
                                    ".#..#",  // a post, and a wall
                                    "    #"});
  const PointCloud2 walls = wall_points(grid);
  const PointCloud2 expected{{4.5, 1.5}, {1.5, 1.5}, {4.5, 2.5}, {0.5, 3.5}, {1.5, 3.5}, {2.5, 3.5}, {3.5, 3.5}};
  ASSERT_EQ(walls.size(), expected.size());
  for (const Point2& point : expected) EXPECT_NE(std::find(walls.begin(), walls.end(), point), walls.end());
  EXPECT_EQ(cell_centres(grid).size(), 19U);
}

TEST(OccupancyGridTest, AWallOfTwoCellsThatNoiseHasSpreadIsBetweenThem) {
  for (const Pose2& T_map_grid : {Pose2{}, Pose2{3.0, -1.0, 0.7}}) {
    const PointCloud2 walls = wall_points(drawn({"###", "###", "..."}, 0.1, T_map_grid));
    ASSERT_EQ(walls.size(), 3U);
    EXPECT_TRUE(walls[0].isApprox(T_map_grid * Point2(0.05, 0.2)));
  }
  // One that is seen from both sides has two faces.
  const PointCloud2 faces = wall_points(drawn({"...", "###", "###", "..."}));
  ASSERT_EQ(faces.size(), 6U);
  EXPECT_EQ(faces[0], Point2(0.5, 1.5));
  EXPECT_EQ(faces[3], Point2(0.5, 2.5));
}

TEST(OccupancyGridTest, WithoutFreeCellsTheRimsOfTheWallsAreTaken) {
  EXPECT_EQ(wall_points(drawn({"     ", " ### ", " ### ", " ### ", "     "})).size(), 8U);
  EXPECT_EQ(wall_points(drawn({"###", "###", "###"})).size(), 8U) << "outside of the grid is unknown";
  EXPECT_TRUE(wall_points(drawn({"   "})).empty());
}

TEST(OccupancyGridTest, PointsBecomeCellsAndBackWhateverTheFrame) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    GridOptions options;
    options.resolution = random.uniform(0.02, 0.3);
    options.padding = random.chance(0.5) ? 0.0 : random.uniform(0.0, 1.0);
    options.origin = random.pose<2>(5.0, 3.0);
    PointCloud2 points;
    for (int k = 0; k < 200; ++k) points.push_back(random.point<2>(3.0));
    points.emplace_back(test::nan, 0.0);
    const OccupancyGrid grid = to_occupancy_grid(points, options);
    EXPECT_EQ(grid.problem(), "");
    points.pop_back();
    for (const Point2& point : points) {
      const std::optional<Cell> cell = grid.cell_at(point);
      ASSERT_TRUE(cell.has_value());
      EXPECT_EQ(grid.at(*cell), CellState::occupied);
    }
    const PointCloud2 centres = cell_centres(grid);
    EXPECT_LE(centres.size(), points.size());
    EXPECT_EQ(count_cells(grid).occupied, centres.size());
    // Its own cells once more: the same grid.
    const OccupancyGrid again = to_occupancy_grid(centres, options);
    EXPECT_EQ(again.cells, grid.cells);
    EXPECT_TRUE(again.T_map_grid.translation().isApprox(grid.T_map_grid.translation(), 1e-9));
  }
}

TEST(OccupancyGridTest, PaddingIsWholeCellsOfUnknown) {
  const OccupancyGrid grid = to_occupancy_grid(PointCloud2{{0.26, 0.01}}, {.resolution = 0.1, .padding = 0.25});
  EXPECT_EQ(grid.width, 7);
  EXPECT_EQ(grid.height, 7);
  EXPECT_EQ(grid.at({3, 3}), CellState::occupied);
  EXPECT_NEAR(grid.T_map_grid.x, -0.1, 1e-12);
  EXPECT_NEAR(grid.T_map_grid.y, -0.3, 1e-12);
}

TEST(OccupancyGridTest, RefusesWhatIsTooLargeOrNothing) {
  EXPECT_THROW(to_occupancy_grid(PointCloud2{{0, 0}, {1e5, 1e5}}), Error);
  EXPECT_THROW(to_occupancy_grid(PointCloud2{{0, 0}, {1e300, 0}}), Error);
  EXPECT_THROW(to_occupancy_grid(PointCloud2{{test::nan, 0}}), Error);
  EXPECT_THROW(to_occupancy_grid(PointCloud2{{0, 0}}, {.resolution = 0.0}), Error);
  EXPECT_THROW(to_occupancy_grid(PointCloud2{{0, 0}}, {.padding = -1.0}), Error);
  EXPECT_THROW(to_occupancy_grid(PointCloud2{{0, 0}}, {.padding = 1e300}), Error);
}

}  // namespace
}  // namespace slamicp::occupancy_grid_test
