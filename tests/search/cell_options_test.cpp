// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/search/indexed_points.hpp>

#include "support/clouds.hpp"

namespace slamicp::cell_options_test {
namespace {

/// Refused by words that begin with the option and hold a number to go by.
void expect_refused(const CellOptions& cells, const std::string& option) {
  const std::string problem = cells.problem();
  EXPECT_EQ(problem.rfind(option, 0), 0U) << "'" << problem << "' should begin with " << option;
  EXPECT_NE(problem.find("default"), std::string::npos) << "'" << problem << "' should tell what to take instead";
  try {
    const IndexedPoints<2> index(PointCloud2{{0.0, 0.0}}, {}, cells);
    ADD_FAILURE() << "taken: cell " << cells.cell << ", reach " << cells.reach;
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "CellOptions");
    EXPECT_NE(std::string(error.what()).find(option), std::string::npos);
  }
}

TEST(CellOptionsTest, AbsurdOnesAreRefusedWithAMend) {
  for (const double cell : {0.0, -0.05, 0.0049, 0.2501, test::nan, test::infinity})
    expect_refused({.cell = cell}, "cell");
  for (const double reach : {0.0, -0.3, 0.7501, test::nan, test::infinity}) expect_refused({.reach = reach}, "reach");
  expect_refused({.cell = 0.01, .reach = 0.16}, "reach");
}

TEST(CellOptionsTest, LimitsAreAllowed) {
  EXPECT_EQ(CellOptions{}.problem(), "");
  for (const CellOptions& cells :
       {CellOptions{.cell = 0.005, .reach = 0.005 * 15.0}, CellOptions{.cell = 0.25},
        CellOptions{.cell = 0.25, .reach = 3.75}, CellOptions{.cell = 0.25, .reach = 1e-9}}) {
    EXPECT_EQ(cells.problem(), "");
    const CellIndex index(PointCloud2{{0.0, 0.0}, {0.004, 0.0}}, {}, cells);
    EXPECT_NEAR(index.cell(), cells.cell, 0.5 / 65536.0);
    EXPECT_EQ(index.tile(), 16.0 * index.cell());
    EXPECT_EQ(index.nearest({0.003, 0.0}, 1.0).index, 1);
  }
}

TEST(CellIndexTest, NumbersThatAreNotThereCannotBeRemoved) {
  const CellIndex index(PointCloud2{{0.0, 0.0}, {1.0, 0.0}}, {});
  for (const int number : {-1, 2}) {
    try {
      index.with_removed(std::vector{0, number});
      ADD_FAILURE() << "removed: " << number;
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), "CellIndex::with_removed");
      EXPECT_NE(error.mend().find("0 to 1"), std::string::npos) << error.mend();
    }
  }
  EXPECT_EQ(index.nearest({0.1, 0.0}, 1.0).index, 0);
  EXPECT_THROW(CellIndex().with_removed(std::vector{0}), Error);
}

TEST(CellIndexTest, PointsAtTheEdgeOfWhatCanBeFound) {
  const CellIndex index(PointCloud2{{1e7, -1e7}, {1.1e7, 0.0}, {-1e7, 1e7}, {1e300, 0.0}}, {},
                        {.cell = 0.005, .reach = 0.07});
  EXPECT_EQ(index.nearest({1e7 - 0.01, -1e7 + 0.02}, 0.07).index, 0);
  EXPECT_EQ(index.nearest({-1e7 + 0.01, 1e7 - 0.02}, 0.07).index, 2);
  EXPECT_FALSE(index.nearest({1.1e7, 0.0}, 0.07).found()) << "too far away to be found";
  EXPECT_EQ(index.nearest({1.1e7, 0.0}, 1e9).index, 0) << "not 1, which cannot be found";
  const CellIndex grown = index.with_added(PointCloud2{{1e7, 1e7}});
  EXPECT_EQ(grown.nearest({1e7 - 0.01, 1e7 + 0.02}, 0.07).index, 4);
}

TEST(CellIndexTest, QueriesFromBeyondAllMeasureFindNothingAndDoNoHarm) {
  const CellIndex index(PointCloud2{{0.0, 0.0}, {1.0, 0.0}}, {});
  for (const double far : {1e10, 1e160, 1e300})
    for (const double reach : {0.3, 1e5, test::infinity}) {
      const bool is_found = reach > far && far * far < test::infinity;
      EXPECT_EQ(index.nearest({far, 0.0}, reach).found(), is_found) << far << " " << reach;
      EXPECT_EQ(index.nearest_two({0.0, -far}, reach).nearest.found(), is_found) << far << " " << reach;
    }
}

TEST(CellIndexTest, EveryVersionHasItsOwnId) {
  const CellIndex index(PointCloud2{{0.0, 0.0}, {1.0, 0.0}}, {});
  const CellIndex copy = index;
  EXPECT_EQ(copy.id(), index.id());
  EXPECT_EQ(index.with_added({}).id(), index.id()) << "the same points, the same index";
  const CellIndex grown = index.with_added(PointCloud2{{2.0, 0.0}});
  EXPECT_NE(grown.id(), index.id());
  EXPECT_NE(index.with_removed(std::vector{0}).id(), index.id());
  EXPECT_NE(index.with_added(PointCloud2{{2.0, 0.0}}).id(), grown.id());
}

}  // namespace
}  // namespace slamicp::cell_options_test
