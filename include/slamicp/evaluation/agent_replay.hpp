// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <slamicp/evaluation/recorded_drive.hpp>

namespace slamicp {

/// What an agent made of recorded scans, scan by scan.
struct AgentReplay {
  std::vector<double> seconds;        ///< of each control cycle; 0 without a clock
  std::vector<std::size_t> outliers;  ///< of each
  std::vector<Pose2> poses;           ///< T_map_robot of each

  double mean_seconds() const noexcept;
  double mean_outliers() const noexcept;
};

struct ReplayOptions {
  AgentForm form = AgentForm::improved;
  bool rebuild_index = false;  ///< see AgentOptions
  std::size_t every = 1;       ///< of so many scans one is shown, at least 1
};

/// Shows an agent the scans of a drive as if it drove; its commands move nothing, the map stays as it is. The first
/// scan, at which memory is laid out, counts in nothing. Throws Error where every is 0, and for a drive without scans.
AgentReplay replay_agent(const ExperimentSite& site, const RecordedDrive& drive, const ReplayOptions& options = {},
                         const Clock& clock = {});

/// The paper's eq. (8): how much less time the improved agent takes than the original one [%].
double improvement_percent(double original_seconds, double improved_seconds) noexcept;

/// What many outliers cost the improved agent, at the same places with and without an obstacle.
struct OutlierCost {
  std::size_t scans = 0;          ///< compared
  double outliers_with = 0.0;     ///< a scan
  double outliers_without = 0.0;  ///< a scan
  double seconds_with = 0.0;      ///< a cycle, mean of each scan's median
  double seconds_without = 0.0;

  double ratio() const noexcept { return seconds_without > 0.0 ? seconds_with / seconds_without : 0.0; }
};

/// Replays two drives of the same path, the one with an obstacle and the one without, by turns; compares the scans that
/// have at least half of the most outliers with those of the other drive at the same places.
/// @param repeats  of each drive, at least 1
OutlierCost outlier_cost(const ExperimentSite& site, const RecordedDrive& with, const RecordedDrive& without,
                         int repeats, const Clock& clock);

}  // namespace slamicp
