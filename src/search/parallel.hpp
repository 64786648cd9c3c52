// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace slamicp {

/// Calls work(begin, end) for pieces of [0, count), on `threads` threads that the caller granted, and returns when all
/// are done. The work on one element must not depend on the pieces: then the result is the same for any number.
/// @param worth_a_thread  elements that are worth the start of one
template <typename Work>
void parallel_chunks(std::size_t count, int threads, const Work& work, std::size_t worth_a_thread = 512) {
  const std::size_t pieces = std::clamp<std::size_t>(count / worth_a_thread, 1, static_cast<std::size_t>(threads));
  const auto edge = [&](std::size_t piece) { return count * piece / pieces; };
  std::vector<std::jthread> others;
  for (std::size_t piece = 1; piece < pieces; ++piece)
    others.emplace_back([&, piece] { work(edge(piece), edge(piece + 1)); });
  work(0, edge(1));
}

}  // namespace slamicp
