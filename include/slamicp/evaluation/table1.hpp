// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <slamicp/evaluation/agent_replay.hpp>

namespace slamicp {

/// A row of the paper's Table 1.
struct PaperTable1Row {
  const char* obstacle;
  int most_outliers;
  double original_ms;  ///< a cycle of the agent with LIBICP
  double improved_ms;  ///< a cycle of the agent with SLAMICP
};

/// The twelve rows, A1 to D3.
std::span<const PaperTable1Row> paper_table1() noexcept;

struct Table1Options {
  std::uint64_t seed = 1;  ///< of the first run; each further one has the next
  int runs = 3;            ///< with each obstacle, at least 1
  std::size_t every = 75;  ///< of so many scans the agents are shown one, at least 1; the original ones are slow

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// The mean time of a cycle [s] of an agent, its index built once and built anew for each scan.
struct AgentTimes {
  double once = 0.0;
  double rebuilt = 0.0;
};

/// Our row of Table 1.
struct Table1Row {
  std::string obstacle;              ///< empty: none
  std::size_t most_outliers = 0;     ///< in a scan, of all scans
  std::size_t scans = 0;             ///< driven
  std::size_t replayed = 0;          ///< of them shown to the agents
  AgentTimes original;               ///< Figure 9a
  AgentTimes improved;               ///< Figure 9b
  double original_outliers = 0.0;    ///< a replayed scan, by the original agent
  double improved_outliers = 0.0;    ///< by the improved one
  std::vector<Sighting> sightings;   ///< one a run
  std::size_t runs_finished = 0;     ///< that came to the end of the path
  std::size_t cycles_held_back = 0;  ///< in which the agent slowed down or stopped

  /// Every run found it, within `seconds` of when it was due, where it was.
  bool found_within(double seconds) const noexcept;
};

/// Drives with the obstacle, then shows the same scans to both agents by turns. Throws Error with options.problem().
Table1Row table1_row(const ExperimentSite& site, const std::string& obstacle, const Table1Options& options,
                     const Clock& clock);

}  // namespace slamicp
