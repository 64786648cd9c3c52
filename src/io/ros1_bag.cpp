// SPDX-License-Identifier: Apache-2.0
// ROS bags of format 2.0, https://wiki.ros.org/Bags/Format/2.0: records of a header, fields name=value, and data. They
// are read from the first to the last, so that the index at the end is only looked at for the topics without messages:
// recordings that were cut have none, and some recorders wrote wrong ones.
#include <algorithm>
#include <map>
#include <optional>

#include <slamicp/error.hpp>

#include "io/bag_records.hpp"
#include "io/binary.hpp"
#include "io/compression.hpp"
#include "io/recording.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr std::string_view magic = "#ROSBAG V2.0\n";
constexpr const char* mend_recording = "fetch or record it again";

void require_bag(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with(magic)) return;
  constexpr std::string_view any_version = "#ROSBAG V";
  const std::string_view line = bytes.substr(0, std::min(bytes.find('\n'), std::size_t{24}));
  if (bytes.starts_with(any_version) || bytes.starts_with("#ROSRECORD V"))
    throw Error("is a bag of another format, " + text::quoted(line), name,
                "convert it to format 2.0 with the rosbag tools of ROS");
  throw Error("is no ROS bag: it does not begin with '#ROSBAG V2.0'", name, "see that the file is what its name says");
}

/// What went wrong on the way, for one warning each.
struct Damage {
  std::size_t index_records = 0;
  std::size_t chunks = 0;
  std::optional<Error> first_chunk;
  std::size_t in_chunks = 0;
  std::size_t orphans = 0;
};

class BagReader {
 public:
  BagReader(std::string_view bytes, const std::string& name, RecordingVisitor& visitor)
      : bytes_(bytes), name_(name), visitor_(visitor) {}

  void read() {
    BagRecords records(bytes_, magic.size());
    read_bag_header(records);
    while (records.next()) take_record(records.record());
    require_something(records);
    tell_damage(records);
  }

 private:
  void read_bag_header(BagRecords& records) {
    if (!records.next() || records.record().op != BagOp::bag_header)
      throw Error("is cut or damaged: its first record is no bag header", name_, mend_recording);
    const BagRecord header = records.record();
    index_position_ = header.natural("index_pos").value_or(0);
    if (!header.field("encryptor").value_or("").empty())
      throw Error("is encrypted", name_, "decrypt it with the rosbag tools of ROS");
    open_indexed(header);
  }

  /// The index lists every connection once more, with those that have no message, and then every chunk.
  void open_indexed(const BagRecord& bag_header) {
    if (index_position_ < magic.size() || index_position_ > bytes_.size()) return;
    std::uint64_t connections = 0, chunks = 0;
    BagRecords records(bytes_, static_cast<std::size_t>(index_position_));
    while (records.next() && !records.record().cut) {
      if (records.record().op == BagOp::connection) {
        open(records.record());
        ++connections;
      }
      if (records.record().op == BagOp::chunk_info) ++chunks;
    }
    has_index_ = records.at_end() && bag_header.natural("conn_count").value_or(0) <= connections &&
                 bag_header.natural("chunk_count").value_or(0) <= chunks;
  }

  void open(const BagRecord& record) {
    const std::optional<std::uint64_t> number = record.natural("conn");
    const std::optional<std::string_view> topic = record.field("topic");
    const std::optional<std::string_view> type = bag_field(record.data, "type");
    if (!number || !topic || !type || channels_.contains(*number)) return;
    channels_[*number] = visitor_.open({std::string(*topic), std::string(*type), Serialization::ros1});
  }

  void take_record(const BagRecord& record) {
    switch (record.op) {
      case BagOp::chunk:
        return take_chunk(record);
      case BagOp::connection:
        return record.cut ? void() : open(record);
      case BagOp::message:
        return record.cut ? void() : take_message(record);
      case BagOp::index:
        if (record.length_is_wrong) ++damage_.index_records;
        return;
      case BagOp::bag_header:
      case BagOp::chunk_info:
        return;
    }
  }

