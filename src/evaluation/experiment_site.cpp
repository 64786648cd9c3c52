// SPDX-License-Identifier: Apache-2.0
#include <slamicp/evaluation/experiment_site.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>
#include <slamicp/mapping/mapper.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp {

ExperimentSite explore_site(std::uint64_t seed) {
  ExperimentSite site;
  site.world = corridor_world();
  site.path = std::make_shared<const SplinePath>(route(site.world, "reference").waypoints);

  DriveOptions drive;
  drive.speed = 0.5;
  drive.seed = seed;
  drive.lidar = real_hokuyo_utm30lx();
  drive.lidar.rate = 20.0;  // half of the scans make the same map
  const SimulatedRun survey = simulate_drive(site.world, route(site.world, "survey").waypoints, drive);

  MapperOptions options;
  options.initial_pose = survey.truth.front().pose;
  options.insertion_distance = 0.013;  // to a few percent as many points as the paper's map has, 10,402
  options.keyframe_distance = 0.5;
  Mapper mapper(options);
  for (const LaserScan& scan : survey.scans) mapper.add(scan);
  site.map = mapper.refined_map();
  site.survey_scans = survey.scans.size();
  site.survey_error = absolute_error(mapper.trajectory(), survey.truth).translation;
  return site;
}

}  // namespace slamicp
