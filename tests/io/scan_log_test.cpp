// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/io/file_kind.hpp>
#include <slamicp/io/scan_log.hpp>

#include "io/io_test_support.hpp"
#include "support/bag_writer.hpp"
#include "support/packing.hpp"

namespace slamicp::scan_log_test {
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

TEST(ScanLog, TakesTextThatIsPacked) {
  const TemporaryFolder folder;
  save_scan_log(folder / "a.clf", one_scan());
  save_scan_log(folder / "a.csv", one_scan());
  for (const auto& [compression, ending] :
       {std::pair(Compression::gzip, ".gz"), std::pair(Compression::xz, ".xz"), std::pair(Compression::zstd, ".zst"),
        std::pair(Compression::bz2, ".BZ2")}) {
    if (!test::can_pack(compression)) continue;
    for (const char* name : {"a.clf", "a.csv"}) {
      const std::filesystem::path packed = folder / (std::string(name) + ending);
      io_test::put(packed, test::pack(compression, io_test::get(folder / name)));
      EXPECT_EQ(kind_of(packed), FileKind::scan_log);
      const ScanLog log = open_scan_log(packed);
      ASSERT_EQ(log.size(), 1U) << packed;
      EXPECT_EQ(log[0].ranges, one_scan()[0].ranges);
      const std::string content = io_test::get(packed);
      io_test::put(packed, std::string_view(content).substr(0, content.size() / 2));
      expect_error([&] { open_scan_log(packed); }, packed.string(), "is cut");
    }
  }
}

TEST(ScanLog, TakesABagThatWasNeverClosed) {
  const TemporaryFolder folder;
  test::BagWriter writer;
  writer.message(writer.connection("/scan", "sensor_msgs/LaserScan"), 1.0, test::ScanMessage{.stamp = 1.0}.message());
  io_test::put(folder / "run.bag.active", writer.bag(false));
  EXPECT_EQ(kind_of(folder / "run.bag.active"), FileKind::scan_log);
  const ScanLog log = open_scan_log(folder / "run.bag.active");
  EXPECT_EQ(log.size(), 1U);
  EXPECT_EQ(log.warnings.size(), 1U);
}

TEST(ScanLog, SaysWhatItCannotRead) {
  const TemporaryFolder folder;
  expect_error([&] { open_scan_log(folder / "a.xyz"); }, (folder / "a.xyz").string(), "ending '.xyz'");
  expect_error([&] { open_scan_log(folder / "no.clf"); }, (folder / "no.clf").string(), "cannot be read: No such file");
  std::filesystem::create_directory(folder / "dir.clf");
  expect_error([&] { open_scan_log(folder / "dir.clf"); }, (folder / "dir.clf").string(), "is a folder");
  std::filesystem::create_directory(folder / "dir");
  expect_error([&] { open_scan_log(folder / "dir"); }, (folder / "dir").string(), "is a folder without metadata.yaml");
  expect_error([&] { open_scan_log(folder / "no.bag"); }, (folder / "no.bag").string(), "cannot be read: No such file");
  io_test::put(folder / "empty.bag", "");
  expect_error([&] { open_scan_log(folder / "empty.bag"); }, (folder / "empty.bag").string(), "is no ROS bag");
  expect_error([&] { open_scan_log(folder / "a.bag.gz"); }, (folder / "a.bag.gz").string(), "ending '.gz'");
  expect_error([&] { save_scan_log(folder / "a.clf.gz", one_scan()); }, (folder / "a.clf.gz").string(), "ending '.gz'");
  expect_error([&] { save_scan_log(folder / "a.bag", one_scan()); }, (folder / "a.bag").string(), "ending '.bag'");
}

}  // namespace
}  // namespace slamicp::scan_log_test
