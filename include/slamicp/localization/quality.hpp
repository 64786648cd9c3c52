// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace slamicp {

/// What a localizer thinks of its pose.
enum class TrackingState {
  tracking,    ///< the pose is right, by all that scans tell
  degenerate,  ///< right as far as scans tell, which is not in every direction: see Fix::carried_by
  suspect,     ///< what the scans show does not fit the map here: the map has changed much, or the pose is wrong
  lost,        ///< it has been so for a while: look around (LocalSearch), or set the pose anew
};

/// "tracking", "degenerate", "suspect", "lost"
const char* to_string(TrackingState state) noexcept;

/// True for `suspect` and `lost`.
constexpr bool is_doubted(TrackingState state) noexcept {
  return state == TrackingState::suspect || state == TrackingState::lost;
}

/// What one scan shows at the pose of its fix, by a sample of its rays. All are shares, in [0, 1].
struct Evidence {
  int rays = 0;            ///< that were looked at; all else is 0 without any
  double explained = 0.0;  ///< end at a mapped surface, within the pairs' noise
  double beside = 0.0;     ///< end near a surface, but not on it: what a wrong pose does, and a changed map seldom
  /// Went through a mapped wall and ended where the map explains nothing. Things that came never make rays do it; where
  /// things left, rays end at the walls behind them.
  double violations = 0.0;
  double spread = 0.0;  ///< of the directions around the robot in which rays ended, those where walls explain most
};

/// How good the localizer's pose is, by this scan and those before.
struct Quality {
  TrackingState state = TrackingState::tracking;
  /// That the pose is right to within half a metre and 15 deg, by the last scans and by how long the pose has been
  /// followed without a surprise. In [0, 1].
  double probability = 1.0;
  double scan_probability = 1.0;  ///< by this scan alone, were right and wrong poses equally likely
  /// Situational awareness: the share of the surroundings that the map explains, averaged over the last seconds.
  double awareness = 1.0;
  Evidence evidence;

  bool doubted() const noexcept { return is_doubted(state); }

  /// One line.
  std::string brief() const;
};

/// When a localizer begins to doubt its pose, and when it trusts it again.
struct QualityOptions {
  /// Rays looked at, evenly over the scan. More is surer and slower: one that the map explains costs a look at its end,
  /// any other one a walk along it. 0: no quality at all. 0, or 16 to 256.
  int rays = 64;
  double suspect_below = 0.6;      ///< probability below which the pose is suspect, in (0, 1)
  double trusted_above = 0.9;      ///< probability above which it is trusted again, in (suspect_below, 1)
  int lost_after = 20;             ///< scans in a row that were suspect before the state is lost, at least 1
  double memory = 10.0;            ///< scans over which the probability is averaged, at least 1
  double awareness_memory = 40.0;  ///< scans over which the awareness is averaged, at least 1

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

}  // namespace slamicp
