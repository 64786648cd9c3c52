// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/simulation/random.hpp>

namespace slamicp {

/// A recorded run in a map, and where the robot really was.
struct ReferenceRun {
  PointMap2::Pointer map;
  std::vector<LaserScan> scans;
  std::vector<Pose2> reference;  ///< T_map_robot, one a scan
};

/// What a localizer made of a stretch of a recorded run.
struct StretchOutcome {
  bool noticed = false;            ///< put down wrong: within 40 scans suspect, lost or right again
  bool right_again = false;        ///< it noticed by being right again
  double longest_confident = 0.0;  ///< the longest it was wrong, and neither suspect nor lost [s]
  int right_scans = 0;             ///< at the right place
  int alarms = 0;                  ///< times it began to doubt there, after the first 40 scans
};

/// Robots of recorded runs that are put down where they are, or 2 to 6 m or 45 to 180 deg from there.
class StretchTrials {
 public:
  /// The run must outlive it. Throws Error where it has fewer than 100 scans.
  StretchTrials(const ReferenceRun& run, std::uint64_t seed, const LocalizerOptions& options = {});

  /// 80 scans from somewhere in the run.
  StretchOutcome draw(bool put_elsewhere);

  /// Called with each fix of the trials to come and its reference.
  void watch(std::function<void(const Fix&, const Pose2&)> watcher) { watcher_ = std::move(watcher); }

 private:
  Pose2 elsewhere(const Pose2& truth);

  const ReferenceRun& run_;
  Random random_;
  LocalizerOptions options_;
  std::function<void(const Fix&, const Pose2&)> watcher_;
};

}  // namespace slamicp
