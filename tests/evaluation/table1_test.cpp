// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/table1.hpp>

#include "sampled_site.hpp"

namespace slamicp::table1_test {
namespace {

TEST(Table1, ThePapersRowsGiveItsMeanImprovement) {
  double sum = 0.0;
  for (const PaperTable1Row& row : paper_table1()) sum += improvement_percent(row.original_ms, row.improved_ms);
  ASSERT_EQ(paper_table1().size(), 12U);
  EXPECT_NEAR(sum / 12.0, 36.75, 0.05);
}

TEST(Table1, ARowCountsOutliersAndTimesAndFindsTheObstacle) {
  double time = 0.0;
  const Table1Row row = table1_row(sampled_site(), "D1", {1, 1, 600}, [&] { return time += 0.001; });
  EXPECT_NEAR(static_cast<double>(row.most_outliers), 63.0, 12.0);  // the paper's
  EXPECT_EQ(row.runs_finished, 1U);
  EXPECT_EQ(row.cycles_held_back, 0U);
  EXPECT_TRUE(row.found_within(0.5));
  EXPECT_GT(row.scans, 1500U);
  EXPECT_EQ(row.replayed, (row.scans - 1) / 600);
  EXPECT_NEAR(row.original_outliers, row.improved_outliers, 2.0);
  for (const double seconds : {row.original.once, row.original.rebuilt, row.improved.once, row.improved.rebuilt})
    EXPECT_NEAR(seconds, 0.004, 1e-9);
}

TEST(Table1, IsNotFoundInTimeWhereARunFoundItLateOrNever) {
  Table1Row row;
  row.sightings = {{1.0, 1.4, 2.0}, {1.0, 0.5, 2.0}};
  EXPECT_TRUE(row.found_within(0.5));
  EXPECT_FALSE(row.found_within(0.3));
  row.sightings.push_back({});
  EXPECT_FALSE(row.found_within(0.5));
}

TEST(Table1, RefusesNoRuns) {
  EXPECT_THROW(table1_row(sampled_site(), "A1", {1, 0, 50}, {}), Error);
  EXPECT_THROW(table1_row(sampled_site(), "A1", {1, 1, 0}, {}), Error);
}

}  // namespace
}  // namespace slamicp::table1_test
