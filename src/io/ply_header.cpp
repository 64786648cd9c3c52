// SPDX-License-Identifier: Apache-2.0
#include "io/ply_header.hpp"

#include <array>

#include <slamicp/error.hpp>

#include "io/text.hpp"

namespace slamicp::ply {
namespace {

[[noreturn]] void fail(const text::Lines& lines, const std::string& what) {
  throw Error(what, lines.where(), "give a PLY file with an element vertex that has x and y");
}

binary::Kind kind_of(std::string_view name, const text::Lines& lines) {
  using enum binary::Kind::Class;
  struct Named {
    std::string_view name;
    std::string_view other_name;
    binary::Kind kind;
  };
  static constexpr std::array<Named, 8> known{{{"char", "int8", {whole, 1}},
                                               {"uchar", "uint8", {natural, 1}},
                                               {"short", "int16", {whole, 2}},
                                               {"ushort", "uint16", {natural, 2}},
                                               {"int", "int32", {whole, 4}},
                                               {"uint", "uint32", {natural, 4}},
                                               {"float", "float32", {real, 4}},
                                               {"double", "float64", {real, 8}}}};
  for (const Named& named : known)
    if (name == named.name || name == named.other_name) return named.kind;
  fail(lines, "unknown property type " + text::quoted(name));
}

std::string_view word(text::Tokens& tokens, const text::Lines& lines, const char* what) {
  std::string_view token;
  if (!tokens.next(token)) fail(lines, std::string("the line ends before its ") + what);
  return token;
}

void read_format(text::Tokens& tokens, const text::Lines& lines, Header& header) {
  const std::string_view format = word(tokens, lines, "format");
  if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
    fail(lines, "unknown format " + text::quoted(format));
  header.format = format;
}

void read_element(text::Tokens& tokens, const text::Lines& lines, Header& header) {
  Element element;
  element.name = word(tokens, lines, "element name");
  const std::string_view count = word(tokens, lines, "element count");
  const std::optional<std::uint64_t> number = text::to_number<std::uint64_t>(count);
  if (!number) fail(lines, "element count is not a whole number: " + text::quoted(count));
  element.count = *number;
  header.elements.push_back(std::move(element));
}

void read_property(text::Tokens& tokens, const text::Lines& lines, Header& header) {
  if (header.elements.empty()) fail(lines, "a property before any element");
  Property property;
  std::string_view type = word(tokens, lines, "property type");
  if (type == "list") {
    property.is_list = true;
    property.length_kind = kind_of(word(tokens, lines, "list length type"), lines);
    type = word(tokens, lines, "list value type");
  }
  property.kind = kind_of(type, lines);
  const std::string_view name = word(tokens, lines, "property name");
  if (!property.is_list && header.elements.back().is_vertex())
    property.axis = name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : -1;
  header.elements.back().properties.push_back(property);
}

/// True on the header's last line.
bool read_line(const text::Lines& lines, Header& header) {
  text::Tokens tokens(lines.line());
  std::string_view key;
  if (!tokens.next(key) || key == "comment" || key == "obj_info") return false;
  if (key == "end_header") return true;
  if (key == "format")
    read_format(tokens, lines, header);
  else if (key == "element")
    read_element(tokens, lines, header);
  else if (key == "property")
    read_property(tokens, lines, header);
  else
    fail(lines, "unknown header line " + text::quoted(key));
  return false;
}

void require_coordinates(Header& header, const text::Lines& lines) {
  std::array<bool, 3> found{};
  for (const Element& element : header.elements)
    for (const Property& property : element.properties)
      if (property.axis >= 0) found[static_cast<std::size_t>(property.axis)] = true;
  if (header.format.empty()) fail(lines, "the header has no format");
  if (!found[0] || !found[1]) fail(lines, "no element vertex with properties x and y");
  header.has_z = found[2];
}

}  // namespace

Header read_header(std::string_view bytes, const std::string& name) {
  text::Lines lines(bytes, name);
  if (!lines.next()) throw Error("the file is empty", name, "give a whole PLY file");
  if (lines.line() != "ply") fail(lines, "does not start with 'ply'");
  Header header;
  bool complete = false;
  while (!complete) {
    if (!lines.next()) fail(lines, "the header has no end_header");
    complete = read_line(lines, header);
  }
  require_coordinates(header, lines);
  header.data_offset = lines.offset();
  header.lines = lines.number();
  return header;
}

}  // namespace slamicp::ply
