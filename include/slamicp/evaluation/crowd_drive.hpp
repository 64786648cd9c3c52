// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <slamicp/agent/agent.hpp>
#include <slamicp/evaluation/experiment_site.hpp>
#include <slamicp/simulation/crowd.hpp>

namespace slamicp {

/// Which drive through people to make.
struct CrowdPlan {
  int people = 0;
  CrowdLayout layout = CrowdLayout::crossing;
  double speed = 0.5;      ///< along the path [m/s], > 0
  double rate = 10.0;      ///< scans a second [Hz], > 0
  std::uint64_t seed = 1;  ///< of the people and all noise
};

/// One control cycle among people.
struct CrowdSample {
  double stamp = 0.0;  ///< [s]
  std::size_t outliers = 0;
  double awareness = 1.0;  ///< Quality::awareness
  double error = 0.0;      ///< of the position [m]
  TrackingState state = TrackingState::tracking;
  std::size_t moving = 0;  ///< confirmed tracks that move
  Decision decision = Decision::ignore;
  bool false_stop = false;  ///< it begins to stop here, and nobody is within 1 m of the next 2 m of its way
};

/// Shows an agent the scans of a robot that drives the site's path at constant speed through people, who mind it as
/// little as it minds them: what it decides moves nothing, so that every drive sees all of the path. The same arguments
/// give the same samples. Throws Error where the people find no room.
std::vector<CrowdSample> crowd_drive(const ExperimentSite& site, const CrowdPlan& plan);

/// Pearson's coefficient of as many values each, in [-1, 1]; 0 where one of them does not change.
double correlation(std::span<const double> a, std::span<const double> b) noexcept;

}  // namespace slamicp
