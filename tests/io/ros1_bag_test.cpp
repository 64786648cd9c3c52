// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gtest/gtest.h>

#include "io/io_test_support.hpp"
#include "io/recording.hpp"
#include "support/bag_writer.hpp"
#include "support/recorded.hpp"

namespace slamicp::ros1_bag_test {
namespace {

using io_test::expect_error;
using test::BagWriter;
using test::Recorded;

constexpr int message_count = 40;

/// Two topics with messages, one without, in four chunks.
BagWriter a_bag(Compression compression) {
  BagWriter writer(compression);
  const auto scan = writer.connection("/scan", "sensor_msgs/LaserScan");
  const auto odom = writer.connection("/odom", "nav_msgs/Odometry");
  writer.connection("/silent", "std_msgs/String");
  for (int i = 0; i < message_count; ++i) {
    writer.message(i % 2 == 0 ? scan : odom, 100.0 + 0.25 * i, "message " + std::to_string(i) + std::string(100, '.'));
    if (i % 10 == 9) writer.end_chunk();
  }
  return writer;
}

Recorded read(std::string_view bytes) {
  Recorded recorded;
  read_ros1_bag(bytes, "run.bag", recorded);
  return recorded;
}

/// The messages are the first ones of the bag.
void expect_first_messages(const Recorded& recorded, const std::string& what) {
  const Recorded all = read(a_bag(Compression::none).bag());
  ASSERT_LE(recorded.messages.size(), all.messages.size()) << what;
  EXPECT_TRUE(std::equal(recorded.messages.begin(), recorded.messages.end(), all.messages.begin())) << what;
}

class Ros1Bag : public ::testing::TestWithParam<Compression> {
 protected:
  void SetUp() override {
    if (!test::can_pack(GetParam())) GTEST_SKIP() << "skipped: this build has no " << name_of(GetParam());
  }
};

TEST_P(Ros1Bag, GivesEveryMessageInItsOrder) {
  const Recorded recorded = read(a_bag(GetParam()).bag());
  ASSERT_EQ(recorded.messages.size(), static_cast<std::size_t>(message_count));
  for (int i = 0; i < message_count; ++i) {
    const Recorded::Message& message = recorded.messages[static_cast<std::size_t>(i)];
    EXPECT_EQ(message.topic, i % 2 == 0 ? "/scan" : "/odom");
    EXPECT_DOUBLE_EQ(message.logged, 100.0 + 0.25 * i);
    EXPECT_EQ(message.body, "message " + std::to_string(i) + std::string(100, '.'));
  }
  ASSERT_EQ(recorded.channels.size(), 3U);
  EXPECT_EQ(recorded.channels[0].topic, "/scan");
  EXPECT_EQ(recorded.channels[0].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(recorded.channels[0].serialization, Serialization::ros1);
  EXPECT_EQ(recorded.channels[2].topic, "/silent");
  EXPECT_TRUE(recorded.warnings.empty());
}

TEST_P(Ros1Bag, CutAnywhereGivesWhatCameWholeAndAWarning) {
  const std::string bag = a_bag(GetParam()).bag();
  std::size_t read_something = 0;
  for (std::size_t size = 0; size < bag.size(); size += size < 4096 ? 1000 : 37) {
    const std::string what = "cut at " + std::to_string(size);
    try {
      const Recorded recorded = read(std::string_view(bag).substr(0, size));
      expect_first_messages(recorded, what);
      EXPECT_FALSE(recorded.warnings.empty()) << what;
      ++read_something;
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), "run.bag") << what;
      EXPECT_FALSE(error.mend().empty()) << what;
    }
  }
  EXPECT_GT(read_something, 10U);
}

TEST_P(Ros1Bag, DamagedBytesNeverStopTheProgram) {
  const std::string bag = a_bag(GetParam()).bag();
  for (std::size_t at = 0; at < bag.size(); at += at < 4096 ? 64 : 3) {
    std::string damaged = bag;
    damaged[at] = static_cast<char>(damaged[at] ^ 0xFF);
    try {
      EXPECT_LE(read(damaged).messages.size(), static_cast<std::size_t>(message_count)) << at;
    } catch (const Error& error) {
      EXPECT_FALSE(error.problem().empty() || error.mend().empty()) << at;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Ros1Bag, ::testing::Values(Compression::none, Compression::lz4, Compression::bz2),
                         [](const auto& param_info) { return std::string(name_of(param_info.param)); });

TEST(Ros1BagIndex, IsNotNeeded) {
  const Recorded recorded = read(a_bag(Compression::none).bag(false));
  EXPECT_EQ(recorded.messages.size(), static_cast<std::size_t>(message_count));
  EXPECT_EQ(recorded.channels.size(), 2U);
  ASSERT_EQ(recorded.warnings.size(), 1U);
  EXPECT_TRUE(recorded.warned_of("was not closed and has no index"));
}

TEST(Ros1BagIndex, MayBeCutOff) {
  const std::string bag = a_bag(Compression::none).bag();
  const std::size_t records = a_bag(Compression::none).bag(false).size();
  const Recorded recorded = read(std::string_view(bag).substr(0, records));
  EXPECT_EQ(recorded.messages.size(), static_cast<std::size_t>(message_count));
  EXPECT_TRUE(recorded.warned_of("its index is cut or damaged"));
}

TEST(Ros1BagIndex, MayHaveRecordsOfWrongLength) {
  BagWriter writer = a_bag(Compression::none);
  writer.bytes_told_per_entry = 20;  // as ROS Cturtle's recorder wrote them: the chunks above have theirs already
  const auto more = writer.connection("/more", "std_msgs/String");
  writer.message(more, 200.0, "last");
  const Recorded recorded = read(writer.bag());
  EXPECT_EQ(recorded.messages.size(), static_cast<std::size_t>(message_count) + 1);
  ASSERT_EQ(recorded.warnings.size(), 1U);
  EXPECT_TRUE(recorded.warned_of("1 index record with a wrong length: not needed"));
}

TEST(Ros1BagReader, LeavesOutChunksThatCannotBeUnpacked) {
  if (!test::can_pack(Compression::bz2)) GTEST_SKIP() << "skipped: this build has no bz2";
  std::string bag = a_bag(Compression::bz2).bag();
  const std::size_t second = bag.find("BZh", bag.find("BZh") + 1);
  bag[second + 20] = static_cast<char>(bag[second + 20] ^ 0xFF);
  const Recorded recorded = read(bag);
  EXPECT_EQ(recorded.messages.size(), 30U);
  EXPECT_TRUE(recorded.warned_of("1 chunk cannot be unpacked: left out (the one at byte "));
  EXPECT_TRUE(recorded.warned_of("is no bz2, or broken"));
}

TEST(Ros1BagReader, AsksForNoMoreThanTheVisitorWants) {
  Recorded recorded;
  recorded.unwanted = {"/odom"};
  read_ros1_bag(a_bag(Compression::none).bag(), "run.bag", recorded);
  EXPECT_EQ(recorded.messages.size(), 20U);
}

TEST(Ros1BagReader, LetsTheVisitorStop) {
  struct Stopping : Recorded {
    void take(int, double, std::string_view) override { throw Error("enough", "here", "none"); }
  } stopping;
  expect_error([&] { read_ros1_bag(a_bag(Compression::none).bag(), "run.bag", stopping); }, "here", "enough");
}

TEST(Ros1BagReader, SaysWhatIsNoBag) {
  expect_error([] { read(""); }, "run.bag", "is no ROS bag");
  expect_error([] { read("SQLite format 3"); }, "run.bag", "is no ROS bag");
  expect_error([] { read("#ROSBAG V1.2\nxyz"); }, "run.bag", "is a bag of another format, '#ROSBAG V1.2'");
  expect_error([] { read("#ROSRECORD V1.1\n"); }, "run.bag", "is a bag of another format");
  expect_error([] { read("#ROSBAG V2.0\n"); }, "run.bag", "its first record is no bag header");
}

TEST(Ros1BagReader, EmptyBagIsNoError) {
  EXPECT_TRUE(read(BagWriter().bag()).messages.empty());
  EXPECT_TRUE(read(BagWriter().bag()).warnings.empty());
}

TEST(Ros1BagReader, LeavesOutMessagesOfNoKnownTopic) {
  BagWriter writer = a_bag(Compression::none);
  std::string bag = writer.bag(false);
  // The name of the field that says which connection it is: where it is gone, the record is of no use.
  for (std::size_t at = bag.find("topic=/odom"); at != std::string::npos; at = bag.find("topic=/odom", at))
    bag[at] = 'T';
  const Recorded recorded = read(bag);
  EXPECT_EQ(recorded.messages.size(), 20U);
  EXPECT_TRUE(recorded.warned_of("20 messages of no known topic: left out"));
}

}  // namespace
}  // namespace slamicp::ros1_bag_test
