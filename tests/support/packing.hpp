// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "io/compression.hpp"

#ifdef SLAMICP_WITH_LZ4
#include <lz4frame.h>
#endif
#ifdef SLAMICP_WITH_BZ2
#include <bzlib.h>
#endif
#ifdef SLAMICP_WITH_GZIP
#include <zlib.h>
#endif
#ifdef SLAMICP_WITH_XZ
#include <lzma.h>
#endif
#ifdef SLAMICP_WITH_ZSTD
#include <zstd.h>
#endif

namespace slamicp::test {

/// True where this build has the library.
inline bool can_pack(Compression compression) {
  switch (compression) {
#ifdef SLAMICP_WITH_LZ4
    case Compression::lz4:
#endif
#ifdef SLAMICP_WITH_BZ2
    case Compression::bz2:
#endif
#ifdef SLAMICP_WITH_GZIP
    case Compression::gzip:
#endif
#ifdef SLAMICP_WITH_XZ
    case Compression::xz:
#endif
#ifdef SLAMICP_WITH_ZSTD
    case Compression::zstd:
#endif
    case Compression::none:
      return true;
    default:
      return false;
  }
}

/// Packs by the library itself.
inline std::string pack(Compression compression, std::string_view content) {
  std::string out(content.size() + content.size() / 8 + 1024, '\0');
  [[maybe_unused]] auto* const bytes = reinterpret_cast<unsigned char*>(out.data());
  [[maybe_unused]] const auto* const from = reinterpret_cast<const unsigned char*>(content.data());
  switch (compression) {
    case Compression::none:
      return std::string(content);
#ifdef SLAMICP_WITH_LZ4
    case Compression::lz4: {
      LZ4F_preferences_t preferences{};
      preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
      out.resize(LZ4F_compressFrameBound(content.size(), &preferences));
      out.resize(LZ4F_compressFrame(out.data(), out.size(), content.data(), content.size(), &preferences));
      return out;
    }
#endif
#ifdef SLAMICP_WITH_BZ2
    case Compression::bz2: {
      auto size = static_cast<unsigned>(out.size());
      if (BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(content.data()),
                                   static_cast<unsigned>(content.size()), 9, 0, 0) != BZ_OK)
        throw std::logic_error("bz2");
      out.resize(size);
      return out;
    }
#endif
#ifdef SLAMICP_WITH_GZIP
    case Compression::gzip: {
      z_stream stream{};
      if (deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::logic_error("gzip");
      stream.next_in = const_cast<unsigned char*>(from);
      stream.avail_in = static_cast<unsigned>(content.size());
      stream.next_out = bytes;
      stream.avail_out = static_cast<unsigned>(out.size());
      if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::logic_error("gzip");
      out.resize(stream.total_out);
      deflateEnd(&stream);
      return out;
    }
#endif
#ifdef SLAMICP_WITH_XZ
    case Compression::xz: {
      std::size_t size = 0;
      if (lzma_easy_buffer_encode(1, LZMA_CHECK_CRC64, nullptr, from, content.size(), bytes, &size, out.size()) !=
          LZMA_OK)
        throw std::logic_error("xz");
      out.resize(size);
      return out;
    }
#endif
#ifdef SLAMICP_WITH_ZSTD
    case Compression::zstd:
      out.resize(ZSTD_compressBound(content.size()));
      out.resize(ZSTD_compress(out.data(), out.size(), content.data(), content.size(), 1));
      return out;
#endif
    default:
      throw std::logic_error("this build cannot pack it");
  }
}

}  // namespace slamicp::test
