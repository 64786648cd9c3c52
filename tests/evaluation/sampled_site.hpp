// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/evaluation/experiment_site.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp {

/// A site whose map is sampled from its walls: quicker than an exploration, and true.
inline ExperimentSite sampled_site() {
  ExperimentSite site;
  site.world = corridor_world();
  site.path = std::make_shared<const SplinePath>(route(site.world, "reference").waypoints);
  Random random(1);
  site.map = PointMap2::create(sample_map(site.world, random));
  return site;
}

}  // namespace slamicp
