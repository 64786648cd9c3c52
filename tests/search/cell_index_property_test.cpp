// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <numeric>

#include <slamicp/search/cell_index.hpp>

#include "support/cell_worlds.hpp"
#include "support/index_checks.hpp"

namespace slamicp::cell_index_property_test {
namespace {

using test::Random;

void expect_all_answers(Random& random, const CellIndex& index, const PointCloud2& cloud, const Point2& center,
                        int queries) {
  for (int k = 0; k < queries; ++k)
    ASSERT_NO_FATAL_FAILURE(test::expect_brute_force<2>(index, cloud, test::any_place(random, index, cloud, center),
                                                        test::any_reach(random, index),
                                                        static_cast<std::size_t>(random.integer(0, 20))));
}

TEST(CellIndexPropertyTest, IsBruteForceWhateverItsCells) {
  for (std::uint64_t seed = 0; seed < test::seeds(500); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const CellOptions cells = test::any_cells(random);
    const CellIndex grid = test::grid_of(cells);
    const Point2 center = test::any_center(random, grid.tile());
    const PointCloud2 cloud = test::cloud_of_tiles(random, grid, random.integer(0, 400), center);
    const CellIndex index(cloud, {.neighbours = random.chance(0.2) ? 12 : 0}, cells);
    for (int k = 0; k < 300; ++k)
      ASSERT_NO_FATAL_FAILURE(test::expect_nearest<2>(index, cloud, test::any_place(random, grid, cloud, center),
                                                      test::any_reach(random, grid)));
    ASSERT_NO_FATAL_FAILURE(expect_all_answers(random, index, cloud, center, 30));
  }
}

TEST(CellIndexPropertyTest, IsBruteForceBetweenTwoPointsWhereverTheirBisectorLies) {
  // What decides is on which side of the bisector a query lies: near the border of a cell both must be listed.
  for (std::uint64_t seed = 0; seed < test::seeds(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const CellOptions cells{.cell = random.uniform(0.01, 0.2)};
    const CellIndex grid = test::grid_of({.cell = cells.cell, .reach = cells.cell});
    PointCloud2 cloud;
    for (int k = 0; k < 12; ++k) {
      const double middle = test::border(grid, random.integer(-8, 8)) + std::pow(10.0, random.uniform(-12.0, -2.0));
      const double off = random.uniform(0.0, 2.0) * grid.cell();
      const double other = random.uniform(-8.0, 8.0) * grid.cell();
      cloud.emplace_back(middle - off, other);
      cloud.emplace_back(middle + off, other + (random.chance(0.5) ? 0.0 : random.uniform(-1e-6, 1e-6)));
      if (random.chance(0.5)) cloud.emplace_back(other, middle - off), cloud.emplace_back(other, middle + off);
    }
    const CellIndex index(cloud, {.neighbours = 0}, {.cell = cells.cell, .reach = 6.0 * cells.cell});
    for (int k = 0; k < 1000; ++k) {
      Point2 query = random.point<2>(10.0 * grid.cell());
      for (int axis = 0; axis < 2; ++axis)
        if (random.chance(0.7))
          query[axis] = test::border(grid, random.integer(-9, 9)) + random.uniform(-1.0, 1.0) * 1e-9;
      ASSERT_NO_FATAL_FAILURE(test::expect_nearest<2>(index, cloud, query, 6.0 * cells.cell));
    }
  }
}

/// A version of an index, and what it must answer for ever.
struct Snapshot {
  CellIndex index;
  PointCloud2 cloud;
};

bool same(const Point2& a, const Point2& b) {
  return (a.x() == b.x() || (std::isnan(a.x()) && std::isnan(b.x()))) &&
         (a.y() == b.y() || (std::isnan(a.y()) && std::isnan(b.y())));
}

void expect_points(const Snapshot& snapshot) {
  ASSERT_EQ(snapshot.index.size(), snapshot.cloud.size());
  for (std::size_t k = 0; k < snapshot.cloud.size(); ++k)
    ASSERT_TRUE(same(snapshot.index.points()[k], snapshot.cloud[k])) << k;
}

/// Points to insert: new ones, and now and then where one was that is gone.
PointCloud2 any_batch(Random& random, const CellIndex& grid, const Point2& center, const PointCloud2& gone) {
  const int size = random.chance(0.2) ? random.integer(1, 50) : random.integer(1, 8);
  PointCloud2 batch = test::cloud_of_tiles(random, grid, size, center);
  for (Point2& point : batch)
    if (!gone.empty() && random.chance(0.3))
      point = gone[static_cast<std::size_t>(random.integer(0, static_cast<int>(gone.size()) - 1))];
  return batch;
}

/// Numbers to remove: some together, some anywhere, some twice, some that are no longer there.
std::vector<int> any_numbers(Random& random, const PointCloud2& cloud) {
  std::vector<int> which;
  const int last = static_cast<int>(cloud.size()) - 1;
  const int size = random.chance(0.2) ? random.integer(1, 50) : random.integer(1, 8);
  for (int k = 0; k < size; ++k)
    which.push_back(k > 0 && random.chance(0.5) ? std::min(which.back() + 1, last) : random.integer(0, last));
  return which;
}

TEST(CellIndexPropertyTest, IsBruteForceAfterAnyInsertsAndRemovals) {
  for (std::uint64_t seed = 0; seed < test::seeds(20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const CellOptions cells = test::any_cells(random);
    const CellIndex grid = test::grid_of(cells);
    const Point2 center = test::any_center(random, grid.tile());
    const SurfaceOptions surfaces{.neighbours = seed % 3 == 0 ? 8 : 0, .radius = 4.0 * cells.cell};
    std::vector<Snapshot> versions{{CellIndex(PointCloud2{}, surfaces, cells), {}}};
    PointCloud2 gone;
    for (int edit = 0; edit < 120; ++edit) {
      SCOPED_TRACE("edit " + std::to_string(edit));
      Snapshot next = versions.back();
      if (next.cloud.empty() || random.chance(0.6)) {
        const PointCloud2 batch = any_batch(random, grid, center, gone);
        next.index = next.index.with_added(batch);
        test::append(next.cloud, batch);
      } else {
        const std::vector<int> which = any_numbers(random, next.cloud);
        next.index = next.index.with_removed(which);
        for (const int number : which) {
          Point2& point = next.cloud[static_cast<std::size_t>(number)];
          if (is_finite<2>(point)) gone.push_back(point);
          point.setConstant(test::nan);
        }
      }
      if (random.chance(0.3)) next.index.build(static_cast<std::size_t>(random.integer(1, 20)), center);
      versions.push_back(std::move(next));
      const Snapshot& now = versions.back();
      ASSERT_EQ(now.index.size(), now.cloud.size());
      for (int k = 0; k < 40; ++k)
        ASSERT_NO_FATAL_FAILURE(test::expect_nearest<2>(now.index, now.cloud,
                                                        test::any_place(random, grid, now.cloud, center),
                                                        test::any_reach(random, now.index)));
      ASSERT_NO_FATAL_FAILURE(expect_all_answers(random, now.index, now.cloud, center, 6));
      for (int k = 0; k < 3; ++k) {
        const Snapshot& old =
            versions[static_cast<std::size_t>(random.integer(0, static_cast<int>(versions.size()) - 1))];
        ASSERT_NO_FATAL_FAILURE(expect_all_answers(random, old.index, old.cloud, center, 4)) << "an older version";
      }
    }
    for (const Snapshot& one : versions) ASSERT_NO_FATAL_FAILURE(expect_points(one));

    // All of it gone, then all of it there again, under other numbers.
    Snapshot last = versions.back();
    const PointCloud2 all = last.cloud;
    std::vector<int> numbers(all.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    last.index = last.index.with_removed(numbers);
    last.cloud.assign(all.size(), Point2::Constant(test::nan));
    ASSERT_NO_FATAL_FAILURE(expect_all_answers(random, last.index, last.cloud, center, 50));
    ASSERT_FALSE(last.index.nearest(center, 1e9).found());
    last.index = last.index.with_added(all);
    test::append(last.cloud, all);
    ASSERT_NO_FATAL_FAILURE(expect_all_answers(random, last.index, last.cloud, center, 100));
    ASSERT_NO_FATAL_FAILURE(expect_points(last));
  }
}

TEST(CellIndexPropertyTest, BranchesFromOneVersionDoNotSeeEachOther) {
  for (std::uint64_t seed = 0; seed < test::seeds(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const CellOptions cells = test::any_cells(random);
    const CellIndex grid = test::grid_of(cells);
    const Point2 center = test::any_center(random, grid.tile());
    std::vector<Snapshot> all;
    const PointCloud2 first = test::cloud_of_tiles(random, grid, 100, center);
    all.push_back({CellIndex(first, {.neighbours = 0}, cells), first});
    // Once grown there is room behind the points: the first branch takes it, the second has to move.
    for (int branch = 0; branch < 12; ++branch) {
      Snapshot next = all[static_cast<std::size_t>(random.integer(0, static_cast<int>(all.size()) - 1))];
      const PointCloud2 added = test::cloud_of_tiles(random, grid, random.integer(1, 30), center);
      next.index = next.index.with_added(added);
      test::append(next.cloud, added);
      all.push_back(std::move(next));
    }
    for (const Snapshot& one : all) {
      ASSERT_NO_FATAL_FAILURE(expect_points(one));
      ASSERT_NO_FATAL_FAILURE(expect_all_answers(random, one.index, one.cloud, center, 20));
    }
  }
}

TEST(CellIndexPropertyTest, LinesAfterRemovalAreAsOfTheRest) {
  for (std::uint64_t seed = 0; seed < test::seeds(20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const CellOptions cells{.cell = random.uniform(0.03, 0.1), .reach = 0.3, .eager = random.chance(0.7)};
    const SurfaceOptions surfaces{.neighbours = random.integer(5, 20), .radius = random.uniform(0.05, 0.6)};
    PointCloud2 cloud = test::unkind_cloud<2>(random, 200);
    CellIndex index(cloud, surfaces, cells);
    for (int removal = 0; removal < 5; ++removal) {
      const std::vector<int> which = any_numbers(random, cloud);
      index = index.with_removed(which);
      for (const int number : which) cloud[static_cast<std::size_t>(number)].setConstant(test::nan);
      const PointCloud2 more = test::unkind_cloud<2>(random, 5);
      index = index.with_added(more);
      test::append(cloud, more);
      index.build(static_cast<std::size_t>(random.integer(0, 5)), random.point<2>(2.0));
    }
    const CellIndex at_once(cloud, surfaces, cells);
    for (std::size_t k = 0; k < cloud.size(); ++k) {
      ASSERT_EQ(index.surface(k).valid(), at_once.surface(k).valid()) << k;
      ASSERT_LT((index.surface(k).centroid - at_once.surface(k).centroid).norm(), 1e-6) << k;
      ASSERT_LT((index.surface(k).normal - at_once.surface(k).normal).norm(), 1e-6) << k;
    }
  }
}

}  // namespace
}  // namespace slamicp::cell_index_property_test
