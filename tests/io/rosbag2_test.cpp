// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "io/io_test_support.hpp"
#include "io/rosbag2_database.hpp"
#include "io/rosbag2_files.hpp"
#include "support/mcap_writer.hpp"
#include "support/recorded.hpp"
#include "support/rosbag2_writer.hpp"

namespace slamicp::rosbag2_test {
namespace {

using io_test::expect_error;
using io_test::get;
using io_test::put;
using io_test::TemporaryFolder;
using test::Recorded;
using Bodies = std::vector<std::string>;

Recorded read(const std::filesystem::path& path) {
  Recorded recorded;
  read_rosbag2(path, recorded);
  return recorded;
}

#ifdef SLAMICP_WITH_SQLITE

using test::Rosbag2Writer;

constexpr std::int64_t second = 1'000'000'000;

/// A database of one scan topic.
void write_scans(const std::filesystem::path& path, const Bodies& bodies) {
  Rosbag2Writer out(path);
  out.topic(1, "/scan", "sensor_msgs/msg/LaserScan").run("BEGIN");
  std::int64_t stamp = 0;
  for (const std::string& body : bodies) out.message(1, ++stamp * second, body);
  out.run("COMMIT");
}

std::string metadata(const Bodies& files, const std::string& more = "") {
  std::string text =
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n" + more + "  relative_file_paths:\n";
  for (const std::string& file : files) text += "    - " + file + "\n";
  return text;
}

TEST(Rosbag2, MessagesComeByTheirStamps) {
  const TemporaryFolder folder;
  Rosbag2Writer(folder / "run.db3")
      .topic(1, "/scan", "sensor_msgs/msg/LaserScan")
      .topic(4, "/odom", "nav_msgs/msg/Odometry")
      .message(1, 3 * second / 2, "b")
      .message(4, second, "a")
      .message(1, 2 * second, "c")
      .message(4, 2 * second, "d");
  const Recorded recorded = read(folder / "run.db3");
  ASSERT_EQ(recorded.channels.size(), 2U);
  EXPECT_EQ(recorded.channels[0].topic, "/scan");
  EXPECT_EQ(recorded.channels[0].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(recorded.channels[0].serialization, Serialization::cdr);
  EXPECT_EQ(recorded.channels[1].type, "nav_msgs/Odometry");
  const std::vector<Recorded::Message> expected{
      {"/odom", 1.0, "a"}, {"/scan", 1.5, "b"}, {"/scan", 2.0, "c"}, {"/odom", 2.0, "d"}};
  EXPECT_EQ(recorded.messages, expected);
  EXPECT_TRUE(recorded.warnings.empty());
}

TEST(Rosbag2, UnwantedTopicsAreNotGiven) {
  const TemporaryFolder folder;
  Rosbag2Writer(folder / "run.db3")
      .topic(1, "/scan", "sensor_msgs/msg/LaserScan")
      .topic(2, "/image", "sensor_msgs/msg/Image")
      .topic(3, "/other", "x/msg/Y", "protobuf")
      .message(2, 1, "image")
      .message(1, 2, "scan")
      .message(3, 3, "other");
  Recorded recorded;
  recorded.unwanted = {"/image"};
  read_rosbag2(folder / "run.db3", recorded);
  EXPECT_EQ(recorded.channels.size(), 2U);
  EXPECT_EQ(recorded.bodies(), Bodies{"scan"});
  EXPECT_TRUE(recorded.warned_of("topic '/other' is in 'protobuf', not in cdr: left out"));
}

TEST(Rosbag2, NothingIsWrittenBesideTheFile) {
  const TemporaryFolder folder;
  const std::string name = "a b%20?#.db3";
  Rosbag2Writer out(folder / name);
  out.run("PRAGMA journal_mode=WAL");
  out.topic(1, "/scan", "sensor_msgs/msg/LaserScan").message(1, second, "a").run("PRAGMA wal_checkpoint(TRUNCATE)");
  const std::string before = get(folder / name);
  std::filesystem::create_directory(folder / "copy");
  put(folder.path() / "copy" / name, before);
  EXPECT_EQ(read(folder.path() / "copy" / name).bodies(), Bodies{"a"});
  EXPECT_EQ(get(folder.path() / "copy" / name), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "copy"), {}), 1);
  // What the recorder has not yet joined to the file is not seen, and that is said.
  out.message(1, 2 * second, "b");
  const Recorded recorded = read(folder / name);
  EXPECT_EQ(recorded.bodies(), Bodies{"a"});
  EXPECT_TRUE(recorded.warned_of("-wal beside it is not read"));
}

TEST(Rosbag2, CutAnywhereItGivesWhatCameWhole) {
  const TemporaryFolder folder;
  Bodies bodies;
  for (int i = 0; i < 120; ++i) bodies.emplace_back(700, static_cast<char>('a' + i % 26));
  write_scans(folder / "whole.db3", bodies);
  const std::string whole = get(folder / "whole.db3");
  ASSERT_GT(whole.size(), 80'000U);
  std::size_t partly = 0;
  for (std::size_t size = 0; size < whole.size(); size += 1000) {
    put(folder / "cut.db3", whole.substr(0, size));
    Recorded recorded;
    try {
      read_rosbag2(folder / "cut.db3", recorded);
      ASSERT_TRUE(recorded.warned_of("is damaged")) << size;
      ASSERT_FALSE(recorded.messages.empty()) << size;
      ++partly;
    } catch (const Error& error) {
      ASSERT_TRUE(recorded.messages.empty()) << size << error.what();
      ASSERT_FALSE(error.mend().empty());
    }
    for (const Recorded::Message& message : recorded.messages)
      ASSERT_EQ(message.body, bodies.at(static_cast<std::size_t>(message.logged) - 1));
  }
  EXPECT_GT(partly, 30U);
}

TEST(Rosbag2, WhatIsNoRosbag2IsNamed) {
  const TemporaryFolder folder;
  put(folder / "text.db3",
      "this is a text of more than a hundred bytes, which nobody would take for a database, "
      "even on a bad day, and here it ends");
  expect_error([&] { read(folder / "text.db3"); }, (folder / "text.db3").string(), "is no SQLite database");
  put(folder / "empty.db3", "");
  expect_error([&] { read(folder / "empty.db3"); }, (folder / "empty.db3").string(), "no such table: topics");
  expect_error([&] { read(folder / "none.db3"); }, (folder / "none.db3").string(), "cannot be read");
  put(folder / "run.bag", "");
  expect_error([&] { read(folder / "run.bag"); }, (folder / "run.bag").string(), "no file of rosbag2");
  {
    Rosbag2Writer out(folder / "views.db3");
    out.topic(1, "/scan", "sensor_msgs/msg/LaserScan");
    out.run("DROP TABLE messages");
    out.run("CREATE VIEW messages AS SELECT 1 rowid, 1 topic_id, 1 timestamp, 'x' data");
  }
  expect_error([&] { read(folder / "views.db3"); }, (folder / "views.db3").string(), "view");
}

TEST(Rosbag2, ContentInMemoryIsReadToo) {
  const TemporaryFolder folder;
  {
    Rosbag2Writer out(folder / "run.db3");
    out.run("PRAGMA journal_mode=WAL");
    out.topic(1, "/scan", "sensor_msgs/msg/LaserScan").message(1, second, "a");
  }
  Recorded recorded;
  read_rosbag2_database(get(folder / "run.db3"), "run.db3", recorded);
  EXPECT_EQ(recorded.bodies(), Bodies{"a"});
}

TEST(Rosbag2Folder, FilesComeInTheOrderOfTheMetadata) {
  const TemporaryFolder folder;
  write_scans(folder / "run_0.db3", {"a", "b"});
  write_scans(folder / "run_1.db3", {"c"});
  write_scans(folder / "not_of_it.db3", {"x"});
  put(folder / "metadata.yaml", metadata({"run_1.db3", "old_folder/run_0.db3"}));
  const Recorded recorded = read(folder.path());
#ifdef SLAMICP_WITH_YAML
  EXPECT_EQ(recorded.bodies(), (Bodies{"c", "a", "b"}));
  EXPECT_TRUE(recorded.warnings.empty());
#else
  EXPECT_TRUE(recorded.warned_of("built without yaml-cpp"));
#endif
}

TEST(Rosbag2Folder, WithoutMetadataFilesComeByTheirNumbers) {
  const TemporaryFolder folder;
  write_scans(folder / "run_9.db3", {"a"});
  write_scans(folder / "run_10.db3", {"b"});
  put(folder / "notes.txt", "no recording");
  const Recorded recorded = read(folder.path());
  EXPECT_EQ(recorded.bodies(), (Bodies{"a", "b"}));
  EXPECT_TRUE(recorded.warned_of("has no metadata.yaml"));
#ifdef SLAMICP_WITH_YAML
  for (const std::string broken : {"rosbag2_bagfile_information: [", "", "other: 1", "- 1\n- 2",
                                   "rosbag2_bagfile_information:\n  relative_file_paths:\n    - {a: 1}\n"}) {
    put(folder / "metadata.yaml", broken);
    const Recorded again = read(folder.path());
    EXPECT_EQ(again.bodies(), (Bodies{"a", "b"}));
    EXPECT_TRUE(again.warned_of("metadata.yaml")) << broken;
  }
#endif
}

TEST(Rosbag2Folder, ABrokenFileIsLeftOut) {
  const TemporaryFolder folder;
  write_scans(folder / "run_0.db3", {"a"});
  put(folder / "run_1.db3", std::string(200, 'x'));
  put(folder / "metadata.yaml", metadata({"run_0.db3", "run_1.db3", "run_2.db3"}));
#ifdef SLAMICP_WITH_YAML
  const Recorded recorded = read(folder.path());
  EXPECT_EQ(recorded.bodies(), Bodies{"a"});
  EXPECT_TRUE(recorded.warned_of("run_1.db3: is no SQLite database: left out"));
  EXPECT_TRUE(recorded.warned_of("run_2.db3: cannot be read"));
#endif
  std::filesystem::remove(folder / "run_0.db3");
  EXPECT_THROW(read(folder.path()), Error);
}

TEST(Rosbag2Folder, AnErrorOfTheVisitorPasses) {
  const TemporaryFolder folder;
  write_scans(folder / "run_0.db3", {"a"});
  write_scans(folder / "run_1.db3", {"b"});
  struct Stopping : Recorded {
    void take(int, double, std::string_view) override { throw Error("enough", "visitor", "none needed"); }
  } stopping;
  expect_error([&] { read_rosbag2(folder.path(), stopping); }, "visitor", "enough");
}

#ifdef SLAMICP_WITH_ZSTD
TEST(Rosbag2Folder, PackedFilesAndMessagesAreUnpacked) {
  const TemporaryFolder folder;
  const std::string a = test::pack(Compression::zstd, "a");
  write_scans(folder / "run_0.db3", {a, a.substr(0, a.size() - 1), "b"});
  write_scans(folder / "plain.db3", {"c"});
  put(folder / "run_1.db3.zstd", test::pack(Compression::zstd, get(folder / "plain.db3")));
  put(folder / "run_2.db3.zstd", "nothing packed");
  std::filesystem::remove(folder / "plain.db3");
  put(folder / "metadata.yaml",
      metadata({"run_0.db3", "run_1.db3", "run_2.db3.zstd"}, "  compression_format: zstd\n  compression_mode: FILE\n"));
  const Recorded recorded = read(folder.path());
  EXPECT_EQ(recorded.bodies(), (Bodies{"a", "b", "c"}));
  EXPECT_TRUE(recorded.warned_of("run_0.db3: 1 message cannot be unpacked"));
  EXPECT_TRUE(recorded.warned_of("run_2.db3.zstd: "));
}
#endif

#else

TEST(Rosbag2, ABuildWithoutItSaysSo) {
  const TemporaryFolder folder;
  put(folder / "run.db3", "");
  expect_error([&] { read(folder / "run.db3"); }, (folder / "run.db3").string(), "built without SQLite");
}

#endif

TEST(Rosbag2Folder, HoldsMcapFilesToo) {
  const TemporaryFolder folder;
  namespace mcap = test::mcap;
  put(folder / "run_0.mcap", mcap::magic + mcap::schema(1, "sensor_msgs/msg/LaserScan") + mcap::channel(1, 1, "/scan") +
                                 mcap::message(1, 0, "a") + mcap::end());
  EXPECT_EQ(read(folder.path()).bodies(), Bodies{"a"});
}

TEST(Rosbag2Folder, IsKnownByWhatItHolds) {
  const TemporaryFolder folder;
  EXPECT_FALSE(is_rosbag2(folder.path()));
  put(folder / "run_0.db3.zstd", "");
  EXPECT_TRUE(is_rosbag2(folder.path()));
  EXPECT_TRUE(is_rosbag2(folder / "run_0.db3.zstd"));
  EXPECT_FALSE(is_rosbag2(folder / "run.csv.zst"));
}

TEST(Rosbag2Folder, AnEmptyOneIsNoRecording) {
  const TemporaryFolder folder;
  expect_error([&] { read(folder.path()); }, folder.path().string(), "holds no rosbag2");
}

}  // namespace
}  // namespace slamicp::rosbag2_test
