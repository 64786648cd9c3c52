// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "io/io_test_support.hpp"
#include "support/mcap_writer.hpp"
#include "support/recorded.hpp"

namespace slamicp::mcap_test {
namespace {

using io_test::expect_error;
using test::Recorded;
namespace mcap = test::mcap;

constexpr std::uint64_t second = 1'000'000'000;
const std::string start = mcap::magic + mcap::header();
const std::string channels = mcap::schema(1, "sensor_msgs/msg/LaserScan") + mcap::schema(2, "nav_msgs/Odometry") +
                             mcap::channel(0, 1, "/scan") + mcap::channel(7, 2, "/odom", "ros1");

Recorded read(const std::string& file) {
  Recorded recorded;
  read_mcap(file, "run.mcap", recorded);
  return recorded;
}

using Bodies = std::vector<std::string>;

TEST(Mcap, ChannelsAndMessagesComeInOrder) {
  const Recorded recorded = read(start + channels + mcap::message(0, 3 * second / 2, "one") +
                                 mcap::message(7, 2 * second, "two") + mcap::message(0, second, "three") + mcap::end());
  ASSERT_EQ(recorded.channels.size(), 2U);
  EXPECT_EQ(recorded.channels[0].topic, "/scan");
  EXPECT_EQ(recorded.channels[0].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(recorded.channels[0].serialization, Serialization::cdr);
  EXPECT_EQ(recorded.channels[1].type, "nav_msgs/Odometry");
  EXPECT_EQ(recorded.channels[1].serialization, Serialization::ros1);
  const std::vector<Recorded::Message> expected{{"/scan", 1.5, "one"}, {"/odom", 2.0, "two"}, {"/scan", 1.0, "three"}};
  EXPECT_EQ(recorded.messages, expected);
  EXPECT_TRUE(recorded.warnings.empty());
}

TEST(Mcap, UnwantedChannelsAreNotGiven) {
  Recorded recorded;
  recorded.unwanted = {"/odom"};
  read_mcap(start + channels + mcap::message(7, 0, "a") + mcap::message(0, 0, "b") + mcap::end(), "run.mcap", recorded);
  EXPECT_EQ(recorded.bodies(), Bodies{"b"});
}

TEST(Mcap, ChunksAreUnpacked) {
  const std::string records = channels + mcap::message(0, 0, std::string(100'000, 'x')) + mcap::message(0, 0, "last");
  for (const Compression kind : {Compression::none, Compression::lz4, Compression::zstd}) {
    if (!test::can_pack(kind)) continue;
    const std::string compression(kind == Compression::none ? "" : name_of(kind));
    const Recorded recorded = read(start + mcap::chunk(compression, records) +
                                   mcap::chunk(compression, mcap::message(7, 0, "next")) + mcap::end());
    EXPECT_EQ(recorded.bodies(), (Bodies{std::string(100'000, 'x'), "last", "next"})) << compression;
    EXPECT_TRUE(recorded.warnings.empty()) << compression;
  }
}

TEST(Mcap, UnknownRecordsAreSkipped) {
  const std::string unknown = mcap::record(0x77, "of another day") + mcap::record(0xF0, "private");
  const Recorded recorded = read(mcap::magic + unknown + mcap::header() + unknown + channels +
                                 mcap::chunk("", unknown + mcap::message(0, 0, "a") + unknown) + unknown + mcap::end());
  EXPECT_EQ(recorded.bodies(), Bodies{"a"});
  EXPECT_TRUE(recorded.warnings.empty());
}

TEST(Mcap, WhatFollowsTheDataIsNotReadAgain) {
  const Recorded recorded = read(start + channels + mcap::message(0, 0, "a") + mcap::record(0x0F, mcap::number(0, 4)) +
                                 channels + mcap::end());
  EXPECT_EQ(recorded.channels.size(), 2U);
  EXPECT_EQ(recorded.bodies(), Bodies{"a"});
}

TEST(Mcap, ChannelsOfOtherEncodingsAreLeftOut) {
  const Recorded recorded = read(start + channels + mcap::channel(3, 1, "/json", "json") + mcap::message(3, 0, "{}") +
                                 mcap::message(0, 0, "a") + mcap::end());
  EXPECT_EQ(recorded.channels.size(), 2U);
  EXPECT_EQ(recorded.bodies(), Bodies{"a"});
  EXPECT_TRUE(recorded.warned_of("channels in 'json' are left out"));
}

TEST(Mcap, AChunkWithAWrongChecksumIsLeftOut) {
  const std::string broken = mcap::message(0, 0, "broken");
  const Recorded recorded =
      read(start + channels + mcap::message(0, 0, "a") + mcap::chunk("", broken, broken.size(), 12345) +
           mcap::chunk("", mcap::message(0, 0, "b")) + mcap::end());
  EXPECT_EQ(recorded.bodies(), (Bodies{"a", "b"}));
  EXPECT_TRUE(recorded.warned_of("a chunk's checksum is wrong: left out"));
  const Recorded unchecked = read(start + channels + mcap::chunk("", broken, broken.size(), 0) + mcap::end());
  EXPECT_EQ(unchecked.bodies(), Bodies{"broken"});
}

TEST(Mcap, BrokenPiecesAreCountedInOneWarning) {
  const std::string a = mcap::message(0, 0, "a");
  const Recorded recorded =
      read(start + channels + a + mcap::chunk("", a, a.size() + 1, 0) + mcap::chunk("", a, std::uint64_t{1} << 60, 0) +
           mcap::chunk("snappy", a) + mcap::record(0x05, "short") + mcap::record(0x06, "short") +
           mcap::message(9, 0, "b") + mcap::chunk("", a.substr(0, a.size() - 1)) + a + mcap::end());
  EXPECT_EQ(recorded.bodies(), (Bodies{"a", "a"}));
  ASSERT_EQ(recorded.warnings.size(), 1U);
  EXPECT_TRUE(recorded.warned_of(": left out, as are 6 other pieces")) << recorded.warnings[0];
}

TEST(Mcap, WhereNothingCanBeHadItSaysWhy) {
  const std::string a = mcap::message(0, 0, "a");
  const std::string where = "run.mcap, byte " + std::to_string((start + channels).size());
  expect_error([&] { read(start + channels + mcap::chunk("snappy", a) + mcap::end()); }, where, "packed with 'snappy'");
  expect_error([&] { read(start + channels + mcap::chunk("", a, a.size(), 5) + mcap::end()); }, where, "checksum");
  expect_error([&] { read(start + channels + mcap::chunk("", a, std::uint64_t{1} << 60, 0) + mcap::end()); }, where,
               "1152921504606846976 bytes");
  expect_error([&] { read(start + channels); }, where, "is cut");
  expect_error([&] { read("#ROSBAG V2.0\n"); }, "run.mcap", "is no MCAP file");
  expect_error([&] { read(""); }, "run.mcap", "is no MCAP file");
}

TEST(Mcap, AnEmptyRecordingIsNoError) { EXPECT_TRUE(read(start + mcap::end()).messages.empty()); }

TEST(Mcap, CutAnywhereItGivesWhatCameWhole) {
  const std::string plain = start + channels + mcap::message(0, 0, "a") + mcap::message(0, 0, "b");
  const std::string chunked = plain + mcap::chunk("", mcap::message(0, 0, "c") + mcap::message(0, 0, "d"));
  for (std::size_t size = 0; size < chunked.size(); ++size) {
    Recorded recorded;
    try {
      read_mcap(std::string_view(chunked).substr(0, size), "run.mcap", recorded);
      EXPECT_TRUE(recorded.warned_of("is cut")) << size;
      EXPECT_FALSE(recorded.messages.empty());
    } catch (const Error& error) {
      EXPECT_TRUE(recorded.messages.empty()) << size;
      EXPECT_FALSE(error.mend().empty());
    }
    Bodies whole{"a", "b", "c", "d"};
    whole.resize(recorded.messages.size());
    EXPECT_EQ(recorded.bodies(), whole);
    if (size + 1 == chunked.size()) {
      EXPECT_EQ(recorded.messages.size(), 3U) << "a whole message in a chunk that is cut";
    }
  }
}

TEST(Mcap, AnErrorOfTheVisitorPasses) {
  struct Stopping : Recorded {
    void take(int, double, std::string_view) override { throw Error("enough", "visitor", "none needed"); }
  } stopping;
  const std::string file = start + channels + mcap::chunk("", mcap::message(0, 0, "a")) + mcap::end();
  expect_error([&] { read_mcap(file, "run.mcap", stopping); }, "visitor", "enough");
}

}  // namespace
}  // namespace slamicp::mcap_test
