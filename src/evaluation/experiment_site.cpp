// SPDX-License-Identifier: Apache-2.0
#include <slamicp/evaluation/experiment_site.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>
#include <slamicp/mapping/mapper.hpp>
#include <slamicp/search/kd_tree.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp {
namespace {

// A map point needs so many others within so far [m].
constexpr std::size_t support = 3;
constexpr double support_radius = 0.05;

/// Without the points that stand alone: readings that a real lidar mixes of near and far beside edges, which no later
/// scan sees again.
PointCloud2 supported(PointView<2> points) {
  const PointCloud2 cloud = to_cloud<2>(points);
  const KdTree<2> tree(cloud);
  std::vector<Neighbour> around(support + 1);  // itself, too
  PointCloud2 kept;
  for (const Point2& point : cloud)
    if (tree.nearest_k(point, support_radius, around) == around.size()) kept.push_back(point);
  return kept;
}

}  // namespace

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
  site.map = PointMap2::create(supported(mapper.refined_map()->points()));
  site.survey_scans = survey.scans.size();
  site.survey_error = absolute_error(mapper.trajectory(), survey.truth).translation;
  return site;
}

}  // namespace slamicp
