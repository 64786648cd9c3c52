// SPDX-License-Identifier: Apache-2.0
// slamicp_node: localization in ROS 1, in amcl's place.
#include <cstdio>
#include <cstring>
#include <exception>

#include "front.hpp"

namespace slamicp::node {
namespace {

/// The table of docs/ros.md.
void print_parameters() {
  std::puts("| parameter | type | default | unit | range | meaning |\n| --- | --- | --- | --- | --- | --- |");
  for (const ParameterInfo& each : parameters())
    std::printf("| `%s` | %s | %s | %s | %s | %s |\n", each.name.c_str(), each.type.c_str(), each.fallback.c_str(),
                each.unit.c_str(), each.range.c_str(), each.meaning.c_str());
  std::puts("\n| taken, and of no use | why |\n| --- | --- |");
  for (const auto& [name, why] : parameters_without_use()) std::printf("| `%s` | %s |\n", name.c_str(), why.c_str());
}

Value value_of(const XmlRpc::XmlRpcValue& given) {
  XmlRpc::XmlRpcValue value = given;  // its conversions are not const
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value);
    case XmlRpc::XmlRpcValue::TypeInt:
      return static_cast<int>(value);
    case XmlRpc::XmlRpcValue::TypeDouble:
      return static_cast<double>(value);
    case XmlRpc::XmlRpcValue::TypeArray: {
      std::vector<std::string> words;
      words.reserve(static_cast<std::size_t>(value.size()));
      for (int k = 0; k < value.size(); ++k)
        words.push_back(value[k].getType() == XmlRpc::XmlRpcValue::TypeString ? static_cast<std::string>(value[k])
                                                                              : value[k].toXml());
      return words;
    }
    case XmlRpc::XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    default:
      return value.toXml();
  }
}

Values private_parameters() {
  Values values;
  XmlRpc::XmlRpcValue all;
  if (!ros::param::get("~", all) || all.getType() != XmlRpc::XmlRpcValue::TypeStruct) return values;
  for (const auto& [name, value] : all) values.emplace_back(name, value_of(value));
  return values;
}

}  // namespace
}  // namespace slamicp::node

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--parameters") == 0) {
    slamicp::node::print_parameters();
    return 0;
  }
  ros::init(argc, argv, "slamicp");
  ros::NodeHandle handle;  // keeps ROS up
  try {
    std::vector<std::string> warnings;
    const slamicp::node::NodeOptions options =
        slamicp::node::options_from(slamicp::node::private_parameters(), warnings);
    for (const std::string& warning : warnings) ROS_WARN_STREAM(warning);
    slamicp::node::Front(options).spin();
  } catch (const std::exception& problem) {
    ROS_FATAL_STREAM(problem.what());
    return 1;
  }
  return 0;
}
