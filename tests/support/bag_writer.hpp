// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/packing.hpp"
#include "support/ros1_writer.hpp"

namespace slamicp::test {

/// Writes a bag of format 2.0, as rosbag record does: chunks with their indexes, then all connections and chunk infos.
class BagWriter {
 public:
  explicit BagWriter(Compression compression = Compression::none) : compression_(compression) {}

  /// @return the connection's number
  std::uint32_t connection(const std::string& topic, const std::string& type) {
    connections_.emplace_back(topic, type);
    return static_cast<std::uint32_t>(connections_.size()) - 1;
  }

  void message(std::uint32_t connection, double logged, std::string_view body) {
    if (written_.insert({connection, true}).second) chunk_ += connection_record(connection);
    Ros1Writer time;
    time.stamp(logged);
    index_[connection].emplace_back(time.message(), static_cast<std::uint32_t>(chunk_.size()));
    chunk_ += record({{"op", "\x02"}, {"conn", number(connection)}, {"time", time.message()}}, body);
  }

  /// Ends the chunk; the next message begins another.
  void end_chunk() {
    if (chunk_.empty()) return;
    const std::string compression(name_of(compression_));
    const auto size = static_cast<std::uint32_t>(chunk_.size());
    records_ +=
        record({{"op", "\x05"}, {"compression", compression}, {"size", number(size)}}, pack(compression_, chunk_));
    for (const auto& [connection, entries] : index_) records_ += index_record(connection, entries);
    ++chunks_;
    chunk_.clear();
    index_.clear();
  }

  /// The whole bag; without an index, as a recorder leaves it that was killed.
  std::string bag(bool with_index = true) {
    end_chunk();
    const std::size_t index_position = magic_.size() + header_size + records_.size();
    Ros1Writer position;
    position.u32(with_index ? static_cast<std::uint32_t>(index_position) : 0).u32(0);
    const auto connections = static_cast<std::uint32_t>(connections_.size());
    const std::vector<std::pair<std::string, std::string>> fields{{"op", "\x03"},
                                                                  {"index_pos", position.message()},
                                                                  {"conn_count", number(connections)},
                                                                  {"chunk_count", number(chunks_)}};
    const std::size_t padding = header_size - record(fields, "").size();
    std::string out = magic_ + record(fields, std::string(padding, ' ')) + records_;
    if (!with_index) return out;
    for (std::uint32_t connection = 0; connection < connections; ++connection) out += connection_record(connection);
    for (std::uint32_t chunk = 0; chunk < chunks_; ++chunk) out += record({{"op", "\x06"}, {"ver", number(1)}}, "");
    return out;
  }

  /// Entries of index records get so many bytes each in their length; 12 is right.
  std::uint32_t bytes_told_per_entry = 12;
  /// Of the bag's header record, with its padding [bytes].
  std::size_t header_size = 4096;

 private:
  using Fields = std::vector<std::pair<std::string, std::string>>;
  using Entries = std::vector<std::pair<std::string, std::uint32_t>>;  ///< time, offset in the chunk

  static std::string number(std::uint32_t value) { return Ros1Writer().u32(value).message(); }

  static std::string block(const Fields& fields) {
    Ros1Writer out;
    for (const auto& [name, value] : fields) out.string(name + "=" + value);
    return out.message();
  }
  static std::string record(const Fields& fields, std::string_view data) {
    return Ros1Writer().string(block(fields)).string(data).message();
  }
  std::string connection_record(std::uint32_t connection) const {
    const auto& [topic, type] = connections_[connection];
    const std::string data = block({{"topic", topic}, {"type", type}, {"md5sum", "*"}, {"message_definition", ""}});
    return record({{"op", "\x07"}, {"conn", number(connection)}, {"topic", topic}}, data);
  }
  std::string index_record(std::uint32_t connection, const Entries& entries) const {
    const auto count = static_cast<std::uint32_t>(entries.size());
    std::string out =
        Ros1Writer()
            .string(block({{"op", "\x04"}, {"ver", number(1)}, {"conn", number(connection)}, {"count", number(count)}}))
            .u32(count * bytes_told_per_entry)
            .message();
    for (const auto& [time, offset] : entries) out += time + number(offset);
    return out;
  }

  std::string magic_ = "#ROSBAG V2.0\n";
  Compression compression_;
  std::vector<std::pair<std::string, std::string>> connections_;
  std::map<std::uint32_t, bool> written_;
  std::string chunk_, records_;
  std::map<std::uint32_t, Entries> index_;
  std::uint32_t chunks_ = 0;
};

}  // namespace slamicp::test
