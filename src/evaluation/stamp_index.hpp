// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <slamicp/geometry/trajectory.hpp>

namespace slamicp {

/// Finds poses by stamp in a trajectory whose stamps need not rise. Keeps no pose: positions count from 0 in its order.
class StampIndex {
 public:
  explicit StampIndex(const Trajectory& trajectory);

  /// The pose with the nearest stamp within the tolerance [s]. Among equal stamps the one at `occurrence`, counted from
  /// 0 in log order, or the last there is. Of two stamps equally near, the earlier. O(log size).
  std::optional<std::size_t> find(double stamp, double tolerance, std::size_t occurrence = 0) const noexcept;

  /// For each pose, how many before it in the log have the very same stamp.
  std::vector<std::size_t> occurrences() const;

 private:
  struct Entry {
    double stamp;
    std::size_t position;
  };
  std::vector<Entry> entries_;  // by stamp, then by position
};

/// Throws Error if the trajectory is empty or has a stamp or a pose that is not finite. `name` says whose it is.
void check_trajectory(const Trajectory& trajectory, const char* name);

}  // namespace slamicp
