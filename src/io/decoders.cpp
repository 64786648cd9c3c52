// SPDX-License-Identifier: Apache-2.0
#include "io/decoders.hpp"

#include <algorithm>
#include <new>

#ifdef SLAMICP_WITH_LZ4
#include <lz4frame.h>
#endif
#ifdef SLAMICP_WITH_BZ2
#include <bzlib.h>
#endif
#ifdef SLAMICP_WITH_GZIP
#define ZLIB_CONST
#include <zlib.h>
#endif
#ifdef SLAMICP_WITH_XZ
#include <lzma.h>
#endif
#ifdef SLAMICP_WITH_ZSTD
#include <zstd.h>
#endif

namespace slamicp {
namespace {

using State = Decoder::State;

/// As much as those libraries count in 32 bits.
[[maybe_unused]] unsigned piece_of(std::size_t size) noexcept {
  return static_cast<unsigned>(std::min<std::size_t>(size, std::size_t{1} << 30));
}

#ifdef SLAMICP_WITH_LZ4
class Lz4Decoder final : public Decoder {
 public:
  Lz4Decoder() {
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context_, LZ4F_VERSION)) != 0) throw std::bad_alloc();
  }
  ~Lz4Decoder() override { LZ4F_freeDecompressionContext(context_); }

  Step step(std::string_view packed, std::span<char> room) override {
    std::size_t taken = packed.size();
    std::size_t given = room.size();
    const std::size_t hint = LZ4F_decompress(context_, room.data(), &given, packed.data(), &taken, nullptr);
    if (LZ4F_isError(hint) != 0) return {0, 0, State::broken};
    // An empty input gives the hint that a new frame gives, or 0 before any frame.
    return {taken, given, hint == 0 && taken > 0 ? State::ended : State::going};
  }

 private:
  LZ4F_dctx* context_ = nullptr;
};
#endif

#ifdef SLAMICP_WITH_BZ2
class Bz2Decoder final : public Decoder {
 public:
  Bz2Decoder() {
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  ~Bz2Decoder() override { BZ2_bzDecompressEnd(&stream_); }

  Step step(std::string_view packed, std::span<char> room) override {
    stream_.next_in = const_cast<char*>(packed.data());  // it only reads there
    stream_.avail_in = piece_of(packed.size());
    stream_.next_out = room.data();
    stream_.avail_out = piece_of(room.size());
    const int result = BZ2_bzDecompress(&stream_);
    const auto taken = static_cast<std::size_t>(stream_.next_in - packed.data());
    const auto given = static_cast<std::size_t>(stream_.next_out - room.data());
    if (result == BZ_MEM_ERROR) throw std::bad_alloc();
    if (result != BZ_OK && result != BZ_STREAM_END) return {0, 0, State::broken};
    return {taken, given, result == BZ_STREAM_END ? State::ended : State::going};
  }

 private:
  bz_stream stream_{};
};
#endif

#ifdef SLAMICP_WITH_GZIP
class GzipDecoder final : public Decoder {
 public:
  GzipDecoder() {
    constexpr int largest_window = 15;
    constexpr int gzip_only = 16;
    if (inflateInit2(&stream_, largest_window + gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~GzipDecoder() override { inflateEnd(&stream_); }

  Step step(std::string_view packed, std::span<char> room) override {
    stream_.next_in = reinterpret_cast<const Bytef*>(packed.data());
    stream_.avail_in = piece_of(packed.size());
    stream_.next_out = reinterpret_cast<Bytef*>(room.data());
    stream_.avail_out = piece_of(room.size());
    const int result = inflate(&stream_, Z_NO_FLUSH);
    const auto taken = static_cast<std::size_t>(reinterpret_cast<const char*>(stream_.next_in) - packed.data());
    const auto given = static_cast<std::size_t>(reinterpret_cast<char*>(stream_.next_out) - room.data());
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    if (result == Z_BUF_ERROR) return {0, 0, State::going};
    if (result != Z_OK && result != Z_STREAM_END) return {0, 0, State::broken};
    return {taken, given, result == Z_STREAM_END ? State::ended : State::going};
  }

 private:
  z_stream stream_{};
};
#endif

#ifdef SLAMICP_WITH_XZ
class XzDecoder final : public Decoder {
 public:
  XzDecoder() {
    constexpr std::uint64_t most_memory = 256U << 20U;  // xz -9 needs 65 MB
    if (lzma_stream_decoder(&stream_, most_memory, 0) != LZMA_OK) throw std::bad_alloc();
  }
  ~XzDecoder() override { lzma_end(&stream_); }

  Step step(std::string_view packed, std::span<char> room) override {
    stream_.next_in = reinterpret_cast<const std::uint8_t*>(packed.data());
    stream_.avail_in = packed.size();
    stream_.next_out = reinterpret_cast<std::uint8_t*>(room.data());
    stream_.avail_out = room.size();
    const lzma_ret result = lzma_code(&stream_, LZMA_RUN);
    const std::size_t taken = packed.size() - stream_.avail_in;
    const std::size_t given = room.size() - stream_.avail_out;
    if (result == LZMA_MEM_ERROR) throw std::bad_alloc();
    if (result == LZMA_BUF_ERROR) return {0, 0, State::going};
    if (result != LZMA_OK && result != LZMA_STREAM_END) return {0, 0, State::broken};
    return {taken, given, result == LZMA_STREAM_END ? State::ended : State::going};
  }

 private:
  lzma_stream stream_ = LZMA_STREAM_INIT;
};
#endif

#ifdef SLAMICP_WITH_ZSTD
class ZstdDecoder final : public Decoder {
 public:
  ZstdDecoder() : stream_(ZSTD_createDStream()) {
    if (stream_ == nullptr) throw std::bad_alloc();
  }
  ~ZstdDecoder() override { ZSTD_freeDStream(stream_); }

  Step step(std::string_view packed, std::span<char> room) override {
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    ZSTD_outBuffer out{room.data(), room.size(), 0};
    const std::size_t hint = ZSTD_decompressStream(stream_, &out, &in);
    if (ZSTD_isError(hint) != 0) return {0, 0, State::broken};
    return {in.pos, out.pos, hint == 0 ? State::ended : State::going};
  }

 private:
  ZSTD_DStream* stream_;
};
#endif

}  // namespace

std::unique_ptr<Decoder> lz4_decoder() {
#ifdef SLAMICP_WITH_LZ4
  return std::make_unique<Lz4Decoder>();
#else
  return nullptr;
#endif
}

std::unique_ptr<Decoder> bz2_decoder() {
#ifdef SLAMICP_WITH_BZ2
  return std::make_unique<Bz2Decoder>();
#else
  return nullptr;
#endif
}

std::unique_ptr<Decoder> gzip_decoder() {
#ifdef SLAMICP_WITH_GZIP
  return std::make_unique<GzipDecoder>();
#else
  return nullptr;
#endif
}

std::unique_ptr<Decoder> xz_decoder() {
#ifdef SLAMICP_WITH_XZ
  return std::make_unique<XzDecoder>();
#else
  return nullptr;
#endif
}

std::unique_ptr<Decoder> zstd_decoder() {
#ifdef SLAMICP_WITH_ZSTD
  return std::make_unique<ZstdDecoder>();
#else
  return nullptr;
#endif
}

}  // namespace slamicp
