// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "obstacles/detection.hpp"
#include "obstacles/laser_view.hpp"

namespace slamicp {

/// How far a place that one fix measured may be off in another one's view.
struct ViewErrors {
  double margin = 0.1;  // in range [m]
  double shift = 0.02;  // sideways [m]
  double turn = 0.003;  // [rad]
};

/// Scans of the last seconds, to compare with.
class PastViews {
 public:
  static constexpr int most = 8;

  /// Keeps this one, if the last one kept is old enough. @returns where; -1: it is not kept.
  int keep(const LaserView& view, double stamp);
  void clear() noexcept;

  bool has(int slot) const noexcept { return kept_[static_cast<std::size_t>(slot)].serial > 0; }
  const LaserView& view(int slot) const noexcept { return kept_[static_cast<std::size_t>(slot)].view; }
  double stamp(int slot) const noexcept { return kept_[static_cast<std::size_t>(slot)].stamp; }
  /// Counts what was kept: a slot is used again.
  int serial(int slot) const noexcept { return kept_[static_cast<std::size_t>(slot)].serial; }

 private:
  struct Kept {
    LaserView view;
    std::vector<float> ranges;
    double stamp = 0.0;
    int serial = 0;
  };

  std::array<Kept, most> kept_;
  int last_ = most - 1;
  int serial_ = 0;
};

/// How many points of a footprint stand where a view saw through, and where it saw something. Others are not known.
struct FreeSpace {
  int free = 0;
  int taken = 0;

  /// So many, and so many more than others, that it is no mixed reading at an edge.
  bool tells() const noexcept { return free >= 2 && free >= 2 * taken; }
};

/// @param sees_beyond  free is only what the view saw through to what is behind; else no return will do: what gave one
///                     before is not there any more
FreeSpace free_space(const LaserView& view, const Footprint& footprint, const ViewErrors& errors,
                     bool sees_beyond) noexcept;

}  // namespace slamicp
