// SPDX-License-Identifier: Apache-2.0
#include "machine.hpp"

#include <ctime>
#include <fstream>
#include <thread>

namespace slamicp::bench {
namespace {

/// The value of the first `name : value` line of /proc/cpuinfo.
std::string cpuinfo(const std::string& name) {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (const std::size_t colon = line.find(": "); line.starts_with(name) && colon != std::string::npos)
      return line.substr(colon + 2);
  return {};
}

std::string widest_vectors() {
  const std::string flags = " " + cpuinfo("flags") + " ";
  for (const auto& [flag, name] : {std::pair{" avx512f ", "AVX-512"}, {" avx2 ", "AVX2"}, {" sse4_2 ", "SSE4.2"}})
    if (flags.find(flag) != std::string::npos) return name;
  return "unknown";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace

Machine this_machine() {
#ifdef __clang__
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  const std::string cpu = cpuinfo("model name");
  return {cpu.empty() ? "unknown" : cpu, widest_vectors(), std::thread::hardware_concurrency(), compiler,
          SLAMICP_BENCH_FLAGS,           today()};
}

measure::Json to_json(const Machine& machine) {
  return {{"cpu", machine.cpu},           {"vectors", machine.vectors}, {"cores", machine.cores},
          {"compiler", machine.compiler}, {"flags", machine.flags},     {"date", machine.date}};
}

std::string brief(const Machine& machine) {
  return machine.cpu + " (" + machine.vectors + "), " + std::to_string(machine.cores) + " cores, " + machine.compiler +
         " " + machine.flags + ", " + machine.date;
}

}  // namespace slamicp::bench
