// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/io/scan_log.hpp>

#include "io/io_test_support.hpp"

namespace slamicp {
namespace {

using io_test::expect_error;
using io_test::TemporaryFolder;

std::vector<LaserScan> one_scan() {
  LaserScan scan;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.5;
  scan.ranges = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F};
  scan.T_odom_robot = Pose2{1.0, 2.0, 3.0};
  return {scan};
}

TEST(ScanLog, GoesByTheFileNamesEnding) {
  const TemporaryFolder folder;
  for (const char* name : {"a.clf", "a.LOG", "a.csv"}) {
    save_scan_log(folder / name, one_scan());
    const ScanLog log = open_scan_log(folder / name);
    ASSERT_EQ(log.size(), 1U) << name;
    EXPECT_EQ(log[0].ranges, one_scan()[0].ranges);
    EXPECT_EQ(log.name, (folder / name).string());
  }
  EXPECT_EQ(open_scan_log(folder / "a.clf").format, "CARMEN");
  EXPECT_EQ(open_scan_log(folder / "a.csv").format, "ranges CSV");
}

TEST(ScanLog, SaysWhatItCannotRead) {
  const TemporaryFolder folder;
  expect_error([&] { open_scan_log(folder / "a.xyz"); }, (folder / "a.xyz").string(), "ending '.xyz'");
  expect_error([&] { open_scan_log(folder / "no.clf"); }, (folder / "no.clf").string(), "cannot be read: No such file");
  std::filesystem::create_directory(folder / "dir.clf");
  expect_error([&] { open_scan_log(folder / "dir.clf"); }, (folder / "dir.clf").string(), "is a folder");
  expect_error([&] { save_scan_log(folder / "a.bag", one_scan()); }, (folder / "a.bag").string(), "ending '.bag'");
}

}  // namespace
}  // namespace slamicp
