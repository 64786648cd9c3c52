// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Numbers in binary files, byte by byte: no matter how this machine orders or aligns them.
namespace slamicp::binary {

/// What a number in a file is.
struct Kind {
  enum class Class { real, whole, natural };
  Class is = Class::real;
  std::size_t size = 4;  ///< bytes: 1, 2, 4, 8; a real has 4 or 8
};

inline std::uint64_t read_bits(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) noexcept {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t next = big_endian ? i : size - 1 - i;
    bits = (bits << 8) | static_cast<unsigned char>(bytes[at + next]);
  }
  return bits;
}

/// The number at `at`, which must lie within `bytes` as a whole.
inline double read_number(std::string_view bytes, std::size_t at, Kind kind, bool big_endian) noexcept {
  const std::uint64_t bits = read_bits(bytes, at, kind.size, big_endian);
  if (kind.is == Kind::Class::real)
    return kind.size == 8 ? std::bit_cast<double>(bits)
                          : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  if (kind.is == Kind::Class::natural) return static_cast<double>(bits);
  const std::uint64_t sign = std::uint64_t{1} << (8 * kind.size - 1);
  return static_cast<double>(static_cast<std::int64_t>((bits ^ sign) - sign));
}

inline void append_little_endian(std::string& out, double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  for (unsigned shift = 0; shift < 64; shift += 8) out += static_cast<char>((bits >> shift) & 0xFF);
}

}  // namespace slamicp::binary
