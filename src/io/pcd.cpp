// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <slamicp/error.hpp>

#include "io/binary.hpp"
#include "io/cloud_formats.hpp"
#include "io/text.hpp"

// PCD, the file format of the Point Cloud Library: a header of lines "KEY value...", then the points.
namespace slamicp {
namespace {

struct PcdField {
  std::string name;
  std::size_t size = 4;   ///< bytes of one value
  char type = 'F';        ///< F real, I whole, U natural
  std::size_t count = 1;  ///< values
};

struct Header {
  std::vector<PcdField> fields;
  std::uint64_t width = 0;
  std::uint64_t height = 1;
  std::optional<std::uint64_t> points;
  std::string data;  ///< "ascii", "binary"
};

class PcdReader {
 public:
  PcdReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name), lines_(bytes, name) {}

  RawCloud read() {
    read_header();
    find_coordinates();
    RawCloud cloud;
    cloud.has_z = has_z_;
    cloud.format = "PCD " + header_.data;
    if (header_.data == "ascii")
      read_ascii(cloud);
    else
      read_binary(cloud);
    return cloud;
  }

 private:
  [[noreturn]] void fail(const std::string& what,
                         const std::string& mend = "see pointclouds.org for the PCD format") const {
    throw Error(what, lines_.where(), mend);
  }

  std::uint64_t natural(std::string_view token, std::string_view what, std::uint64_t most) const {
    const std::optional<std::uint64_t> number = text::to_number<std::uint64_t>(token);
    if (!number) fail(std::string(what) + " is not a whole number: " + text::quoted(token));
    if (*number > most) fail(std::string(what) + " is too large: " + text::quoted(token));
    return *number;
  }

  void read_header() {
    while (header_.data.empty()) {
      if (!lines_.next())
        throw Error(bytes_.empty() ? "the file is empty" : "the header has no DATA line", name_,
                    "give a whole PCD file");
      text::Tokens tokens(lines_.line());
      std::string_view key;
      if (!tokens.next(key) || key.starts_with('#')) continue;
      std::vector<std::string_view> values;
      for (std::string_view token; tokens.next(token);) values.push_back(token);
      read_entry(key, values);
    }
    if (header_.fields.empty()) fail("the header has no FIELDS");
  }

  void read_entry(std::string_view key, const std::vector<std::string_view>& values) {
    if (key == "VERSION" || key == "VIEWPOINT") return;
    if (values.empty()) fail(std::string(key.substr(0, 16)) + " has no value");
    if (key == "FIELDS" || key == "COLUMNS") {
      header_.fields.clear();
      for (const std::string_view value : values) header_.fields.push_back({std::string(value)});
    } else if (key == "SIZE" || key == "TYPE" || key == "COUNT") {
      read_per_field(key, values);
    } else if (key == "WIDTH") {
      header_.width = natural(values[0], key, std::numeric_limits<std::uint32_t>::max());
    } else if (key == "HEIGHT") {
      header_.height = natural(values[0], key, std::numeric_limits<std::uint32_t>::max());
    } else if (key == "POINTS") {
      header_.points = natural(values[0], key, std::numeric_limits<std::uint64_t>::max());
    } else if (key == "DATA") {
      read_data_kind(values[0]);
    } else {
      fail("unknown header line " + text::quoted(key));
    }
  }

