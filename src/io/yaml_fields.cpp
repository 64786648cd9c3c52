// SPDX-License-Identifier: Apache-2.0
#ifdef SLAMICP_WITH_YAML

#include "io/yaml_fields.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/spelling.hpp>

#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr YamlRange coordinate_range{-1e6, 1e6, "m"};

std::string keys_listed(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

/// "did you mean 'radius'?", or all there are.
std::string name_suggestion(std::string_view word, std::span<const std::string_view> names, std::string_view all) {
  const std::string_view nearest = text::nearest_name(word, names);
  if (!nearest.empty()) return "did you mean '" + std::string(nearest) + "'?";
  return std::string(all) + " " + keys_listed(names);
}

std::string range_said(const YamlRange& range) {
  std::string text = range.is_open ? "give a number above " : "give a number from ";
  text::append_general(text, range.lowest, 6);
  text += range.is_open ? ", at most " : " to ";
  text::append_general(text, range.highest, 6);
  return text + " [" + range.unit + "]";
}

}  // namespace

std::string place_of(const YAML::Mark& mark, const std::string& file) {
  return mark.is_null() ? file : file + ':' + std::to_string(mark.line + 1);
}

YamlFields::YamlFields(const YAML::Node& node, std::string_view what, std::span<const std::string_view> known,
                       const std::string& file)
    : node_(node), what_(what), file_(file) {
  if (!node.IsMap()) fail(what_ + " has no 'key: value' pairs", where(), "it may have: " + keys_listed(known));
  std::set<std::string> keys;
  for (const auto& pair : node) {
    const std::string key = pair.first.IsScalar() ? pair.first.Scalar() : std::string();
    if (std::find(known.begin(), known.end(), key) == known.end())
      fail(what_ + " has no key " + text::quoted(key), where(pair.first), name_suggestion(key, known, "it may have:"));
    if (!keys.insert(key).second)
      fail(what_ + " has the key '" + key + "' twice", where(pair.first), "leave one of them out");
  }
}

void YamlFields::fail(const std::string& what, const std::string& where, const std::string& mend) {
  throw Error(what, where, mend);
}

std::string YamlFields::where(const YAML::Node& node) const { return place_of(node.Mark(), file_); }

std::optional<YAML::Node> YamlFields::find(std::string_view key) const {
  for (const auto& pair : node_)
    if (pair.first.Scalar() == key) return pair.second;
  return std::nullopt;
}

YAML::Node YamlFields::need(std::string_view key) const {
  const std::optional<YAML::Node> node = find(key);
  if (!node || node->IsNull())
    fail(what_ + " has no '" + std::string(key) + "'", node ? where(*node) : where(),
         "write '" + std::string(key) + ": ...'");
  return *node;
}

std::string YamlFields::scalar(const YAML::Node& node, std::string_view key) const {
  if (!node.IsScalar())
    fail("'" + std::string(key) + "' of " + what_ + " is not a single value", where(node),
         "write '" + std::string(key) + ": VALUE'");
  return node.Scalar();
}

double YamlFields::number_in(const YAML::Node& node, std::string_view key, const YamlRange& range) const {
  const std::string word = scalar(node, key);
  const std::optional<double> number = text::to_number<double>(word);
  if (!number || !std::isfinite(*number))
    fail("'" + std::string(key) + "' of " + what_ + " is not a number: " + text::quoted(word), where(node),
         range_said(range));
  const bool is_in = (range.is_open ? *number > range.lowest : *number >= range.lowest) && *number <= range.highest;
  if (!is_in) fail("'" + std::string(key) + "' of " + what_ + " is " + word, where(node), range_said(range));
  return *number;
}

double YamlFields::number(std::string_view key, const YamlRange& range) const {
  return number_in(need(key), key, range);
}

double YamlFields::number(std::string_view key, const YamlRange& range, double otherwise) const {
  return has(key) ? number(key, range) : otherwise;
}

double YamlFields::angle(std::string_view key, std::optional<double> otherwise) const {
  if (otherwise && !has(key)) return *otherwise;
  return number(key, {-360.0, 360.0, "deg"}) * rad_per_deg;
}

bool YamlFields::flag(std::string_view key, bool otherwise) const {
  constexpr std::string_view choices[] = {"false", "true"};
  return choice(key, choices, otherwise ? 1 : 0) == 1;
}

std::string YamlFields::words(std::string_view key) const { return scalar(need(key), key); }

std::string YamlFields::words(std::string_view key, const std::string& otherwise) const {
  return has(key) ? words(key) : otherwise;
}

std::size_t YamlFields::choice(std::string_view key, std::span<const std::string_view> choices,
                               std::size_t otherwise) const {
  if (!has(key)) return otherwise;
  const YAML::Node node = need(key);
  const std::string word = scalar(node, key);
  const auto found = std::find(choices.begin(), choices.end(), word);
  if (found == choices.end())
    fail("'" + std::string(key) + "' of " + what_ + " is " + text::quoted(word), where(node),
         name_suggestion(word, choices, "give one of:"));
  return static_cast<std::size_t>(found - choices.begin());
}

Point2 YamlFields::point_in(const YAML::Node& node, std::string_view key) const {
  if (!node.IsSequence() || node.size() != 2)
    fail("'" + std::string(key) + "' of " + what_ + " has something that is no point", where(node),
         "write a point as [x, y] [m, m]");
  return {number_in(node[0], key, coordinate_range), number_in(node[1], key, coordinate_range)};
}

Point2 YamlFields::point(std::string_view key) const { return point_in(need(key), key); }

PointCloud2 YamlFields::points(std::string_view key, std::size_t fewest) const {
  const YAML::Node node = need(key);
  if (!node.IsSequence() || node.size() < fewest)
    fail("'" + std::string(key) + "' of " + what_ + " has not " + text::count_of(fewest, "point") + " or more",
         where(node), "write '" + std::string(key) + ": [[x, y], [x, y]]' [m, m]");
  PointCloud2 points;
  points.reserve(node.size());
  for (const YAML::Node& item : node) {
    points.push_back(point_in(item, key));
    if (points.size() > 1 && points.back() == points[points.size() - 2])
      fail("'" + std::string(key) + "' of " + what_ + " has the same point twice in a row", where(item),
           "leave one out");
  }
  return points;
}

YAML::Node YamlFields::list(std::string_view key) const {
  const std::optional<YAML::Node> node = find(key);
  if (!node || node->IsNull()) return YAML::Node(YAML::NodeType::Sequence);
  if (!node->IsSequence())
    fail("'" + std::string(key) + "' of " + what_ + " is no list", where(*node), "begin each of its things with '- '");
  return *node;
}

}  // namespace slamicp

#endif
