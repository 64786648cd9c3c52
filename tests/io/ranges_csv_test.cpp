// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <numbers>

#include <slamicp/io/ranges_csv.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::ranges_csv_test {
namespace {

using io_test::expect_error;

TEST(RangesCsv, ReadsAScanALine) {
  const ScanLog log =
      parse_ranges_csv("1,2,0,4,5\n1.5,0.001,inf,nan,+5\n", "r.csv", {.fov_deg = 180, .scan_rate_hz = 10});
  ASSERT_EQ(log.size(), 2U);
  EXPECT_DOUBLE_EQ(log[0].angle_min, -std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(log[0].angle_increment, std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(log[1].stamp, 0.1);
  EXPECT_FALSE(log[1].T_odom_robot);
  const std::vector<bool> wanted{true, false, false, false, true};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(is_return(log[1], log[1].ranges[i]), wanted[i]) << i;
}

TEST(RangesCsv, AShortLastLineIsAWarning) {
  for (const char* last : {"1,2", "1,2\n", "1,2.", "1,2e", "1,2,3,-"}) {
    const ScanLog log = parse_ranges_csv(std::string("1,2,3,4,5\n") + last, "r.csv");
    EXPECT_EQ(log.size(), 1U) << last;
    ASSERT_EQ(log.warnings.size(), 1U) << last;
    EXPECT_NE(log.warnings[0].find("line 2, the last, is cut"), std::string::npos);
  }
}

TEST(RangesCsv, WrongCountsAndWordsAreErrors) {
  expect_error([] { parse_ranges_csv("1,2,3,4\n1,2,3\n1,2,3,4\n", "r.csv"); }, "r.csv:2",
               "3 ranges, but the lines before have 4");
  expect_error([] { parse_ranges_csv("1,2,3,4\n1,2,3,4,5\n", "r.csv"); }, "r.csv:2", "5 ranges");
  expect_error([] { parse_ranges_csv("1,2,3,4\n1,b,3,4\n", "r.csv"); }, "r.csv:2", "range 1 is not a number: 'b'");
  expect_error([] { parse_ranges_csv("1,2,3,4\n1,,3,4\n", "r.csv"); }, "r.csv:2", "range 1 is not a number: ''");
  expect_error([] { parse_ranges_csv("x,y\n1,2\n", "r.csv"); }, "r.csv:1", "not a number: 'x'");
  expect_error([] { parse_ranges_csv("1,2\n1,2\n", "r.csv"); }, "r.csv:1", "a point, not a scan");
  expect_error([] { parse_ranges_csv("", "r.csv"); }, "r.csv", "holds no scan");
  expect_error([] { parse_ranges_csv("\n\r\n", "r.csv"); }, "r.csv", "holds no scan");
}

TEST(RangesCsv, OptionsAreChecked) {
  expect_error([] { parse_ranges_csv("1,2,3,4\n", "r.csv", {.fov_deg = 0}); }, "ScanLogOptions", "fov_deg");
  expect_error([] { parse_ranges_csv("1,2,3,4\n", "r.csv", {.scan_rate_hz = -1}); }, "ScanLogOptions", "scan_rate_hz");
}

TEST(RangesCsv, TakesCrlfBlanksAndAByteOrderMark) {
  const ScanLog log = parse_ranges_csv(
      "\xEF\xBB\xBF"
      "1, 2, 3, 4\r\n5 , 6, 7, 8\r\n",
      "r.csv");
  ASSERT_EQ(log.size(), 2U);
  EXPECT_EQ(log[1].ranges[3], 8.0F);
}

TEST(RangesCsv, WhatIsWrittenComesBack) {
  LaserScan scan;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  scan.ranges = {0.05F, 1.2345678F, 30.0F, 29.0F};
  const std::vector<LaserScan> scans{scan, scan};
  const std::string text = ranges_csv_text(scans);
  const ScanLog log = parse_ranges_csv(text, "r.csv");
  ASSERT_EQ(log.size(), 2U);
  EXPECT_EQ(log[1].ranges, (std::vector<float>{0.0F, 1.2345678F, 0.0F, 29.0F}));
  std::vector<LaserScan> uneven = scans;
  uneven[1].ranges.pop_back();
  expect_error([&] { ranges_csv_text(uneven); }, "ranges CSV", "scan 1 has 3 beams");
}

}  // namespace
}  // namespace slamicp::ranges_csv_test
