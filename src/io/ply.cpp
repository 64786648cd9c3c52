// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <slamicp/error.hpp>

#include "io/cloud_formats.hpp"
#include "io/ply_header.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

using ply::Element;
using ply::Property;

constexpr const char* mend_cut = "the file is cut or not what its header says: copy or write it again";

/// Takes one value after the other from binary data.
class BinaryValues {
 public:
  BinaryValues(std::string_view data, const std::string& name, bool big_endian)
      : data_(data), name_(name), big_endian_(big_endian) {}

  double next(const binary::Kind& kind) {
    if (data_.size() - at_ < kind.size) throw Error("the data end too early", name_, mend_cut);
    const double value = binary::read_number(data_, at_, kind, big_endian_);
    at_ += kind.size;
    return value;
  }
  std::size_t most_values_left() const noexcept { return data_.size() - at_; }
  std::string where() const { return name_; }

 private:
  std::string_view data_;
  const std::string& name_;
  std::size_t at_ = 0;
  bool big_endian_;
};

/// Takes one value after the other from text; line ends are blanks.
class AsciiValues {
 public:
  AsciiValues(std::string_view text, const std::string& name, std::size_t offset, std::size_t lines_before)
      : text_(text), lines_(text, name, offset, lines_before), tokens_({}) {}

  double next(const binary::Kind&) {
    std::string_view token;
    while (!tokens_.next(token)) {
      if (!lines_.next()) throw Error("the data end too early", lines_.where(), mend_cut);
      tokens_ = text::Tokens(lines_.line());
    }
    const std::optional<double> value = text::to_number<double>(token);
    if (!value) throw Error("not a number: " + text::quoted(token), lines_.where(), "mend or take out the line");
    return *value;
  }
  /// A value takes a character and a blank, at least.
  std::size_t most_values_left() const noexcept { return text_.size() - lines_.offset() + lines_.line().size(); }
  std::string where() const { return lines_.where(); }

 private:
  std::string_view text_;
  text::Lines lines_;
  text::Tokens tokens_;
};

template <class Values>
void skip_list(const Property& list, Values& values) {
  const double length = values.next(list.length_kind);
  if (!(length >= 0.0 && length <= static_cast<double>(values.most_values_left())))
    throw Error("a list has a length that cannot be", values.where(), mend_cut);
  for (auto left = static_cast<std::size_t>(length); left > 0; --left) values.next(list.kind);
}

template <class Values>
Point3 read_vertex(const Element& element, Values& values) {
  Point3 point = Point3::Zero();
  for (const Property& property : element.properties) {
    if (property.is_list) {
      skip_list(property, values);
      continue;
    }
    const double value = values.next(property.kind);
    if (property.axis >= 0) point[property.axis] = value;
  }
  return point;
}

/// A promise of more than the file can hold is found before memory is asked for.
template <class Values>
void require_room(const Element& element, const Values& values) {
  const std::uint64_t most = values.most_values_left() / std::max<std::size_t>(element.properties.size(), 1);
  if (!element.properties.empty() && element.count > most)
    throw Error("the header promises " + std::to_string(element.count) + " of element " + element.name +
                    ", the file holds less",
                values.where(), mend_cut);
}

template <class Values>
void read_elements(const ply::Header& header, Values values, RawCloud& cloud) {
  for (const Element& element : header.elements) {
    require_room(element, values);
    if (element.properties.empty()) continue;
    if (element.is_vertex()) {
      cloud.points.reserve(static_cast<std::size_t>(element.count));
      for (std::uint64_t i = 0; i < element.count; ++i) cloud.add(read_vertex(element, values));
      return;  // what follows is not ours
    }
    for (std::uint64_t i = 0; i < element.count; ++i) read_vertex(element, values);
  }
}

}  // namespace

RawCloud parse_ply(std::string_view bytes, const std::string& name) {
  const ply::Header header = ply::read_header(bytes, name);
  RawCloud cloud;
  cloud.format = "PLY " + header.format;
  cloud.has_z = header.has_z;
  if (header.format == "ascii")
    read_elements(header, AsciiValues(bytes, name, header.data_offset, header.lines), cloud);
  else
    read_elements(header, BinaryValues(bytes.substr(header.data_offset), name, header.format == "binary_big_endian"),
                  cloud);
  return cloud;
}

std::string ply_bytes(const PointCloud3& points, CloudEncoding encoding) {
  const bool is_binary = encoding == CloudEncoding::binary;
  std::string out = "ply\nformat ";
  out += is_binary ? "binary_little_endian" : "ascii";
  out += " 1.0\ncomment written by slamicp, metres\nelement vertex " + std::to_string(points.size());
  out += "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  if (!is_binary) return out + xyz_text(points, 3, ' ');
  for (const Point3& point : points)
    for (const double value : point) binary::append_little_endian(out, value);
  return out;
}

}  // namespace slamicp
