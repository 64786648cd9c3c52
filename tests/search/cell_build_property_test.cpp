// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <thread>

#include <slamicp/search/cell_index.hpp>

#include "support/cell_worlds.hpp"
#include "support/index_checks.hpp"

namespace slamicp::cell_build_property_test {
namespace {

using test::Random;

struct LazyWorld {
  CellOptions cells;
  Point2 center;
  PointCloud2 cloud;
  CellIndex index;

  explicit LazyWorld(Random& random) {
    cells = test::any_cells(random);
    cells.eager = false;
    const CellIndex grid = test::grid_of(cells);
    center = test::any_center(random, grid.tile());
    cloud = test::cloud_of_tiles(random, grid, random.integer(50, 300), center);
    index = CellIndex(cloud, {.neighbours = random.chance(0.5) ? 8 : 0, .radius = 5.0 * cells.cell}, cells);
  }
};

void expect_answers(Random& random, const CellIndex& index, const PointCloud2& cloud, const Point2& center) {
  for (int k = 0; k < 30; ++k)
    ASSERT_NO_FATAL_FAILURE(test::expect_nearest<2>(index, cloud, test::any_place(random, index, cloud, center),
                                                    test::any_reach(random, index)));
  for (int k = 0; k < 3; ++k)
    ASSERT_NO_FATAL_FAILURE(test::expect_brute_force<2>(index, cloud, test::any_place(random, index, cloud, center),
                                                        test::any_reach(random, index), 5));
}

std::size_t unbuilt_of(const CellIndex& index, const Bounds<2>& bounds) {
  return test::Tables(index, bounds).count(CellIndex::unbuilt_table());
}

TEST(CellBuildPropertyTest, AnswersAreTheSameBeforeDuringAndAfter) {
  for (std::uint64_t seed = 0; seed < test::seeds(120); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const LazyWorld world(random);
    const CellIndex& index = world.index;
    const Bounds<2> bounds = bounds_of<2>(world.cloud);
    std::size_t unbuilt = unbuilt_of(index, bounds);
    ASSERT_GT(unbuilt, 0U);
    ASSERT_EQ(index.build(0, world.center), 0U);
    ASSERT_NO_FATAL_FAILURE(expect_answers(random, index, world.cloud, world.center));
    while (unbuilt > 0) {
      const auto step = static_cast<std::size_t>(random.integer(1, 9));
      const std::uint64_t builds = index.builds();
      const Point2 near =
          random.chance(0.2) ? Point2(test::nan, 0.0) : test::any_place(random, index, world.cloud, world.center);
      ASSERT_EQ(index.build(step, near), std::min(step, unbuilt));
      ASSERT_NE(index.builds(), builds);
      unbuilt -= std::min(step, unbuilt);
      ASSERT_EQ(unbuilt_of(index, bounds), unbuilt);
      ASSERT_NO_FATAL_FAILURE(expect_answers(random, index, world.cloud, world.center));
    }
    const std::uint64_t builds = index.builds();
    ASSERT_EQ(index.build(100, world.center), 0U);
    ASSERT_EQ(index.builds(), builds);

    // What it came to is what an eager index has.
    CellOptions eager = world.cells;
    eager.eager = true;
    const CellIndex at_once(world.cloud, {.neighbours = 0}, eager);
    const test::Tables one(index, bounds);
    const test::Tables other(at_once, bounds);
    for (std::size_t k = 0; k < one.tables.size(); ++k) {
      ASSERT_EQ(one.tables[k]->count, other.tables[k]->count);
      for (std::size_t cell = 0; cell < std::size(one.tables[k]->cells); ++cell)
        ASSERT_EQ(one.tables[k]->cells[cell], other.tables[k]->cells[cell]);
      for (std::uint32_t j = 0; j < one.tables[k]->count; ++j)
        ASSERT_EQ(one.tables[k]->line(j).number, other.tables[k]->line(j).number);
    }
  }
}

TEST(CellBuildPropertyTest, NearTilesComeFirst) {
  for (std::uint64_t seed = 0; seed < test::seeds(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const LazyWorld world(random);
    const Bounds<2> bounds = bounds_of<2>(world.cloud);
    const double tile = world.index.tile();
    for (bool is_left = true; is_left;) {
      const Point2 near = world.center + random.point<2>(20.0 * world.index.cell());
      const auto ring_of = [&](int column, int row) {
        return std::max(std::abs(column - static_cast<int>(std::floor(near.x() / tile))),
                        std::abs(row - static_cast<int>(std::floor(near.y() / tile))));
      };
      const test::Tables before(world.index, bounds);
      is_left = world.index.build(static_cast<std::size_t>(random.integer(1, 6)), near) > 0;
      const test::Tables after(world.index, bounds);
      int farthest_built = -1;
      int nearest_unbuilt = 1000;
      for (int row = before.y; row < before.y + before.width; ++row)
        for (int column = before.x; column < before.x + before.width; ++column) {
          if (after.at(column, row) == &CellIndex::unbuilt_table())
            nearest_unbuilt = std::min(nearest_unbuilt, ring_of(column, row));
          else if (before.at(column, row) == &CellIndex::unbuilt_table())
            farthest_built = std::max(farthest_built, ring_of(column, row));
        }
      ASSERT_LE(farthest_built, nearest_unbuilt);
    }
  }
}

TEST(CellBuildPropertyTest, VersionsMadeHalfWayBecomeCompleteToo) {
  for (std::uint64_t seed = 0; seed < test::seeds(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const LazyWorld world(random);
    struct Version {
      CellIndex index;
      PointCloud2 cloud;
    };
    std::vector<Version> versions{{world.index, world.cloud}};
    for (int step = 0; step < 8; ++step) {
      Version next = versions[static_cast<std::size_t>(random.integer(0, static_cast<int>(versions.size()) - 1))];
      if (random.chance(0.7)) {
        // Some of it where no tile was.
        const PointCloud2 added =
            test::cloud_of_tiles(random, world.index, random.integer(1, 20),
                                 world.center + random.point<2>(random.chance(0.3) ? 10.0 * world.index.tile() : 0.0));
        next.index = next.index.with_added(added);
        test::append(next.cloud, added);
      } else {
        const int number = random.integer(0, static_cast<int>(next.cloud.size()) - 1);
        next.index = next.index.with_removed(std::vector{number});
        next.cloud[static_cast<std::size_t>(number)].setConstant(test::nan);
      }
      versions.push_back(std::move(next));
      const Version& any = versions[static_cast<std::size_t>(random.integer(0, static_cast<int>(versions.size()) - 1))];
      any.index.build(static_cast<std::size_t>(random.integer(0, 8)), world.center);
      ASSERT_NO_FATAL_FAILURE(expect_answers(random, any.index, any.cloud, world.center));
    }
    for (std::size_t k = versions.size(); k-- > 0;) {
      const Version& version = versions[k];
      while (version.index.build(7, world.center) > 0) continue;
      ASSERT_EQ(unbuilt_of(version.index, bounds_of<2>(version.cloud)), 0U);
      ASSERT_NO_FATAL_FAILURE(expect_answers(random, version.index, version.cloud, world.center));
    }
  }
}

TEST(CellBuildPropertyTest, FarTilesAreBuiltInTheEnd) {
  const PointCloud2 apart{{0.0, 0.0}, {1000.0, 0.0}, {0.0, -9e6}};
  const CellIndex index(apart, {.neighbours = 0}, {.eager = false});
  while (index.build(1, {500.0, 500.0}) > 0) continue;
  for (const Point2& point : apart) {
    Bounds<2> bounds;
    bounds.include(point);
    EXPECT_EQ(unbuilt_of(index, bounds), 0U);
    EXPECT_TRUE(index.nearest(point + Point2(0.1, 0.1), 0.3).found());
  }
}

TEST(CellBuildPropertyTest, TwoBuildersAndAReaderGetAlong) {
  Random random(5);
  const PointCloud2 cloud = test::wall({0.0, 0.0}, {30.0, 7.0}, 0.02, 0.01, &random);
  const CellIndex index(cloud, {}, {.eager = false});
  const std::size_t all = unbuilt_of(index, bounds_of<2>(cloud));
  std::size_t built[2] = {};
  std::vector<Neighbour> found;
  {
    const auto build = [&](std::size_t& count, const Point2& from) {
      while (const std::size_t step = index.build(2, from)) count += step;
    };
    std::jthread one([&] { build(built[0], {0.0, 0.0}); });
    std::jthread other([&] { build(built[1], {30.0, 7.0}); });
    for (int k = 0; k < 3000; ++k) found.push_back(index.nearest({0.01 * k, 0.002 * k + 0.05}, 0.3));
  }
  EXPECT_EQ(built[0] + built[1], all) << "each tile once";
  EXPECT_EQ(unbuilt_of(index, bounds_of<2>(cloud)), 0U);
  for (int k = 0; k < 3000; ++k) {
    const Neighbour again = index.nearest({0.01 * k, 0.002 * k + 0.05}, 0.3);
    ASSERT_EQ(found[static_cast<std::size_t>(k)].index, again.index);
    ASSERT_EQ(found[static_cast<std::size_t>(k)].squared_distance, again.squared_distance);
  }
}

}  // namespace
}  // namespace slamicp::cell_build_property_test
