// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace slamicp::node {

/// Who a node is, and which of its topics have other names: as ROS 2 has it.
struct Names {
  std::string node = "slamicp";
  std::string space = "/";                                    ///< ROS 2: namespace
  std::vector<std::pair<std::string, std::string>> remapped;  ///< from, to; the first that fits holds

  /// "/robot/slamicp"
  std::string whole() const { return absolute(node); }
  /// What a topic is called in the end: "/robot/scan".
  std::string topic(const std::string& name) const;

 private:
  std::string absolute(const std::string& name) const;
};

}  // namespace slamicp::node
