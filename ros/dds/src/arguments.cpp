// SPDX-License-Identifier: Apache-2.0
#include "arguments.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <iterator>
#include <string_view>
#include <system_error>
#include <yaml-cpp/yaml.h>

#include <slamicp/error.hpp>

namespace slamicp::node {
namespace {

Value value_of(const YAML::Node& node, const std::string& name) {
  if (node.IsSequence()) {
    std::vector<std::string> words;
    for (const YAML::Node& each : node) words.push_back(each.Scalar());
    return words;
  }
  if (node.IsNull()) return std::string();
  if (!node.IsScalar()) throw Error("'" + name + "' is neither a value nor a list", "parameters");
  const bool is_quoted = node.Tag() == "!";
  if (is_quoted) return node.Scalar();
  int whole = 0;
  double real = 0.0;
  bool flag = false;
  if (YAML::convert<int>::decode(node, whole)) return whole;
  if (YAML::convert<double>::decode(node, real)) return real;
  if (YAML::convert<bool>::decode(node, flag)) return flag;
  return node.Scalar();
}

void set_value(const std::string& name, const Value& value, Arguments& arguments) {
  if (name != "use_sim_time") {
    arguments.values.emplace_back(name, value);
    return;
  }
  const bool* const flag = std::get_if<bool>(&value);
  if (flag == nullptr) throw Error("'use_sim_time' is a bool", "parameters", "give true or false");
  arguments.use_sim_time = *flag;
}

void take_values(const YAML::Node& map, const std::string& prefix, Arguments& arguments) {
  for (const auto& entry : map) {
    const std::string name = prefix + entry.first.Scalar();
    if (entry.second.IsMap())
      take_values(entry.second, name + ".", arguments);
    else
      set_value(name, value_of(entry.second, name), arguments);
  }
}

/// Whether a section of a file is the node's: "/**", "/robot/amcl", and "amcl" in whatever namespace.
bool is_ours(const std::string& section, const Names& names) {
  return section == "/**" || section == "/**/" + names.node || section == "/" + names.node || section == names.whole();
}

/// Namespaces may hold sections.
bool take_sections(const YAML::Node& map, const std::string& space, Arguments& arguments) {
  bool found = false;
  for (const auto& entry : map) {
    const std::string name = entry.first.Scalar();
    std::string section = space;
    if (name.empty() || name.front() != '/') section += '/';
    section += name;
    if (!entry.second.IsMap()) continue;
    const YAML::Node values = entry.second["ros__parameters"];
    if (!values.IsDefined()) {
      found = take_sections(entry.second, section, arguments) || found;
    } else if (is_ours(section, arguments.names)) {
      found = true;
      take_values(values, "", arguments);
    }
  }
  return found;
}

void take_file(const std::string& file, Arguments& arguments) {
  bool found = false;
  try {
    found = take_sections(YAML::LoadFile(file), "", arguments);
  } catch (const YAML::Exception& problem) {
    throw Error(problem.what(), file, "a file of parameters: node name, ros__parameters, and their names and values");
  }
  if (!found) arguments.warnings.push_back(file + " has no ros__parameters for " + arguments.names.whole());
}

/// FROM:=TO
std::pair<std::string, std::string> parts_of(const std::string& word) {
  const std::size_t middle = word.find(":=");
  if (middle == std::string::npos || middle == 0) throw Error("'" + word + "' is not NAME:=VALUE", "command line");
  return {word.substr(0, middle), word.substr(middle + 2)};
}

void set_parameter(const std::string& word, Arguments& arguments) {
  const auto [name, text] = parts_of(word);
  try {
    set_value(name, value_of(YAML::Load(text), name), arguments);
  } catch (const YAML::Exception& problem) {
    throw Error(problem.what(), name, "give the value as YAML has it");
  }
}

/// "/robot" of "robot/" too.
std::string space_from(const std::string& text) {
  const std::string space = text.front() == '/' ? text : '/' + text;
  const std::size_t last = space.find_last_not_of('/');
  return last == std::string::npos ? "/" : space.substr(0, last + 1);
}

void remap(const std::string& word, Arguments& arguments) {
  const auto [from, to] = parts_of(word);
  if (to.empty()) throw Error("'" + word + "' names nothing", "command line");
  if (from == "__node" || from == "__name")
    arguments.names.node = to;
  else if (from == "__ns")
    arguments.names.space = space_from(to);
  else
    arguments.names.remapped.emplace_back(from, to);
}

/// ROS 2's words that mean nothing to a node without a log file and without security.
bool is_idle(std::string_view word) {
  return word == "--ros-args" || word == "--" ||
         (word.ends_with("-logs") && (word.starts_with("--enable-") || word.starts_with("--disable-")));
}

bool wants_value(std::string_view word) {
  constexpr std::string_view all[] = {"-p", "--param",   "-r",          "--remap",         "--params-file",
                                      "-e", "--enclave", "--log-level", "--log-file-name", "--log-config-file"};
  return std::find(std::begin(all), std::end(all), word) != std::end(all);
}

}  // namespace

Arguments arguments_from(const std::vector<std::string>& words) {
  Arguments arguments;
  std::vector<std::pair<std::string, std::string>> given;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (is_idle(word)) continue;
    if (word == "--parameters") {
      arguments.print_parameters = true;
      continue;
    }
    if (!wants_value(word))
      throw Error("'" + word + "' means nothing here", "command line",
                  "--ros-args -p NAME:=VALUE --params-file FILE.yaml -r FROM:=TO, or --parameters");
    if (k + 1 == words.size()) throw Error("'" + word + "' wants a word after it", "command line");
    given.emplace_back(word, words[++k]);
  }
  // Whose section of a file holds goes by the node's name, wherever that is said.
  for (const auto& [word, value] : given)
    if (word == "-r" || word == "--remap") remap(value, arguments);
  for (const auto& [word, value] : given) {
    if (word == "-p" || word == "--param") set_parameter(value, arguments);
    if (word == "--params-file") take_file(value, arguments);
  }
  return arguments;
}

std::uint32_t domain_from(const char* text) {
  constexpr std::uint32_t most = 232;  // beyond, DDS has no ports
  if (text == nullptr || *text == '\0') return 0;
  std::uint32_t domain = 0;
  const char* const end = text + std::strlen(text);
  const auto [rest, problem] = std::from_chars(text, end, domain);
  if (problem != std::errc() || rest != end || domain > most)
    throw Error(std::string("'") + text + "' is no domain", "ROS_DOMAIN_ID", "give a whole number from 0 to 232");
  return domain;
}

}  // namespace slamicp::node
