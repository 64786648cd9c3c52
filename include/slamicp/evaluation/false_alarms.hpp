// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <slamicp/agent/agent.hpp>

namespace slamicp {

struct FalseAlarmOptions {
  double same_place = 0.3;  ///< an obstacle this near to where one was before is the same one [m], > 0
  int confirmations = 3;    ///< scans in a row that must show it, at least 1
  int releases = 5;         ///< scans in a row without it before it is gone, at least 1

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// Counts what an agent sees and does because of obstacles that are not there: give it the cycles of a drive through a
/// world that is as its map says.
class FalseAlarms {
 public:
  /// Throws Error with options.problem().
  explicit FalseAlarms(const FalseAlarmOptions& options = {});

  void add(const Cycle& cycle);
  /// The next cycle is of another drive.
  void next_drive() noexcept;

  /// Times the agent decided to stop, or to go slower, after it had not.
  std::size_t stops() const noexcept { return stops_; }
  std::size_t slow_downs() const noexcept { return slow_downs_; }
  /// Where obstacles were confirmed, one entry each time, in the map [m].
  const PointCloud2& confirmed() const noexcept { return confirmed_; }
  /// Obstacles of single scans, confirmed or not.
  std::size_t seen() const noexcept { return seen_; }

 private:
  struct Suspect {
    Point2 place;
    int in_a_row;
    int missed;
    bool here;
  };

  FalseAlarmOptions options_;
  std::vector<Suspect> suspects_;
  Decision last_ = Decision::ignore;
  std::size_t stops_ = 0;
  std::size_t slow_downs_ = 0;
  std::size_t seen_ = 0;
  PointCloud2 confirmed_;
};

}  // namespace slamicp
