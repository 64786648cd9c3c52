// SPDX-License-Identifier: Apache-2.0
#include "io/compression.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include <slamicp/error.hpp>

#include "io/decoders.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

/// Everything that is told apart by the kind of packing.
struct Kind {
  Compression compression;
  std::string_view name;
  std::string_view ending;
  std::string_view magic;  ///< what each of its streams begins with
  std::string_view package;
  std::unique_ptr<Decoder> (*decoder)();
};

using namespace std::string_view_literals;
constexpr std::array<Kind, 5> kinds{{
    {Compression::lz4, "lz4", ".lz4", "\x04\x22\x4D\x18"sv, "liblz4-dev", lz4_decoder},
    {Compression::bz2, "bz2", ".bz2", "BZh"sv, "libbz2-dev", bz2_decoder},
    {Compression::gzip, "gzip", ".gz", "\x1F\x8B"sv, "zlib1g-dev", gzip_decoder},
    {Compression::xz, "xz", ".xz", "\xFD\x37zXZ\0"sv, "liblzma-dev", xz_decoder},
    {Compression::zstd, "zstd", ".zst", "\x28\xB5\x2F\xFD"sv, "libzstd-dev", zstd_decoder},
}};

const Kind* kind_of(Compression compression) noexcept {
  const auto* const found =
      std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) { return kind.compression == compression; });
  return found == kinds.end() ? nullptr : found;
}

/// Where unpacked bytes go: room for one more than the limit, so that what is too much is seen.
class Content {
 public:
  explicit Content(std::size_t limit) : limit_(limit) {}

  std::span<char> room() {
    constexpr std::size_t least = 1 << 16;
    if (filled_ == bytes_.size()) bytes_.resize(std::max(least, std::min(2 * filled_, limit_ + 1)));
    return {bytes_.data() + filled_, bytes_.size() - filled_};
  }
  bool add(std::size_t count) {
    filled_ += count;
    return filled_ <= limit_;
  }
  std::string take() {
    bytes_.resize(filled_);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::size_t filled_ = 0;
  std::size_t limit_;
};

std::string unpack_with(const Kind& kind, std::string_view packed, std::size_t limit, const std::string& where) {
  const std::string name(kind.name);
  const char* const mend = "fetch or record the file again";
  Content content(limit);
  std::unique_ptr<Decoder> decoder = kind.decoder();
  if (!decoder)
    throw Error("is packed with " + name + ", which this build cannot read", where,
                "unpack it first, or build slamicp where " + std::string(kind.package) + " is installed");
  while (true) {
    const Decoder::Step step = decoder->step(packed, content.room());
    if (step.state == Decoder::State::broken) throw Error("is no " + name + ", or broken", where, mend);
    packed.remove_prefix(step.taken);
    if (!content.add(step.given))
      throw Error("unpacks to more than " + text::count_of(limit, "byte"), where,
                  "see that the file is what it should be");
    if (step.state == Decoder::State::ended) {
      if (!packed.starts_with(kind.magic)) return content.take();
      decoder = kind.decoder();
    } else if (step.taken == 0 && step.given == 0) {
      throw Error("is cut: its " + name + " ends half way", where, mend);
    }
  }
}

}  // namespace

std::string_view name_of(Compression compression) noexcept {
  const Kind* const kind = kind_of(compression);
  return kind != nullptr ? kind->name : "none";
}

Compression compression_of_ending(std::string_view ending) noexcept {
  for (const Kind& kind : kinds)
    if (kind.ending == ending) return kind.compression;
  return Compression::none;
}

bool is_packed(Compression compression, std::string_view bytes) noexcept {
  const Kind* const kind = kind_of(compression);
  return kind != nullptr && bytes.starts_with(kind->magic);
}

std::string unpack(Compression compression, std::string_view packed, std::size_t limit, const std::string& where) {
  const Kind* const kind = kind_of(compression);
  if (kind != nullptr) return unpack_with(*kind, packed, limit, where);
  if (packed.size() > limit)
    throw Error("holds more than " + text::count_of(limit, "byte"), where, "see that the file is what it should be");
  return std::string(packed);
}

}  // namespace slamicp
