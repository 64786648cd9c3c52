// SPDX-License-Identifier: Apache-2.0
// What stands in a corridor that its map does not know: class, shape, and what a whole drive says about it.
#include <cstdio>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/map_changes.hpp>
#include <slamicp/obstacles/reconstruction.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

int main() {
  // The paper's corridor with its box A1, and a map from before it came.
  const slamicp::World world = slamicp::corridor_world();
  slamicp::Random random(1);
  const auto map = slamicp::PointMap2::create(slamicp::sample_map(world, random));
  slamicp::DriveOptions drive;
  drive.lidar.rate = 10.0;
  const slamicp::SimulatedRun run =
      slamicp::simulate_drive(slamicp::corridor_world_with("A1"), slamicp::route(world, "reference").waypoints, drive);

  slamicp::Localizer localizer(map);
  localizer.set_pose(run.truth.front().pose);
  slamicp::ObstacleFinder finder;  // keeps its memory
  slamicp::SeenThings seen;
  slamicp::MapChanges changes;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    const slamicp::Fix& fix = localizer.update(run.scans[k]);
    const auto obstacles = finder.find(fix, run.scans[k]);
    seen.add(fix, run.scans[k], obstacles);
    changes.add(fix, run.scans[k], obstacles);
    if (k % 60 == 0)  // every 6 s
      for (const slamicp::Obstacle& obstacle : obstacles)
        std::printf("%5.1f s  %-8s  %s\n", fix.stamp, to_string(obstacle.ray_class), obstacle.shape.brief().c_str());
  }
  for (const slamicp::Obstacle& thing : slamicp::reconstruct_shapes(seen))
    std::printf("the drive  %s\n", thing.shape.brief().c_str());
  for (const slamicp::ProposedChange& change : changes.proposals()) std::puts(change.brief().c_str());
}
