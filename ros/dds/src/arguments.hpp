// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <slamicp_node/parameters.hpp>
#include <string>
#include <vector>

#include "names.hpp"

namespace slamicp::node {

/// What the command line says, in ROS 2's way:
///   --ros-args -p NAME:=VALUE --params-file FILE.yaml -r FROM:=TO -r __node:=NAME -r __ns:=/SPACE
/// Later words win over earlier ones.
struct Arguments {
  Names names;
  Values values;              ///< of the node, without use_sim_time
  bool use_sim_time = false;  ///< time is that of /clock
  bool print_parameters = false;
  std::vector<std::string> warnings;
};
/// Throws slamicp::Error for a word that means nothing, and for a file that cannot be read.
Arguments arguments_from(const std::vector<std::string>& words);

/// Of ROS_DOMAIN_ID; null or empty: 0. Throws slamicp::Error where it is none: 0 to 232.
std::uint32_t domain_from(const char* text);

}  // namespace slamicp::node
