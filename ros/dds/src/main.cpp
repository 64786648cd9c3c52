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

void run(const std::vector<std::string>& words) {
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
  Front(options, arguments.names, arguments.use_sim_time, domain_from(std::getenv("ROS_DOMAIN_ID"))).spin(stopped);
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
