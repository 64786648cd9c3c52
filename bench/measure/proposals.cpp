// SPDX-License-Identifier: Apache-2.0
// what a run proposes to change in a map: a shelf moved between two runs, people walking about, nothing else changed
//
// scripts/measure proposals [--runs 100] [--people 4] [--first 1]
//
// Asked is that both ends of the move are proposed and nothing else, people least of all. Each run has its own place of
// the shelf before and after, its own map noise and its own people, in each layout but that of people who stand.
#include <slamicp/localization/localizer.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/obstacles/map_changes.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/crowd.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

constexpr double width = 0.8;
constexpr double depth = 0.3;

/// A place for the shelf beside the way, off the walls and out of the robot's way.
Box shelf_place(const World& world, const SplinePath& path, Random& random) {
  for (;;) {
    const bool is_below = random.uniform() < 0.5;
    const Box shelf{{random.uniform(8.0, 16.0), is_below ? 0.05 + 0.5 * depth : 2.45 - 0.5 * depth}, width, depth, 0.0};
    double to_walls = 1e9, to_path = 1e9;
    for (const Segment& side : sides(shelf))
      for (int k = 0; k <= 10; ++k)
        to_walls = std::min(to_walls, distance_to_walls(world, side.a + 0.1 * k * (side.b - side.a)));
    for (const Point2& place : path.places()) to_path = std::min(to_path, distance(shelf, place));
    if (to_walls > 0.03 && to_path > 0.4) return shelf;
  }
}

struct Outcome {
  bool added = false, removed = false;
  int others = 0;
  std::string what;  // the move, and the others
};

Outcome one_run(std::uint64_t seed, int people, CrowdLayout layout) {
  const World world = corridor_world();
  const std::vector<Point2>& waypoints = route(world, "reference").waypoints;
  const SplinePath path(waypoints);
  Random random(seed);
  const Box before = shelf_place(world, path, random);
  Box now = shelf_place(world, path, random);
  while ((now.centre - before.centre).norm() < 1.5) now = shelf_place(world, path, random);
  World as_mapped = world;
  for (const Segment& side : sides(before)) as_mapped.walls.push_back(side);
  const auto map = PointMap2::create(sample_map(as_mapped, random));
  World as_it_is = with_box(world, now);
  if (people > 0) as_it_is = with_crowd(as_it_is, waypoints, {.people = people, .layout = layout, .seed = seed});
  DriveOptions options;
  options.seed = seed;
  options.lidar.rate = 10.0;
  const SimulatedRun run = simulate_drive(as_it_is, waypoints, options);

  Localizer localizer(map);
  localizer.set_pose(run.truth.front().pose);
  ObstacleFinder finder;
  MapChanges changes;
  for (const LaserScan& scan : run.scans) {
    const Fix& fix = localizer.update(scan);
    changes.add(fix, scan, finder.find(fix, scan));
  }
  Outcome outcome;
  outcome.what =
      text("shelf from %.2f, %.2f to %.2f, %.2f", before.centre.x(), before.centre.y(), now.centre.x(), now.centre.y());
  for (const ProposedChange& change : changes.proposals()) {
    const bool adds = change.kind == ProposedChange::Kind::add;
    const double off = distance(adds ? now : before, change.box.centre);
    bool& told = adds ? outcome.added : outcome.removed;
    if (off < 0.15) {
      told = true;
    } else {
      ++outcome.others;
      outcome.what += "; " + change.brief();
    }
  }
  return outcome;
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp;
  using namespace slamicp::measure;
  return run([&] {
    const Words words(argc, argv, {{"--runs", "100"}, {"--people", "4"}, {"--first", "1"}});
    const int runs = static_cast<int>(words.number("--runs"));
    const int people = static_cast<int>(words.number("--people"));
    constexpr CrowdLayout layouts[] = {CrowdLayout::crossing, CrowdLayout::along, CrowdLayout::random_walk};
    int added = 0, removed = 0, clean = 0;
    Json results = Json::array();
    for (int k = 0; k < runs; ++k) {
      const auto seed = static_cast<std::uint64_t>(k) + static_cast<std::uint64_t>(words.number("--first"));
      const Outcome outcome = one_run(seed, people, layouts[(seed - 1) % 3]);
      added += outcome.added;
      removed += outcome.removed;
      clean += outcome.others == 0;
      if (!outcome.added || !outcome.removed || outcome.others > 0)
        std::printf("seed %zu: to add %s, to remove %s, others %d: %s\n", static_cast<std::size_t>(seed),
                    outcome.added ? "yes" : "NO", outcome.removed ? "yes" : "NO", outcome.others, outcome.what.c_str());
      results.push_back(
          {{"seed", seed}, {"added", outcome.added}, {"removed", outcome.removed}, {"others", outcome.others}});
    }
    Table table({"runs", "people", "new place proposed", "old place proposed", "nothing else"});
    table.add({text("%d", runs), text("%d", people), text("%d", added), text("%d", removed), text("%d", clean)});
    table.print();
    save_results("proposals", results);
  });
}
