// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "row.hpp"
#include "scene.hpp"

namespace slamicp::bench {

struct RaceOptions {
  int rounds = 3;          ///< through all scans, >= 1
  std::size_t block = 25;  ///< scans that one contender takes in a row before the next has its turn, >= 1
  /// Time that a contender may use [s]: then it sits out, and is judged by the scans that it did.
  double budget_s = std::numeric_limits<double>::infinity();
};

/// Runs all contenders over all scans in turns: block by block, each round and block beginning with another one, so
/// that what disturbs the machine for a while disturbs all alike. One row a contender.
std::vector<Row> race(const Scene& scene, std::span<const Contender> contenders, const RaceOptions& options);

}  // namespace slamicp::bench
