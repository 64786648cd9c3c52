// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

namespace slamicp {

/// Unpacks one stream, piece by piece.
class Decoder {
 public:
  enum class State {
    going,   ///< gives more if it gets more bytes, or more room
    ended,   ///< the stream is whole
    broken,  ///< the bytes are of no such stream, or it asks for more memory than any file should
  };
  struct Step {
    std::size_t taken = 0;  ///< bytes of `packed` that need not be given again
    std::size_t given = 0;  ///< bytes written to `room`
    State state = State::going;
  };

  Decoder() = default;
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  virtual ~Decoder() = default;
  /// @param packed  all that is left; a step may take a part of it
  virtual Step step(std::string_view packed, std::span<char> room) = 0;
};

/// Each is empty where the build lacks the library.
std::unique_ptr<Decoder> lz4_decoder();
std::unique_ptr<Decoder> bz2_decoder();
std::unique_ptr<Decoder> gzip_decoder();
std::unique_ptr<Decoder> xz_decoder();
std::unique_ptr<Decoder> zstd_decoder();

}  // namespace slamicp
