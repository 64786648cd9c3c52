// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <slamicp/error.hpp>

#include "io/occupancy_image.hpp"
#include "io/text.hpp"

// PGM, the portable greymap of Netpbm: "P5", width, height, the largest level, then the levels, in bytes (P5) or in
// words (P2). A comment goes from '#' to the end of its line.
namespace slamicp {
namespace {

class PgmReader {
 public:
  PgmReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  OccupancyImage read() {
    const bool is_plain = read_magic();
    const std::uint64_t width = header_number("the width", std::numeric_limits<std::int32_t>::max());
    const std::uint64_t height = header_number("the height", std::numeric_limits<std::int32_t>::max());
    check_image_size(width, height, name_);
    image_.width = static_cast<int>(width);
    image_.height = static_cast<int>(height);
    image_.white = header_number("the largest level", 65535);
    if (image_.white == 0) fail("the largest level is 0", "write 255");
    image_.format = is_plain ? "PGM P2" : "PGM P5";
    if (is_plain)
      read_words();
    else
      read_bytes();
    return std::move(image_);
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& mend = "give a whole PGM image, P5 or P2") const {
    throw Error(what, name_, mend);
  }
  [[noreturn]] void fail_cut(std::size_t found) const {
    fail("the image is cut: " + std::to_string(found) + " of " + std::to_string(pixels()) + " pixels",
         "copy or save it again");
  }

  std::size_t pixels() const {
    return static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height);
  }

  /// @returns whether it is P2
  bool read_magic() {
    const std::string_view magic = bytes_.substr(0, 2);
    if (magic != "P2" && magic != "P5")
      fail(bytes_.empty() ? "the file is empty" : "is no PGM image: it starts with " + text::quoted(magic),
           "convert it to PGM, P5 or P2, or to PNG");
    next_ = 2;
    return magic == "P2";
  }

  static bool is_space(char c) { return text::is_blank(c) || c == '\n'; }

  /// The next word that no comment hides; empty at the end.
  std::string_view word() {
    while (next_ < bytes_.size() && (is_space(bytes_[next_]) || bytes_[next_] == '#')) {
      if (bytes_[next_] == '#')
        while (next_ < bytes_.size() && bytes_[next_] != '\n') ++next_;
      else
        ++next_;
    }
    const std::size_t start = next_;
    while (next_ < bytes_.size() && !is_space(bytes_[next_]) && bytes_[next_] != '#') ++next_;
    return bytes_.substr(start, next_ - start);
  }

  std::uint32_t header_number(const std::string& what, std::uint32_t most) {
    const std::string_view token = word();
    if (token.empty()) fail("the header is cut before " + what);
    const std::optional<std::uint64_t> number = text::to_number<std::uint64_t>(token);
    if (!number) fail(what + " is not a whole number: " + text::quoted(token));
    if (*number > most) fail(what + " is " + std::to_string(*number) + ", at most " + std::to_string(most) + " goes");
    return static_cast<std::uint32_t>(*number);
  }

  void take(std::uint32_t level) {
    if (level > image_.white)
      fail("pixel " + std::to_string(image_.levels.size()) + " is " + std::to_string(level) +
           ", the header says at most " + std::to_string(image_.white));
    image_.levels.push_back(level);
  }

  void read_words() {
    // Two bytes a pixel at least: what the header promises may be more than there is.
    if (pixels() > (bytes_.size() - next_) / 2 + 1) fail_cut((bytes_.size() - next_) / 2);
    image_.levels.reserve(pixels());
    for (std::string_view token = word(); image_.levels.size() < pixels(); token = word()) {
      if (token.empty()) fail_cut(image_.levels.size());
      const std::optional<std::uint32_t> level = text::to_number<std::uint32_t>(token);
      if (!level)
        fail("pixel " + std::to_string(image_.levels.size()) + " is not a whole number: " + text::quoted(token));
      take(*level);
    }
  }

  void read_bytes() {
    if (next_ < bytes_.size() && is_space(bytes_[next_])) ++next_;  // just one: the next byte may look like a blank
    const std::size_t size = image_.white > 255 ? 2 : 1;
    const std::size_t held = (bytes_.size() - next_) / size;
    if (held < pixels()) fail_cut(held);
    image_.levels.reserve(pixels());
    for (std::size_t k = 0; k < pixels(); ++k, next_ += size) {
      const std::uint32_t high = static_cast<unsigned char>(bytes_[next_]);
      take(size == 1 ? high : high << 8 | static_cast<unsigned char>(bytes_[next_ + 1]));
    }
    if (next_ < bytes_.size())
      image_.warnings.push_back(text::count_of(bytes_.size() - next_, "byte") + " after the image: ignored");
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t next_ = 0;
  OccupancyImage image_;
};

char grey_of(CellState state) {
  switch (state) {
    case CellState::occupied:
      return static_cast<char>(0);
    case CellState::free:
      return static_cast<char>(254);
    case CellState::unknown:
      break;
  }
  return static_cast<char>(205);
}

}  // namespace

void check_image_size(std::uint64_t width, std::uint64_t height, const std::string& where) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (width == 0 || height == 0) throw Error("the image has no pixel: " + size, where, "save the map again");
  if (width > most_grid_cells || height > most_grid_cells || width * height > most_grid_cells)
    throw Error("the image is too large: " + size + " pixels", where,
                "at most " + std::to_string(most_grid_cells) + " go: cut it, or make it coarser");
}

OccupancyImage parse_pgm(std::string_view bytes, const std::string& name) { return PgmReader(bytes, name).read(); }

std::string pgm_bytes(const OccupancyGrid& grid) {
  std::string out = "P5\n" + std::to_string(grid.width) + ' ' + std::to_string(grid.height) + "\n255\n";
  out.reserve(out.size() + grid.cells.size());
  for (int row = grid.height - 1; row >= 0; --row)
    for (int column = 0; column < grid.width; ++column) out += grey_of(grid.at({column, row}));
  return out;
}

}  // namespace slamicp
