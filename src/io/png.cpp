// SPDX-License-Identifier: Apache-2.0
#include <slamicp/error.hpp>

#include "io/occupancy_image.hpp"

#ifdef SLAMICP_WITH_LIBPNG

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <png.h>

namespace slamicp {
namespace {

/// What libpng's callbacks see.
struct Source {
  std::string_view bytes;
  std::size_t next = 0;
  char problem[128] = "";
};

void read_bytes(png_structp png, png_bytep to, std::size_t size) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (size > source->bytes.size() - source->next) png_error(png, "the image is cut");
  std::memcpy(to, source->bytes.data() + source->next, size);
  source->next += size;
}

[[noreturn]] void take_error(png_structp png, png_const_charp problem) {
  auto* source = static_cast<Source*>(png_get_error_ptr(png));
  std::snprintf(source->problem, sizeof source->problem, "%s", problem);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

class PngReader {
 public:
  PngReader(std::string_view bytes, const std::string& name) : name_(name) {
    source_.bytes = bytes;
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, take_error, ignore_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw Error("libpng does not start", name_, "install the libpng that slamicp was built with");
    }
    png_set_read_fn(png_, &source_, read_bytes);
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
    png_set_crc_action(png_, PNG_CRC_QUIET_USE, PNG_CRC_QUIET_USE);  // else a fuzzer gets past no check sum
#endif
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  OccupancyImage read() {
    if (!steps([this] { read_header(); })) fail();
    check_image_size(width_, height_, name_);
    check_promise();
    pixels_.resize(row_bytes_ * height_);
    rows_.resize(height_);
    for (std::size_t row = 0; row < height_; ++row) rows_[row] = pixels_.data() + row * row_bytes_;
    if (!steps([this] {
          png_read_image(png_, rows_.data());
          png_read_end(png_, nullptr);
        }))
      fail();
    return image();
  }

 private:
  /// libpng leaves by longjmp: what happens between here and there must not need a destructor.
  template <class Steps>
  bool steps(Steps steps) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp)
    steps();
    return true;
  }

  [[noreturn]] void fail() const {
    throw Error("is no whole PNG image: " + std::string(source_.problem), name_, "copy or save it again");
  }

  void read_header() noexcept {
    png_read_info(png_, info_);
    is_palette_ = png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE;
    width_ = png_get_image_width(png_, info_);
    height_ = png_get_image_height(png_, info_);
    packed_row_bytes_ = png_get_rowbytes(png_, info_);
    png_set_expand(png_);  // palettes to colours, 1, 2, 4 bits to 8, a transparent colour to alpha
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    channels_ = png_get_channels(png_, info_);
    bits_ = png_get_bit_depth(png_, info_);
    row_bytes_ = png_get_rowbytes(png_, info_);
    has_alpha_ = (png_get_color_type(png_, info_) & PNG_COLOR_MASK_ALPHA) != 0;
  }

  /// Before there is memory for it: deflate makes at most 1032 bytes of one.
  void check_promise() const {
    if (packed_row_bytes_ * std::uint64_t{height_} > source_.bytes.size() * std::uint64_t{1032})
      throw Error("is no whole PNG image: the header promises more than the file can hold", name_,
                  "copy or save it again");
  }

  std::uint32_t sample(const png_byte* row, std::size_t k) const {
    return bits_ == 16 ? static_cast<std::uint32_t>(row[2 * k] << 8 | row[2 * k + 1]) : row[k];
  }

  OccupancyImage image() const {
    OccupancyImage image;
    image.width = static_cast<int>(width_);
    image.height = static_cast<int>(height_);
    const std::uint32_t most = bits_ == 16 ? 65535 : 255;
    const std::size_t colours = channels_ - (has_alpha_ ? 1U : 0U);
    image.white = most * static_cast<std::uint32_t>(colours);
    image.opaque = has_alpha_ ? most : 0;
    image.format = std::string("PNG ") +
                   (is_palette_    ? "palette"
                    : colours == 3 ? "RGB"
                                   : "grey") +
                   (has_alpha_ ? " and alpha, " : ", ") + std::to_string(bits_) + " bit";
    image.levels.reserve(height_ * width_);
    if (has_alpha_) image.alphas.reserve(height_ * width_);
    for (const png_byte* row : rows_)
      for (std::size_t k = 0; k < width_ * channels_; k += channels_) {
        std::uint32_t sum = 0;
        for (std::size_t colour = 0; colour < colours; ++colour) sum += sample(row, k + colour);
        image.levels.push_back(sum);
        if (has_alpha_) image.alphas.push_back(static_cast<std::uint16_t>(sample(row, k + colours)));
      }
    return image;
  }

  const std::string& name_;
  Source source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::size_t width_ = 0, height_ = 0, channels_ = 0, packed_row_bytes_ = 0, row_bytes_ = 0;
  unsigned bits_ = 8;
  bool is_palette_ = false, has_alpha_ = false;
  std::vector<png_byte> pixels_;
  std::vector<png_bytep> rows_;
};

}  // namespace

OccupancyImage parse_png(std::string_view bytes, const std::string& name) { return PngReader(bytes, name).read(); }

}  // namespace slamicp

#else

namespace slamicp {

OccupancyImage parse_png(std::string_view, const std::string& name) {
  throw Error("this build reads no PNG", name, "build with libpng (Debian: libpng-dev), or convert it to PGM");
}

}  // namespace slamicp

#endif
