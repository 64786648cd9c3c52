// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/binary.hpp"

/// The records of an MCAP file, by its specification (https://mcap.dev/spec): little endian, each with an opcode and a
/// length. Nothing here believes a length that goes beyond the bytes at hand.
namespace slamicp::mcap {

inline constexpr std::string_view magic = "\x89MCAP0\r\n";

enum class Opcode : std::uint8_t {
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  data_end = 0x0F,
};

/// Takes fields off the front of some bytes. Past the end, numbers are 0 and strings empty, and `cut` is true.
class Fields {
 public:
  explicit Fields(std::string_view bytes) noexcept : rest_(bytes) {}

  template <class Number>
  Number number() noexcept {
    const std::string_view bytes = take(sizeof(Number));
    return bytes.empty() ? Number{} : static_cast<Number>(binary::read_bits(bytes, 0, sizeof(Number), false));
  }
  /// A string, of a length of 32 bits before it.
  std::string_view string() noexcept { return take(number<std::uint32_t>()); }

  std::string_view take(std::uint64_t size) noexcept {
    cut_ = cut_ || size > rest_.size();
    if (cut_) return {};
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(size));
    rest_.remove_prefix(taken.size());
    return taken;
  }
  std::string_view rest() const noexcept { return rest_; }
  bool cut() const noexcept { return cut_; }

 private:
  std::string_view rest_;
  bool cut_ = false;
};

/// Walks from record to record.
class Records {
 public:
  explicit Records(std::string_view bytes, std::size_t first = 0) noexcept : all_(bytes), rest_(bytes.substr(first)) {}

  /// Goes to the next one; false at the end, and before a record that is not there as a whole.
  bool next() noexcept {
    at_ = all_.size() - rest_.size();
    if (rest_.empty()) return false;
    Fields fields(rest_);
    opcode_ = static_cast<Opcode>(fields.number<std::uint8_t>());
    const auto size = fields.number<std::uint64_t>();
    cut_ = fields.cut() || size > fields.rest().size();
    content_ = cut_ ? fields.rest() : fields.take(size);
    rest_ = fields.rest();
    return !cut_;
  }

  Opcode opcode() const noexcept { return opcode_; }
  /// Of a cut record, what is there.
  std::string_view content() const noexcept { return content_; }
  /// Where the record begins [byte].
  std::size_t at() const noexcept { return at_; }
  /// True where the last record is not there as a whole.
  bool cut() const noexcept { return cut_; }

 private:
  std::string_view all_;
  std::string_view rest_;
  std::string_view content_;
  std::size_t at_ = 0;
  Opcode opcode_{};
  bool cut_ = false;
};

/// The fields of a chunk.
struct Chunk {
  explicit Chunk(std::string_view content) noexcept {
    Fields fields(content);
    fields.take(2 * sizeof(std::uint64_t));  // times of its messages, first and last
    size = fields.number<std::uint64_t>();
    crc = fields.number<std::uint32_t>();
    compression = fields.string();
    const auto packed_size = fields.number<std::uint64_t>();
    packed = fields.rest().substr(0, static_cast<std::size_t>(packed_size));
    whole = !fields.cut() && packed.size() == packed_size;
  }

  std::uint64_t size = 0;        ///< of its records, unpacked [bytes]
  std::uint32_t crc = 0;         ///< their checksum; 0: none
  std::string_view compression;  ///< empty: none
  std::string_view packed;       ///< its records; of a cut chunk, what is there
  bool whole = false;
};

}  // namespace slamicp::mcap
