// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include <slamicp/error.hpp>

#include "io/cloud_formats.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr std::size_t most_columns = 32;  // more is a log of ranges
constexpr const char* form = "give x,y or x,y,z a line, in metres";

/// Which columns hold x, y, z.
struct Columns {
  std::size_t count = 0;  ///< a line; 0 = not known yet
  std::array<std::size_t, 3> of{0, 1, 2};
  bool has_z = false;
};

std::vector<std::string_view> split(std::string_view line, std::vector<std::string_view> tokens) {
  tokens.clear();
  text::Tokens rest(line);
  for (std::string_view token; rest.next(token);) tokens.push_back(token);
  return tokens;
}

bool is_comment(std::string_view token) { return token.starts_with('#') || token.starts_with("//"); }

std::string lower_case_without_quotes(std::string_view token) {
  std::string name;
  for (const char c : token)
    if (c != '"') name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name;
}

/// A header with columns x and y names its columns; any other is a title over x, y[, z].
Columns columns_by_header(const std::vector<std::string_view>& names) {
  Columns columns;
  std::array<std::size_t, 3> found;
  found.fill(names.size());
  constexpr std::array<std::string_view, 3> wanted{"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = names.size(); i-- > 0;)
      if (lower_case_without_quotes(names[i]) == wanted[axis]) found[axis] = i;
  if (found[0] == names.size() || found[1] == names.size()) return columns;
  columns.count = names.size();
  columns.of = found;
  columns.has_z = found[2] != names.size();
  return columns;
}

Columns columns_by_count(std::size_t count, const text::Lines& lines) {
  if (count < 2) throw Error("only one value, a point has at least x and y", lines.where(), form);
  if (count > most_columns)
    throw Error(std::to_string(count) + " values a line: a log of ranges, not a cloud", lines.where(), form);
  Columns columns;
  columns.count = count;
  columns.has_z = count > 2;
  return columns;
}

double coordinate(std::string_view token, const text::Lines& lines) {
  const std::optional<double> value = text::to_number<double>(token);
  if (!value) throw Error("not a number: " + text::quoted(token), lines.where(), form);
  return *value;
}

}  // namespace

RawCloud parse_xyz(std::string_view text, const std::string& name) {
  RawCloud cloud;
  Columns columns;
  std::vector<std::string_view> tokens;
  bool header_allowed = true;
  text::Lines lines(text, name);
  while (lines.next()) {
    tokens = split(lines.line(), std::move(tokens));
    if (tokens.empty() || is_comment(tokens.front())) continue;
    if (header_allowed && !text::to_number<double>(tokens.front())) {
      columns = columns_by_header(tokens);
      header_allowed = false;
      continue;
    }
    header_allowed = false;
    if (columns.count == 0) columns = columns_by_count(tokens.size(), lines);
    if (tokens.size() != columns.count)
      throw Error(
          text::count_of(tokens.size(), "value") + ", but " + std::to_string(columns.count) + " in the lines before",
          lines.where(), form);
    const double z = columns.has_z ? coordinate(tokens[columns.of[2]], lines) : 0.0;
    cloud.add({coordinate(tokens[columns.of[0]], lines), coordinate(tokens[columns.of[1]], lines), z});
  }
  if (columns.count == 0) throw Error("holds no point", name, form);
  cloud.has_z = columns.has_z;
  cloud.format = "CSV";
  if (columns.count > (columns.has_z ? 3U : 2U))
    cloud.warnings.push_back(std::to_string(columns.count) + " columns: all but " +
                             (columns.has_z ? "x, y, z" : "x, y") + " are ignored");
  return cloud;
}

std::string xyz_text(const PointCloud3& points, int dimension, char separator) {
  std::string out;
  for (const Point3& point : points) {
    for (int axis = 0; axis < dimension; ++axis) {
      if (axis > 0) out += separator;
      text::append_general(out, point[axis]);
    }
    out += '\n';
  }
  return out;
}

}  // namespace slamicp
