// SPDX-License-Identifier: Apache-2.0
// slamicp_dds: localization for ROS 2 machines, over DDS alone.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "arguments.hpp"
#include "front.hpp"

namespace slamicp::node {
namespace {

volatile std::sig_atomic_t stopped = 0;

void stop(int /*signal*/) { stopped = 1; }

void print_parameters() {
  for (const ParameterInfo& each : parameters())
    std::printf("%s (%s, %s%s%s): %s\n", each.name.c_str(), each.type.c_str(), each.fallback.c_str(),
                each.unit.empty() ? "" : " ", each.unit.c_str(), each.meaning.c_str());
}

constexpr const char* usage = R"(slamicp_dds: where a robot is in its map, for ROS 2 machines, over DDS.

  slamicp_dds [--ros-args] [-p NAME:=VALUE]... [--params-file FILE.yaml]... [-r FROM:=TO]...
  slamicp_dds --parameters    all parameters, with what they mean
  slamicp_dds --help

-r __node:=NAME and -r __ns:=/SPACE name the node. The domain is that of ROS_DOMAIN_ID, or 0. More in docs/ros.md.
)";

void run(const std::vector<std::string>& words) {
  if (!words.empty() && (words[0] == "help" || words[0] == "--help" || words[0] == "-h")) {
    std::fputs(usage, stdout);
    return;
  }
  Arguments arguments = arguments_from(words);
  if (arguments.print_parameters) {
    print_parameters();
    return;
  }
  const NodeOptions options = options_from(arguments.values, arguments.warnings);
  for (const std::string& warning : arguments.warnings)
    std::fprintf(stderr, "[WARN] [%s]: %s\n", arguments.names.node.c_str(), warning.c_str());
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  Front(options, arguments.names, arguments.use_sim_time, domain_from(std::getenv("ROS_DOMAIN_ID")),
        spelling_from(std::getenv("ROS_DISTRO")))
      .spin(stopped);
}

}  // namespace
}  // namespace slamicp::node

int main(int argc, char** argv) {
  try {
    slamicp::node::run({argv + 1, argv + argc});
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "[FATAL] [slamicp]: %s\n", problem.what());
    return 1;
  }
  return 0;
}
