// SPDX-License-Identifier: Apache-2.0
// How often what is said to be so with a probability is so: what a calibration plot shows.
#pragma once

#include <algorithm>
#include <array>

#include "support.hpp"

namespace slamicp::measure {

/// How often poses are right that are said to be so with this probability.
struct Reliability {
  std::array<int, 10> all{}, right{};
  double squares = 0.0;
  int count = 0;

  void add(double probability, bool is_right) {
    const auto bin = std::min<std::size_t>(9, static_cast<std::size_t>(10.0 * probability));
    ++all[bin];
    right[bin] += is_right;
    const double off = probability - (is_right ? 1.0 : 0.0);
    squares += off * off;
    ++count;
  }
  /// Mean squared error of the probability (Brier 1950).
  double brier() const { return squares / std::max(1, count); }
};

/// A row for each tenth, as the plots read it.
inline Json bins_json(const Reliability& by_scan, const Reliability& averaged) {
  Json bins = Json::array();
  for (std::size_t k = 0; k < averaged.all.size(); ++k)
    bins.push_back({{"from", 0.1 * static_cast<double>(k)},
                    {"scans", by_scan.all[k]},
                    {"right", by_scan.right[k]},
                    {"averaged_scans", averaged.all[k]},
                    {"averaged_right", averaged.right[k]}});
  return bins;
}

}  // namespace slamicp::measure
