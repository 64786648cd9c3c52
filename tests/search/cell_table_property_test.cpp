// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/search/cell_index.hpp>

#include "support/brute_force.hpp"
#include "support/cell_worlds.hpp"

namespace slamicp::cell_table_property_test {
namespace {

using test::Random;

/// An index, what is in it, and where.
struct World {
  CellOptions cells;
  SurfaceOptions surfaces;
  Point2 center;
  PointCloud2 cloud;
  CellIndex index;

  Bounds<2> bounds() const {
    Bounds<2> all = bounds_of<2>(cloud);
    all.include(center);
    return all;
  }
};

/// Built at once, grown or shrunk, with tables made by any of the ways there are.
World any_world(std::uint64_t seed) {
  Random random(seed);
  World world;
  world.cells = test::any_cells(random);
  world.cells.eager = true;
  world.surfaces = {.neighbours = random.chance(0.5) ? 8 : 0, .radius = 6.0 * world.cells.cell};
  const CellIndex grid = test::grid_of(world.cells);
  world.center = test::any_center(random, grid.tile());
  world.cloud = test::cloud_of_tiles(random, grid, random.integer(0, 250), world.center);
  world.index = CellIndex(world.cloud, world.surfaces, world.cells);
  const int edits = random.chance(0.4) ? 0 : random.integer(1, 12);
  for (int edit = 0; edit < edits; ++edit) {
    if (random.chance(0.3) && !world.cloud.empty()) {
      const int number = random.integer(0, static_cast<int>(world.cloud.size()) - 1);
      world.index = world.index.with_removed(std::vector{number});
      world.cloud[static_cast<std::size_t>(number)].setConstant(test::nan);
    } else {
      const PointCloud2 more = test::cloud_of_tiles(random, grid, random.integer(1, 20), world.center);
      world.index = world.index.with_added(more);
      test::append(world.cloud, more);
    }
  }
  return world;
}

/// A place of the cell, often on its border, or beyond it by what a query in float may be off.
Point2 any_place_of(Random& random, const CellIndex& index, const Point2& corner) {
  constexpr double off = 1.9e-5;
  Point2 place;
  for (int axis = 0; axis < 2; ++axis) {
    const double ends[] = {-off, 0.0, index.cell(), index.cell() + off};
    place[axis] =
        corner[axis] + (random.chance(0.5) ? ends[random.integer(0, 3)] : random.uniform(0.0, 1.0) * index.cell());
  }
  return place;
}

void expect_exact_cell(const World& world, const CellTable& table, std::uint32_t word, const Point2& place) {
  const double reach = world.cells.reach;
  const double unit = world.index.distance_unit();
  const Neighbour nearest = test::nearest_of_all<2>(world.cloud, place, test::infinity);
  const double distance = std::sqrt(nearest.squared_distance);
  constexpr double off = 3e-5;  // `place` may lie so far outside the cell, for which alone the bounds hold
  if (CellTable::above_of(word) != CellTable::farthest) {
    ASSERT_LE(distance, CellTable::above_of(word) * unit + off);
  }
  // The last bound says no more than "not within reach".
  ASSERT_GE(distance, std::min(CellTable::below_of(word) * unit, reach) - off);

  const std::uint32_t count = CellTable::count_of(word);
  if (count == CellTable::no_answer || !(distance < reach - off)) return;
  double listed = test::infinity;
  for (std::uint32_t k = 0; k < count; ++k) {
    const auto number = static_cast<std::size_t>(table.line(CellTable::first_of(word) + k).number);
    listed = std::min(listed, (world.cloud[number] - place).squaredNorm());
  }
  ASSERT_EQ(listed, nearest.squared_distance) << "point " << nearest.index << " is missing";
}

/// What a vector reader takes for granted: candidates where they say, nothing near behind them.
void expect_sound_table(const World& world, const CellTable& table, const Point2& corner) {
  const double unit = world.index.place_unit();
  const Point2 middle = corner + Point2::Constant(0.5 * world.index.tile());
  for (std::uint32_t k = 0; k < table.count; ++k) {
    ASSERT_GE(table.line(k).number, 0);
    const auto number = static_cast<std::size_t>(table.line(k).number);
    ASSERT_LT(number, world.cloud.size());
    const Point2 stored = middle + unit * Point2(table.places()[k].x, table.places()[k].y);
    ASSERT_LE((stored - world.cloud[number]).cwiseAbs().maxCoeff(), 0.501 * unit);
    const Surface2 surface = world.index.surface(number);
    const CellLine& line = table.line(k);
    ASSERT_EQ(line.normal_x != 0 || line.normal_y != 0, surface.valid());
    if (!surface.valid()) continue;
    const Vector<2> normal = Vector<2>(line.normal_x, line.normal_y) / static_cast<double>(line_scale);
    ASSERT_LT((normal - surface.trust * surface.normal).norm(), 1e-4);
    ASSERT_NEAR(normal.dot(surface.centroid - corner), static_cast<double>(line.offset), 1e-5);
  }
  for (std::uint32_t k = table.count; k < table.count + CellTable::spare; ++k) {
    const Point2 off(table.places()[k].x * unit, table.places()[k].y * unit);
    ASSERT_GE((off.cwiseAbs() - Point2::Constant(0.5 * world.index.tile())).norm(), world.cells.reach);
  }
  for (const std::uint32_t word : table.cells) {
    if (CellTable::count_of(word) != CellTable::no_answer) {
      ASSERT_LE(CellTable::first_of(word) + CellTable::count_of(word), table.count);
    }
  }
}

TEST(CellTablePropertyTest, EveryCellListsWhatIsNearestToAnyPlaceInIt) {
  std::size_t answers = 0;
  for (std::uint64_t seed = 0; seed < test::seeds(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const World world = any_world(seed);
    Random random(seed + 1000);
    const test::Tables tables(world.index, world.bounds());
    ASSERT_EQ(tables.count(CellIndex::unbuilt_table()), 0U);
    for (int row = tables.y; row < tables.y + tables.width; ++row)
      for (int column = tables.x; column < tables.x + tables.width; ++column) {
        SCOPED_TRACE("tile " + std::to_string(column) + ", " + std::to_string(row));
        const CellTable& table = *tables.at(column, row);
        const Point2 corner(column * world.index.tile(), row * world.index.tile());
        const bool is_empty = &table == &CellIndex::empty_table();
        if (!is_empty) {
          ASSERT_NO_FATAL_FAILURE(expect_sound_table(world, table, corner));
        }
        const int samples = is_empty ? 64 : 256;
        for (int k = 0; k < samples; ++k) {
          const int cell = is_empty ? random.integer(0, 255) : k;
          const std::uint32_t word = table.cells[cell];
          answers += CellTable::count_of(word) > 0 && CellTable::count_of(word) < CellTable::no_answer ? 1U : 0U;
          const Point2 cell_corner =
              corner + Point2((cell % tile_cells) * world.index.cell(), (cell / tile_cells) * world.index.cell());
          for (int place = 0; place < 3; ++place)
            ASSERT_NO_FATAL_FAILURE(
                expect_exact_cell(world, table, word, any_place_of(random, world.index, cell_corner)))
                << "cell " << cell;
        }
      }
  }
  EXPECT_GT(answers, 10000U);
}

TEST(CellTablePropertyTest, ACellThatCannotListAllSaysSo) {
  // Points on a circle: all of them are nearest to some place around its middle.
  const CellOptions cells{.cell = 0.05};
  const CellIndex grid = test::grid_of(cells);
  World world{cells, {.neighbours = 0}, Point2::Zero(), {}, {}};
  const Point2 middle = Point2::Constant(2.5 * grid.cell());
  for (int k = 0; k < 90; ++k) world.cloud.push_back(middle + 0.2 * Point2(std::cos(0.07 * k), std::sin(0.07 * k)));
  world.index = CellIndex(world.cloud, world.surfaces, world.cells);
  const test::Tables tables(world.index, world.bounds());
  const CellTable& table = *tables.at(0, 0);
  EXPECT_EQ(CellTable::count_of(table.cells[2 * tile_cells + 2]), CellTable::no_answer);
  Random random(7);
  for (int k = 0; k < 200; ++k) {
    const Point2 place = middle + random.point<2>(0.02);
    ASSERT_NO_FATAL_FAILURE(expect_exact_cell(world, table, table.cells[2 * tile_cells + 2], place));
    const Neighbour nearest = test::nearest_of_all<2>(world.cloud, place, 0.3);
    ASSERT_EQ(world.index.nearest(place, 0.3).index, nearest.index);
  }
  // Grown it still says so, and with the points gone it can answer again.
  const CellIndex grown = world.index.with_added(PointCloud2{middle + Point2(0.2, 0.001)});
  EXPECT_EQ(CellTable::count_of(test::Tables(grown, world.bounds()).at(0, 0)->cells[2 * tile_cells + 2]),
            CellTable::no_answer);
  std::vector<int> most;
  for (int k = 5; k <= 90; ++k) most.push_back(k);
  EXPECT_EQ(
      CellTable::count_of(test::Tables(grown.with_removed(most), world.bounds()).at(0, 0)->cells[2 * tile_cells + 2]),
      5U);
}

TEST(CellTablePropertyTest, TablesAreEmptyWhereNothingIsWithinReachAndSharedWhereNothingChanged) {
  for (std::uint64_t seed = 0; seed < test::seeds(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const World world = any_world(seed);
    const Point2 added = world.center + random.point<2>(40.0 * world.index.cell());
    const CellIndex grown = world.index.with_added(PointCloud2{added});
    Bounds<2> bounds = world.bounds();
    bounds.include(added);
    const test::Tables before(world.index, bounds);
    const test::Tables after(grown, bounds);
    const auto distance_to_tile = [&](const Point2& point, int column, int row) {
      const Point2 middle = Point2(column + 0.5, row + 0.5) * world.index.tile();
      return ((point - middle).cwiseAbs() - Point2::Constant(0.5 * world.index.tile())).cwiseMax(0.0).norm();
    };
    for (int row = before.y; row < before.y + before.width; ++row)
      for (int column = before.x; column < before.x + before.width; ++column) {
        bool is_near = false;
        for (const Point2& point : world.cloud)
          is_near = is_near || distance_to_tile(point, column, row) < world.cells.reach;
        const CellTable* table = before.at(column, row);
        ASSERT_NE(table, &CellIndex::unbuilt_table());
        if (is_near) {
          ASSERT_NE(table, &CellIndex::empty_table());
        } else {
          ASSERT_EQ(table->count, 0U);
        }
        // One point of a map without lines changes what lies within its reach. Lines reach farther.
        if (world.surfaces.neighbours == 0 &&
            distance_to_tile(added, column, row) > std::sqrt(2.0) * world.cells.reach + 3.0 * world.index.cell()) {
          ASSERT_EQ(after.at(column, row), table);
        }
        if (distance_to_tile(added, column, row) == 0.0) {
          ASSERT_NE(after.at(column, row), table);
        }
      }
  }
}

}  // namespace
}  // namespace slamicp::cell_table_property_test
