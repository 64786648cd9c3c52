// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <yaml-cpp/yaml.h>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// FILE:LINE, or the file alone where the mark knows no line.
std::string place_of(const YAML::Mark& mark, const std::string& file);

/// What a number may be.
struct YamlRange {
  double lowest;
  double highest;
  const char* unit;
  bool is_open = false;  ///< the lowest itself may not be
};

/// The `key: value` pairs of one thing in a YAML file, read key by key. Whatever is wrong throws an Error with file,
/// line, and how to mend it.
class YamlFields {
 public:
  /// @param what   the thing, for messages: "a door"
  /// @param known  all keys that it may have; each may stand there once
  YamlFields(const YAML::Node& node, std::string_view what, std::span<const std::string_view> known,
             const std::string& file);

  bool has(std::string_view key) const { return find(key).has_value(); }
  /// Where the thing begins.
  std::string where() const { return where(node_); }
  std::string where(std::string_view key) const { return where(find(key).value_or(node_)); }

  double number(std::string_view key, const YamlRange& range) const;
  double number(std::string_view key, const YamlRange& range, double otherwise) const;
  /// In degrees there, in radians here, up to one turn.
  double angle(std::string_view key, std::optional<double> otherwise = std::nullopt) const;
  bool flag(std::string_view key, bool otherwise) const;
  std::string words(std::string_view key) const;
  std::string words(std::string_view key, const std::string& otherwise) const;
  /// The number of the word that stands there.
  std::size_t choice(std::string_view key, std::span<const std::string_view> choices, std::size_t otherwise) const;
  Point2 point(std::string_view key) const;
  /// At least `fewest` points, none twice in a row.
  PointCloud2 points(std::string_view key, std::size_t fewest) const;
  /// What stands there, for fields of its own.
  YAML::Node things(std::string_view key) const { return need(key); }
  /// The things of a list; none where the key is not there.
  YAML::Node list(std::string_view key) const;

  [[noreturn]] static void fail(const std::string& what, const std::string& where, const std::string& mend);

 private:
  std::optional<YAML::Node> find(std::string_view key) const;
  YAML::Node need(std::string_view key) const;
  std::string scalar(const YAML::Node& node, std::string_view key) const;
  double number_in(const YAML::Node& node, std::string_view key, const YamlRange& range) const;
  Point2 point_in(const YAML::Node& node, std::string_view key) const;
  std::string where(const YAML::Node& node) const;

  YAML::Node node_;
  std::string what_;
  const std::string& file_;
};

}  // namespace slamicp