  void take_chunk(const BagRecord& record) {
    const std::string_view packing = record.field("compression").value_or("");
    if (packing == "none") return take_records(record.data, record.cut);
    if (record.cut) return;
    const Compression compression = compression_of_ending("." + std::string(packing));
    const std::string where = name_ + ", chunk at byte " + std::to_string(record.at);
    std::string content;
    try {
      if (compression == Compression::none)
        throw Error("is packed with " + text::quoted(packing), where, "unpack it with the rosbag tools of ROS");
      content = unpack(compression, record.data, record.natural("size").value_or(0), where);
    } catch (const Error& error) {
      if (damage_.chunks++ == 0) damage_.first_chunk = error;
      return;
    }
    take_records(content, false);
  }

  /// What a chunk holds.
  void take_records(std::string_view content, bool cut) {
    BagRecords records(content, 0);
    while (records.next()) {
      const BagRecord& record = records.record();
      if (record.cut) break;
      if (record.op == BagOp::connection) open(record);
      if (record.op == BagOp::message) take_message(record);
    }
    if (!records.at_end() && !cut) ++damage_.in_chunks;
  }

  void take_message(const BagRecord& record) {
    const std::optional<std::uint64_t> connection = record.natural("conn");
    const std::optional<double> logged = record.time("time");
    const auto channel = connection && logged ? channels_.find(*connection) : channels_.end();
    if (channel == channels_.end()) {
      ++damage_.orphans;
      return;
    }
    ++messages_;
    if (channel->second >= 0) visitor_.take(channel->second, *logged, record.data);
  }

  void require_something(const BagRecords& records) const {
    if (messages_ > 0) return;
    if (damage_.first_chunk) throw Error(*damage_.first_chunk);
    if (!records.at_end() || damage_.in_chunks > 0 || damage_.orphans > 0)
      throw Error("is cut or damaged before its first message", name_, mend_recording);
  }

  void tell_damage(const BagRecords& records) {
    if (damage_.chunks > 0)
      visitor_.warn(text::count_of(damage_.chunks, "chunk") + " cannot be unpacked: left out (the one at byte " +
                    chunk_position() + " " + damage_.first_chunk->problem() + ")");
    if (damage_.in_chunks > 0)
      visitor_.warn(text::count_of(damage_.in_chunks, "chunk") + " cut or damaged: what came whole is read");
    if (damage_.orphans > 0) visitor_.warn(text::count_of(damage_.orphans, "message") + " of no known topic: left out");
    if (damage_.index_records > 0)
      visitor_.warn(text::count_of(damage_.index_records, "index record") +
                    " with a wrong length: not needed, the messages are read one after the other");
    if (!records.at_end())
      visitor_.warn("is cut or damaged at byte " + std::to_string(records.stopped_at()) + " of " +
                    std::to_string(bytes_.size()) + ": what came whole before is read");
    else if (index_position_ == 0)
      visitor_.warn("was not closed and has no index: not needed, the messages are read one after the other");
    else if (!has_index_)
      visitor_.warn("its index is cut or damaged: not needed, the messages are read one after the other");
  }

  std::string chunk_position() const {
    const std::string& where = damage_.first_chunk->where();
    return where.substr(where.rfind(' ') + 1);
  }

  std::string_view bytes_;
  const std::string& name_;
  RecordingVisitor& visitor_;
  std::uint64_t index_position_ = 0;
  bool has_index_ = false;
  std::map<std::uint64_t, int> channels_;  ///< of each connection
  std::size_t messages_ = 0;
  Damage damage_;
};

}  // namespace

void read_ros1_bag(std::string_view bytes, const std::string& name, RecordingVisitor& visitor) {
  require_bag(bytes, name);
  BagReader(bytes, name, visitor).read();
}

}  // namespace slamicp
