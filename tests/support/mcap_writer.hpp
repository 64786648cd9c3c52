// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/crc32.hpp"
#include "support/packing.hpp"

/// The records of MCAP, for files as a test wants them: whole, cut, broken.
namespace slamicp::test::mcap {

inline const std::string magic = "\x89MCAP0\r\n";

/// A number in so many bytes, little endian.
inline std::string number(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
  return bytes;
}
inline std::string text(std::string_view text) { return number(text.size(), 4).append(text); }

inline std::string record(int opcode, std::string_view content) {
  return number(static_cast<std::uint64_t>(opcode), 1) + number(content.size(), 8).append(content);
}
inline std::string header() { return record(0x01, text("ros2") + text("slamicp tests")); }
inline std::string schema(int id, std::string_view name) {
  return record(0x03, number(static_cast<std::uint64_t>(id), 2) + text(name) + text("ros2msg") + text("float32 x"));
}
inline std::string channel(int id, int schema, std::string_view topic, std::string_view encoding = "cdr") {
  return record(0x04, number(static_cast<std::uint64_t>(id), 2) + number(static_cast<std::uint64_t>(schema), 2) +
                          text(topic) + text(encoding) + text(""));
}
inline std::string message(int channel, std::uint64_t nanoseconds, std::string_view body) {
  return record(0x05, number(static_cast<std::uint64_t>(channel), 2) + number(0, 4) + number(nanoseconds, 8) +
                          number(nanoseconds, 8).append(body));
}
inline std::string end() { return record(0x0F, number(0, 4)) + record(0x02, number(0, 8) + number(0, 8) + number(0, 4)) + magic; }

/// A chunk of records. `size` and `crc` are what it says of them.
inline std::string chunk(std::string_view compression, const std::string& records, std::uint64_t size,
                         std::uint32_t crc) {
  const Compression kind = compression == "lz4"    ? Compression::lz4
                           : compression == "zstd" ? Compression::zstd
                                                   : Compression::none;
  const std::string bytes = pack(kind, records);
  return record(0x06, number(0, 8) + number(0, 8) + number(size, 8) + number(crc, 4) + text(compression) +
                          number(bytes.size(), 8) + bytes);
}
inline std::string chunk(std::string_view compression, const std::string& records) {
  return chunk(compression, records, records.size(), crc32(records));
}

}  // namespace slamicp::test::mcap
