// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <slamicp/evaluation/error_statistics.hpp>
#include <slamicp/map/point_map.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// Where the paper's experiments are repeated: the simulated corridor, a robot's own map of it, and the reference path
/// (the paper, section 2.5).
struct ExperimentSite {
  World world;             ///< without obstacles
  PointMap2::Pointer map;  ///< in the world's frame
  std::shared_ptr<const SplinePath> path;
  std::size_t survey_scans = 0;  ///< that the map was made of
  ErrorStatistics survey_error;  ///< of the poses that it was made at [m]
};

/// Sends a robot with a real Hokuyo through corridor_world() along the route "survey", and makes the map of what it
/// sees by our own Mapper. Its first pose is given, so that the map's frame is the world's. The same seed gives the
/// same site.
ExperimentSite explore_site(std::uint64_t seed);

}  // namespace slamicp
