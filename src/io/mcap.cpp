// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include <slamicp/error.hpp>

#include "io/compression.hpp"
#include "io/crc32.hpp"
#include "io/mcap_records.hpp"
#include "io/message_type.hpp"
#include "io/recording.hpp"
#include "io/text.hpp"

namespace slamicp::mcap {
namespace {

constexpr std::uint64_t largest_chunk = std::uint64_t{1} << 30;  ///< unpacked [bytes]; recorders make about 1e6
constexpr const char* mend = "try 'mcap recover', or record it anew";

/// Reads record by record from the first on, and looks at no index: so it reads files that were never closed.
class Reader {
 public:
  Reader(const std::string& name, RecordingVisitor& visitor) : name_(name), visitor_(visitor) {}

  void read(std::string_view bytes) {
    if (!bytes.starts_with(magic))
      throw Error("is no MCAP file", name_, "give a file that begins with the bytes of MCAP, version 0");
    Records records(bytes, magic.size());
    while (records.next()) {
      if (records.opcode() == Opcode::data_end || records.opcode() == Opcode::footer) return tell();
      if (records.opcode() == Opcode::chunk)
        take_chunk(records.content(), records.at());
      else
        take(records, records.at());
    }
    take_cut(records);
    tell();
  }

 private:
  /// @param at  where the record, or the chunk that it is in, begins [byte]
  void take(const Records& record, std::size_t at) {
    Fields fields(record.content());
    if (record.opcode() == Opcode::schema)
      take_schema(fields);
    else if (record.opcode() == Opcode::channel)
      take_channel(fields);
    else if (record.opcode() == Opcode::message)
      take_message(fields, at);
    if (fields.cut()) leave_out(Error("a record is shorter than its fields", where(at), mend));
  }

  void take_schema(Fields& fields) {
    const auto id = fields.number<std::uint16_t>();
    const std::string_view type = fields.string();
    if (!fields.cut()) types_[id] = ros1_type(type);
  }

  void take_channel(Fields& fields) {
    const auto id = fields.number<std::uint16_t>();
    const auto schema = fields.number<std::uint16_t>();
    const std::string_view topic = fields.string();
    const std::string_view encoding = fields.string();
    if (fields.cut() || channels_.contains(id)) return;
    const auto type = types_.find(schema);
    const bool known = encoding == "cdr" || encoding == "ros1";
    if (!known) foreign_encodings_.emplace(encoding);
    channels_[id] = !known || type == types_.end()
                        ? -1
                        : visitor_.open({std::string(topic), type->second,
                                         encoding == "cdr" ? Serialization::cdr : Serialization::ros1});
  }

  void take_message(Fields& fields, std::size_t at) {
    const auto channel = channels_.find(fields.number<std::uint16_t>());
    fields.number<std::uint32_t>();  // sequence
    const auto logged = fields.number<std::uint64_t>();
    fields.number<std::uint64_t>();  // published
    if (fields.cut()) return;
    if (channel == channels_.end())
      return leave_out(Error("a message is of a channel that was not described before", where(at), mend));
    anything_ = true;
    if (channel->second >= 0) visitor_.take(channel->second, 1e-9 * static_cast<double>(logged), fields.rest());
  }

  void take_chunk(std::string_view content, std::size_t at) {
    std::string unpacked;
    try {
      unpacked = unpack_chunk(Chunk(content), where(at));
    } catch (const Error& error) {
      return leave_out(error);
    }
    take_all(unpacked, at);
  }

  void take_all(std::string_view bytes, std::size_t at) {
    Records records(bytes);
    while (records.next()) take(records, at);
    if (records.cut()) leave_out(Error("a chunk ends within a record", where(at), mend));
  }

  /// What follows the last whole record of a file that was not closed. A chunk that is not packed may hold whole ones.
  void take_cut(const Records& records) {
    leave_out(Error("is cut: MCAP's end of data does not come", where(records.at()), mend));
    if (!records.cut() || records.opcode() != Opcode::chunk) return;
    const Chunk chunk(records.content());
    if (!chunk.compression.empty()) return;
    Records inner(chunk.packed);
    while (inner.next()) take(inner, records.at());
  }

  static std::string unpack_chunk(const Chunk& chunk, const std::string& where) {
    if (!chunk.whole) throw Error("a chunk is shorter than its fields", where, mend);
    if (chunk.size > largest_chunk)
      throw Error("a chunk says that it unpacks to " + std::to_string(chunk.size) + " bytes", where, mend);
    std::string unpacked =
        unpack(compression_of(chunk.compression, where), chunk.packed, static_cast<std::size_t>(chunk.size), where);
    if (unpacked.size() != chunk.size)
      throw Error(
          "a chunk unpacks to " + std::to_string(unpacked.size()) + " of " + std::to_string(chunk.size) + " bytes",
          where, mend);
    if (chunk.crc != 0 && chunk.crc != crc32(unpacked)) throw Error("a chunk's checksum is wrong", where, mend);
    return unpacked;
  }

  static Compression compression_of(std::string_view name, const std::string& where) {
    if (name.empty()) return Compression::none;
    if (name == "lz4") return Compression::lz4;
    if (name == "zstd") return Compression::zstd;
    throw Error("a chunk is packed with " + text::quoted(name) + ", which slamicp does not know", where,
                "pack it with lz4 or zstd");
  }

  void leave_out(const Error& error) {
    ++left_out_;
    if (!first_) first_ = error;
  }

  /// Says what could not be had. Where that is all, it is an Error.
  void tell() const {
    if (first_ && !anything_) throw *first_;
    if (first_)
      visitor_.warn(first_->where() + ": " + first_->problem() + ": left out" +
                    (left_out_ == 1 ? "" : ", as are " + text::count_of(left_out_ - 1, "other piece")));
    for (const std::string& encoding : foreign_encodings_)
      visitor_.warn("channels in " + text::quoted(encoding) + " are left out: slamicp reads cdr and ros1");
  }

  std::string where(std::size_t at) const { return name_ + ", byte " + std::to_string(at); }

  const std::string& name_;
  RecordingVisitor& visitor_;
  std::map<std::uint16_t, std::string> types_;  ///< by schema
  std::map<std::uint16_t, int> channels_;       ///< as the visitor numbers them
  std::set<std::string> foreign_encodings_;
  bool anything_ = false;  ///< has come whole
  std::size_t left_out_ = 0;
  std::optional<Error> first_;
};

}  // namespace
}  // namespace slamicp::mcap

namespace slamicp {

void read_mcap(std::string_view bytes, const std::string& name, RecordingVisitor& visitor) {
  mcap::Reader(name, visitor).read(bytes);
}

}  // namespace slamicp
