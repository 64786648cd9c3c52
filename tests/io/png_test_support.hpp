// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace slamicp::io_test {

inline std::string big_endian(std::uint32_t number) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 0xFF);
  return out;
}

/// A piece of a PNG with its check sum (ISO 3309).
inline std::string png_chunk(const std::string& type, const std::string& data) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char c : type + data) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(~sum);
}

/// Bytes as a zlib stream that packs nothing; up to 65535 of them.
inline std::string stored(std::string_view data) {
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint32_t>(data.size());
  std::string out = "\x78\x01\x01";
  for (const std::uint32_t half : {size, ~size}) {
    out += static_cast<char>(half & 0xFF);
    out += static_cast<char>(half >> 8 & 0xFF);
  }
  return out.append(data) + big_endian(b << 16 | a);
}

enum PngColour { png_grey = 0, png_rgb = 2, png_palette = 3, png_grey_alpha = 4, png_rgba = 6 };

/// A PNG of these rows of packed samples.
/// @param extra  chunks that go before the image: a palette
inline std::string png(int width, int height, int bits, PngColour colour, const std::string& samples,
                       const std::string& extra = {}) {
  const std::size_t row_bytes = std::max<std::size_t>(samples.size() / static_cast<std::size_t>(height), 1);
  std::string rows;
  for (std::size_t at = 0; at < samples.size(); at += row_bytes) rows += '\0' + samples.substr(at, row_bytes);
  const std::string header = big_endian(static_cast<std::uint32_t>(width)) +
                             big_endian(static_cast<std::uint32_t>(height)) + static_cast<char>(bits) +
                             static_cast<char>(colour) + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + extra + png_chunk("IDAT", stored(rows)) +
         png_chunk("IEND", "");
}

}  // namespace slamicp::io_test
