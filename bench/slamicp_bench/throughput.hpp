// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "contender.hpp"
#include "scene.hpp"

namespace slamicp::bench {

/// Scans a second of independent localizers, a thread each, that share one prepared map: [number of
/// threads][contender], each the middle of so many runs of a second, in turns.
std::vector<std::vector<double>> scans_per_second(const Scene& scene, std::span<const Contender> contenders,
                                                  std::span<const int> threads, int rounds);

}  // namespace slamicp::bench
