// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <thread>

namespace slamicp::dds_peer {

inline void must(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

/// Asks again and again, for a minute at most.
template <class Ready>
void wait_for(const Ready& ready, const std::string& what) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point until = Clock::now() + std::chrono::seconds(60);
  while (!ready()) {
    must(Clock::now() < until, "nobody says: " + what);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// A program's result; 1 where it threw, with what on standard output.
template <class Run>
int tell_problems(const Run& run) {
  try {
    return run();
  } catch (const std::exception& problem) {
    std::printf("%s\n", problem.what());
    return 1;
  }
}

}  // namespace slamicp::dds_peer