  void read_per_field(std::string_view key, const std::vector<std::string_view>& values) {
    if (values.size() != header_.fields.size())
      fail(std::string(key) + " has " + text::count_of(values.size(), "value") + ", FIELDS has " +
           std::to_string(header_.fields.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      PcdField& field = header_.fields[i];
      if (key == "SIZE") field.size = static_cast<std::size_t>(natural(values[i], key, 8));
      if (key == "COUNT") field.count = static_cast<std::size_t>(natural(values[i], key, 1'000'000));
      if (key != "TYPE") continue;
      if (values[i] != "F" && values[i] != "I" && values[i] != "U") fail("unknown TYPE " + text::quoted(values[i]));
      field.type = values[i].front();
    }
  }

  void read_data_kind(std::string_view kind) {
    if (kind == "binary_compressed")
      fail("compressed PCD is not read", "convert it: pcl_convert_pcd_ascii_binary IN OUT 1 (or 0 for ascii)");
    if (kind != "ascii" && kind != "binary") fail("unknown DATA " + text::quoted(kind));
    header_.data = kind;
  }

  /// Where x, y, z stand in a point: the value's number (ascii) and its byte (binary).
  void find_coordinates() {
    std::array<bool, 3> found{};
    for (const PcdField& field : header_.fields) {
      const std::size_t axis = field.name == "x" ? 0 : field.name == "y" ? 1 : field.name == "z" ? 2 : 3;
      if (axis < 3) {
        found[axis] = true;
        value_[axis] = values_;
        byte_[axis] = stride_;
        kind_[axis] = kind_of(field);
      }
      values_ += field.count;
      stride_ += field.count * field.size;
    }
    if (!found[0] || !found[1]) fail("FIELDS has no x and y");
    has_z_ = found[2];
  }

  binary::Kind kind_of(const PcdField& field) const {
    const bool fits = field.count >= 1 && (field.size == 4 || field.size == 8 ||
                                           (field.type != 'F' && (field.size == 1 || field.size == 2)));
    if (!fits) fail("field " + field.name + " has no number of a known SIZE and COUNT");
    return {field.type == 'F'   ? binary::Kind::Class::real
            : field.type == 'I' ? binary::Kind::Class::whole
                                : binary::Kind::Class::natural,
            field.size};
  }

  std::uint64_t points_promised() const { return header_.points ? *header_.points : header_.width * header_.height; }

  [[noreturn]] void fail_cut(std::uint64_t found) const {
    throw Error(
        "the header promises " + std::to_string(points_promised()) + " points, the file holds " + std::to_string(found),
        lines_.where(), "the file is cut: copy or write it again");
  }

  void read_binary(RawCloud& cloud) const {
    const std::string_view data = bytes_.substr(lines_.offset());
    const std::uint64_t held = data.size() / stride_;
    const std::uint64_t promised = points_promised();
    if (promised > held) fail_cut(held);
    cloud.points.reserve(static_cast<std::size_t>(promised));
    for (std::size_t i = 0; i < promised; ++i) {
      Point3 point = Point3::Zero();
      for (std::size_t axis = 0; axis < (has_z_ ? 3U : 2U); ++axis)
        point[static_cast<int>(axis)] = binary::read_number(data, i * stride_ + byte_[axis], kind_[axis], false);
      cloud.add(point);
    }
  }

  void read_ascii(RawCloud& cloud) {
    const std::uint64_t promised = points_promised();
    std::uint64_t found = 0;
    while (found < promised) {
      if (!lines_.next()) fail_cut(found);
      text::Tokens tokens(lines_.line());
      Point3 point = Point3::Zero();
      std::size_t value = 0;
      for (std::string_view token; tokens.next(token); ++value)
        for (std::size_t axis = 0; axis < (has_z_ ? 3U : 2U); ++axis)
          if (value == value_[axis]) point[static_cast<int>(axis)] = coordinate(token);
      if (value == 0) continue;
      if (value != values_) fail(text::count_of(value, "value") + ", FIELDS promise " + std::to_string(values_));
      cloud.add(point);
      ++found;
    }
  }

  double coordinate(std::string_view token) const {
    const std::optional<double> number = text::to_number<double>(token);
    if (!number) fail("not a number: " + text::quoted(token));
    return *number;
  }

  std::string_view bytes_;
  const std::string& name_;
  text::Lines lines_;
  Header header_;
  std::array<std::size_t, 3> value_{};
  std::array<std::size_t, 3> byte_{};
  std::array<binary::Kind, 3> kind_{};
  std::size_t values_ = 0;
  std::size_t stride_ = 0;
  bool has_z_ = false;
};

}  // namespace

RawCloud parse_pcd(std::string_view bytes, const std::string& name) { return PcdReader(bytes, name).read(); }

std::string pcd_bytes(const PointCloud3& points, CloudEncoding encoding) {
  const bool is_binary = encoding == CloudEncoding::binary;
  const std::string count = std::to_string(points.size());
  // In ascii the type is what a reader makes of the text: 4-byte floats are what PCL's own point types match.
  std::string out = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE ";
  out += is_binary ? "8 8 8" : "4 4 4";
  out += "\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count;
  out += is_binary ? "\nDATA binary\n" : "\nDATA ascii\n";
  if (!is_binary) return out + xyz_text(points, 3, ' ');
  for (const Point3& point : points)
    for (const double value : point) binary::append_little_endian(out, value);
  return out;
}

}  // namespace slamicp
