// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp::bench {

/// The gate of every contender, and from where on a point is an outlier: the paper's indist and O_t [m].
inline constexpr double gate = 0.3;
/// Steps at most, and where a step is small enough to stop [m, rad]; for all who let us choose.
inline constexpr int max_iterations = 50;
inline constexpr double tolerance = 1e-4;

/// What a contender says of one scan.
struct Estimate {
  Pose2 pose;
  int iterations = 0;
  std::optional<std::vector<int>> outliers;  ///< into the scan, rising; none where the contender does not find them

  /// An empty list of outliers that keeps its memory.
  std::vector<int>& fresh_outliers() {
    if (!outliers) outliers.emplace();
    outliers->clear();
    return *outliers;
  }
};

/// Localizes scans in a map that was prepared before. Belongs to one thread.
class Matcher {
 public:
  Matcher() = default;
  Matcher(const Matcher&) = delete;
  Matcher& operator=(const Matcher&) = delete;
  virtual ~Matcher() = default;

  /// What is timed. `estimate` is the last scan's, and keeps its memory.
  virtual void localize(const PointCloud2& scan, const Pose2& guess, Estimate& estimate) = 0;
};

using SharedCloud = std::shared_ptr<const PointCloud2>;

/// Makes matchers that share one prepared map.
using MakeMatcher = std::function<std::unique_ptr<Matcher>()>;

struct Contender {
  std::string name;                                 ///< as --only takes it
  std::string what;                                 ///< in words
  std::function<MakeMatcher(SharedCloud)> prepare;  ///< builds all that it keeps from scan to scan
};

}  // namespace slamicp::bench
