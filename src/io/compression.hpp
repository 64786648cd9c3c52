// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace slamicp {

/// How bytes are packed. A build reads those whose library was found: see SLAMICP_WITH_LZ4, _BZ2, _GZIP, _XZ and _ZSTD.
enum class Compression {
  none,
  lz4,   ///< LZ4 frames
  bz2,   ///< bzip2
  gzip,  ///< gzip, of deflate
  xz,    ///< xz, of LZMA2
  zstd,  ///< Zstandard frames
};

/// "lz4", "bz2", ...
std::string_view name_of(Compression compression) noexcept;

/// What a file's last ending says: ".lz4", ".bz2", ".gz", ".xz" or ".zst"; `none` for any other.
Compression compression_of_ending(std::string_view ending) noexcept;

/// True if the bytes begin as a stream of that kind does.
bool is_packed(Compression compression, std::string_view bytes) noexcept;

/// The content of `packed`, of all its streams one after the other. Memory grows with what really comes out.
/// Throws Error, at `where`, if `packed` is broken or cut, if more than `limit` bytes come out, and if this build lacks
/// the library.
std::string unpack(Compression compression, std::string_view packed, std::size_t limit, const std::string& where);

}  // namespace slamicp
