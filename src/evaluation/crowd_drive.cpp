// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/evaluation/crowd_drive.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>

namespace slamicp {
namespace {

/// Somebody is near what the robot is about to drive.
bool is_somebody_ahead(const World& world, const SplinePath& path, double travelled, double stamp) {
  constexpr double ahead = 2.0;  // [m]
  constexpr double aside = 1.0;  // [m]
  constexpr double step = 0.1;   // [m]
  return std::any_of(world.people.begin(), world.people.end(), [&](const Person& person) {
    const Point2 place = pose_at(person, stamp).translation();
    for (double along = 0.0; along <= ahead; along += step)
      if ((path.at(std::min(travelled + along, path.length())).translation() - place).norm() < aside) return true;
    return false;
  });
}

}  // namespace

std::vector<CrowdSample> crowd_drive(const ExperimentSite& site, const CrowdPlan& plan) {
  const std::vector<Point2>& waypoints = route(site.world, "reference").waypoints;
  CrowdOptions crowd;
  crowd.people = plan.people;
  crowd.layout = plan.layout;
  crowd.seed = plan.seed;
  const World world = with_crowd(site.world, waypoints, crowd);
  DriveOptions drive;
  drive.speed = plan.speed;
  drive.seed = plan.seed;
  drive.lidar = real_hokuyo_utm30lx();
  drive.lidar.rate = plan.rate;
  const SimulatedRun run = simulate_drive(world, waypoints, drive);

  AgentOptions options;
  options.tracking.speed = plan.speed;
  Agent agent(site.map, site.path, options);
  agent.set_pose(run.truth.front().pose);
  std::vector<CrowdSample> samples;
  samples.reserve(run.scans.size());
  Decision last = Decision::ignore;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    const Cycle& cycle = agent.step(run.scans[k]);
    CrowdSample sample;
    sample.stamp = run.scans[k].stamp;
    sample.outliers = cycle.fix->outliers().size();
    sample.awareness = cycle.fix->quality.awareness;
    sample.error = distance(cycle.fix->pose, run.truth[k].pose).translation;
    sample.state = cycle.fix->quality.state;
    for (const Track& track : cycle.tracks)
      sample.moving += track.motion == TrackMotion::moving && track.state == TrackState::confirmed ? 1 : 0;
    sample.decision = cycle.decision;
    sample.false_stop = cycle.decision == Decision::stop && last != Decision::stop &&
                        !is_somebody_ahead(world, *site.path, cycle.tracking.travelled, sample.stamp);
    last = cycle.decision;
    samples.push_back(sample);
  }
  return samples;
}

double correlation(std::span<const double> a, std::span<const double> b) noexcept {
  const std::size_t count = std::min(a.size(), b.size());
  if (count == 0) return 0.0;
  double mean_a = 0.0, mean_b = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    mean_a += a[k] / static_cast<double>(count);
    mean_b += b[k] / static_cast<double>(count);
  }
  double both = 0.0, squares_a = 0.0, squares_b = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    both += (a[k] - mean_a) * (b[k] - mean_b);
    squares_a += (a[k] - mean_a) * (a[k] - mean_a);
    squares_b += (b[k] - mean_b) * (b[k] - mean_b);
  }
  const double scale = std::sqrt(squares_a * squares_b);
  return scale > 0.0 ? both / scale : 0.0;
}

}  // namespace slamicp
