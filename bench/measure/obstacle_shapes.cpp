// SPDX-License-Identifier: Apache-2.0
// obstacles by what is made of them: sizes of the paper's twelve placements, small things beside walls, false ones,
// cost
//
// scripts/measure obstacle_shapes [--only placements|near_wall|clean|cost] [--runs 3]
//
// Placements: a drive along the reference route past each, things moved until they stand 0.10 m off all walls; asked
// are sides seen from end to end within 20 mm, radii within 10 mm where 90 deg of arc was seen, positions within 15 mm.
#include <slamicp/evaluation/experiment_site.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/obstacles/reconstruction.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

/// Where things of a placement stand: name, box or cylinder.
struct Thing {
  std::string name;
  std::optional<Box> box;
  std::optional<Cylinder> cylinder;

  Point2 centre() const { return box ? box->centre : cylinder->centre; }
};

std::vector<Thing> things_of(const PlacedObstacle& placed) {
  std::vector<Thing> things;
  for (const Box& box : placed.boxes) things.push_back({placed.name, box, {}});
  for (const Cylinder& cylinder : placed.cylinders) things.push_back({placed.name, {}, cylinder});
  if (things.size() > 1)
    for (std::size_t k = 0; k < things.size(); ++k) things[k].name += k == 0 ? " (1)" : " (2)";
  return things;
}

/// From a placement to the nearest wall [m].
double gap_to_walls(const World& world, const PlacedObstacle& placed) {
  double least = 1e9;
  for (const Box& box : placed.boxes)
    for (const Segment& side : sides(box))
      for (int k = 0; k <= 20; ++k)
        least = std::min(least, distance_to_walls(world, side.a + 0.05 * k * (side.b - side.a)));
  for (const Cylinder& cylinder : placed.cylinders)
    least = std::min(least, distance_to_walls(world, cylinder.centre) - cylinder.radius);
  return least;
}

void shift(PlacedObstacle& placed, const Vector<2>& by) {
  for (Box& box : placed.boxes) box.centre += by;
  for (Cylinder& cylinder : placed.cylinders) cylinder.centre += by;
}

/// The same thing, moved across the corridor until it stands so far off the walls.
PlacedObstacle with_gap(const World& world, PlacedObstacle placed, double gap) {
  const double middle = 1.25;
  const double y = placed.boxes.empty() ? placed.cylinders.front().centre.y() : placed.boxes.front().centre.y();
  const double inwards = y > middle ? -1.0 : 1.0;
  for (int step = 0; step < 1000 && gap_to_walls(world, placed) < gap; ++step) shift(placed, {0.0, 0.002 * inwards});
  return placed;
}

/// The same thing, moved to the wall on its side of the corridor, touching it.
PlacedObstacle at_wall(const World& world, PlacedObstacle placed) {
  const double middle = 1.25;
  const double y = placed.boxes.empty() ? placed.cylinders.front().centre.y() : placed.boxes.front().centre.y();
  const double outwards = y > middle ? 1.0 : -1.0;
  for (int step = 0; step < 1500 && gap_to_walls(world, placed) > 0.001; ++step) shift(placed, {0.0, 0.001 * outwards});
  return placed;
}

struct Drive {
  SeenThings seen;
  std::vector<Obstacle> rebuilt;
  std::size_t scans = 0;
};

LidarModel laser(double bias) {
  LidarModel lidar = hokuyo_utm30lx();
  lidar.rate = 20.0;
  lidar.bias = bias;
  return lidar;
}

Drive drive_past(const PlacedObstacle& placed, const LidarModel& lidar, std::uint64_t seed) {
  const World world = corridor_world();
  Random random(seed);
  const auto map = PointMap2::create(sample_map(world, random));
  DriveOptions options;
  options.seed = seed;
  options.lidar = lidar;
  const SimulatedRun run = simulate_drive(with_obstacle(world, placed), route(world, "reference").waypoints, options);
  Localizer localizer(map);
  localizer.set_pose(run.truth.front().pose);
  ObstacleFinder finder({.min_points = 5});
  Drive drive;
  for (const LaserScan& scan : run.scans) {
    const Fix& fix = localizer.update(scan);
    ++drive.scans;
    if (fix.usable()) drive.seen.add(fix, scan, finder.find(fix, scan));
  }
  drive.rebuilt = reconstruct_shapes(drive.seen, {.filter_radius = 0.02, .filter_neighbours = 10});
  return drive;
}

const Obstacle* nearest_to(const std::vector<Obstacle>& found, const Point2& place) {
  const Obstacle* best = nullptr;
  double least = 0.3;
  for (const Obstacle& obstacle : found) {
    const double off = (obstacle.shape.centre - place).norm();
    if (off >= least) continue;
    least = off;
    best = &obstacle;
  }
  return best;
}

/// The largest errors over some drives, in millimetres; negative: nothing to judge.
struct Errors {
  double width = -1.0, depth = -1.0, radius = -1.0, place = -1.0;
  int missed = 0, wrong_kind = 0, drives = 0;
  double arc_deg = 0.0;
  std::string last;

  void take(const Thing& thing, const Obstacle* found) {
    ++drives;
    if (found == nullptr) {
      ++missed;
      return;
    }
    const Shape& shape = found->shape;
    last = shape.brief();
    const bool is_side = thing.box && shape.kind == ShapeKind::line;
    if (!is_side && shape.kind != (thing.box ? ShapeKind::box : ShapeKind::circle)) {
      ++wrong_kind;
      return;
    }
    const auto worst = [](double& so_far, double is, double should) {
      so_far = std::max(so_far, 1e3 * std::abs(is - should));
    };
    if (is_side) return take_side(*thing.box, shape);
    if (thing.box && shape.width_seen) worst(width, shape.width, thing.box->width);
    if (thing.box && shape.depth_seen) worst(depth, shape.depth, thing.box->depth);
    if (thing.cylinder && shape.arc >= std::numbers::pi / 2.0) worst(radius, shape.radius, thing.cylinder->radius);
    arc_deg = deg_per_rad * shape.arc;
    worst(place, (shape.centre - thing.centre()).norm(), 0.0);
  }

  /// One side is all that was seen: the true one in its place.
  void take_side(const Box& box, const Shape& shape) {
    if (!shape.width_seen) return;
    double least = 1e9;
    bool is_width = false;
    for (const Segment& side : sides(box)) {
      const double off = (0.5 * (side.a + side.b) - shape.centre).norm();
      if (off >= least) continue;
      least = off;
      is_width = std::abs((side.b - side.a).norm() - box.width) < 1e-9;
    }
    double& length = is_width ? width : depth;
    length = std::max(length, 1e3 * std::abs(shape.width - (is_width ? box.width : box.depth)));
    place = std::max(place, 1e3 * least);
  }
};

std::string millimetres(double value) { return value < 0.0 ? "-" : text("%.1f", value); }

Json placements(const std::string& title, double bias, int runs,
                const std::function<PlacedObstacle(const World&, const PlacedObstacle&)>& place) {
  std::printf("%s, %d drives each; largest errors\n\n", title.c_str(), runs);
  Table table({"placement", "to the wall mm", "width mm", "depth mm", "radius mm", "place mm", "arc deg", "missed",
               "another kind", "the last one told"});
  Json results = Json::array();
  const World world = corridor_world();
  for (const PlacedObstacle& original : corridor_obstacles()) {
    const PlacedObstacle placed = place(world, original);
    const std::vector<Thing> things = things_of(placed);
    std::vector<Errors> errors(things.size());
    for (int run = 1; run <= runs; ++run) {
      const Drive drive = drive_past(placed, laser(bias), static_cast<std::uint64_t>(run));
      for (std::size_t k = 0; k < things.size(); ++k)
        errors[k].take(things[k], nearest_to(drive.rebuilt, things[k].centre()));
    }
    for (std::size_t k = 0; k < things.size(); ++k) {
      const Errors& e = errors[k];
      table.add({things[k].name, text("%.0f", 1e3 * gap_to_walls(world, placed)), millimetres(e.width),
                 millimetres(e.depth), millimetres(e.radius), millimetres(e.place), text("%.0f", e.arc_deg),
                 text("%d of %d", e.missed, e.drives), text("%d", e.wrong_kind), e.last});
      results.push_back({{"placement", things[k].name},
                         {"width_mm", e.width},
                         {"depth_mm", e.depth},
                         {"radius_mm", e.radius},
                         {"place_mm", e.place},
                         {"missed", e.missed},
                         {"another_kind", e.wrong_kind}});
    }
  }
  table.print();
  return results;
}

/// One way of finding obstacles.
struct Setting {
  std::string name;
  LocalizerOptions options;
};

std::vector<Setting> settings() {
  LocalizerOptions paper;
  paper.outputs.strays = false;
  return {{"O_t 0.3 m, the paper's", paper}, {"default, from the noise", {}}};
}

Json near_wall(int runs) {
  std::printf("A cylinder of 42 mm radius beside a wall, seen from every 0.5 m of the reference route, by range\n\n");
  Table table({"to the wall", "obstacles by", "found within 3 m", "3 to 5 m", "5 to 8 m"});
  Json results = Json::array();
  for (const double gap : {0.15, 0.20})
    for (const Setting& setting : settings()) {
      std::array<int, 3> seen{}, found{};
      for (int run = 1; run <= runs; ++run) {
        const World world = corridor_world();
        Random random(static_cast<std::uint64_t>(run));
        const auto map = PointMap2::create(sample_map(world, random));
        for (const double x : {9.6, 12.3, 15.5, 18.2, 21.2}) {
          const Cylinder thing{{x, gap + 0.042}, 0.042};
          const World with = with_cylinder(world, thing);
          for (double at = 6.0; at < 23.0; at += 0.5) {
            const Pose2 pose{at, 1.25, 0.0};
            const LaserScan scanned = scan(with, pose, hokuyo_utm30lx(), random);
            std::vector<double> ranges, without;
            true_ranges(with, pose, hokuyo_utm30lx(), ranges);
            true_ranges(world, pose, hokuyo_utm30lx(), without);
            int beams = 0;
            for (std::size_t i = 0; i < ranges.size(); ++i) beams += ranges[i] < without[i] - 1e-6;
            if (beams < 3) continue;  // three points make an obstacle
            const double range = (thing.centre - pose.translation()).norm();
            const std::size_t bin = range < 3.0 ? 0 : range < 5.0 ? 1 : 2;
            if (range > 8.0) continue;
            Localizer localizer(map, setting.options);
            localizer.set_pose(pose);
            ++seen[bin];
            for (const Obstacle& obstacle : find_obstacles(localizer.update(scanned), scanned))
              if ((obstacle.shape.centre - thing.centre).norm() < 0.15) {
                ++found[bin];
                break;
              }
          }
        }
      }
      std::vector<std::string> row{text("%.0f mm", 1e3 * gap), setting.name};
      Json result = {{"gap_m", gap}, {"setting", setting.name}};
      for (std::size_t bin = 0; bin < 3; ++bin) {
        row.push_back(text("%d of %d", found[bin], seen[bin]));
        result["bins"].push_back({found[bin], seen[bin]});
      }
      table.add(row);
      results.push_back(result);
    }
  table.print();
  return results;
}

Json clean(int runs) {
  std::printf("Obstacles where there are none: drives along the reference route, nothing new in the corridor\n\n");
  Table table({"map and lidar", "obstacles by", "scans", "obstacles", "scans with one", "at three scans in a row"});
  Json results = Json::array();
  for (const bool real : {false, true})
    for (const Setting& setting : settings()) {
      std::size_t scans = 0, obstacles = 0, with_one = 0, confirmed = 0;
      for (int run = 1; run <= runs; ++run) {
        const auto seed = static_cast<std::uint64_t>(run);
        const ExperimentSite site = real ? explore_site(seed) : ExperimentSite{};
        const World world = corridor_world();
        Random random(seed);
        const auto map = real ? site.map : PointMap2::create(sample_map(world, random));
        DriveOptions options;
        options.seed = seed + 1000;
        if (real) options.lidar = real_hokuyo_utm30lx();
        options.lidar.rate = 20.0;
        const SimulatedRun drive = simulate_drive(world, route(world, "reference").waypoints, options);
        Localizer localizer(map, setting.options);
        localizer.set_pose(drive.truth.front().pose);
        ObstacleFinder finder;
        std::vector<std::pair<Point2, int>> suspects;
        for (const LaserScan& scanned : drive.scans) {
          const Fix& fix = localizer.update(scanned);
          const auto found = finder.find(fix, scanned);
          ++scans;
          obstacles += found.size();
          with_one += found.empty() ? 0U : 1U;
          std::vector<std::pair<Point2, int>> now;
          for (const Obstacle& obstacle : found) {
            int in_a_row = 1;
            for (const auto& [place, before] : suspects)
              if ((place - obstacle.shape.centre).norm() < 0.3) in_a_row = before + 1;
            confirmed += in_a_row == 3 ? 1U : 0U;
            now.emplace_back(obstacle.shape.centre, in_a_row);
          }
          suspects = now;
        }
      }
      table.add({real ? "own map, real lidar" : "surveyed map, zero-mean noise", setting.name, text("%zu", scans),
                 text("%zu", obstacles), text("%zu", with_one), text("%zu", confirmed)});
      results.push_back({{"real", real},
                         {"setting", setting.name},
                         {"scans", scans},
                         {"obstacles", obstacles},
                         {"confirmed", confirmed}});
    }
  table.print();
  return results;
}

/// The bare match, the match with its lists, and the obstacles on top, scan by scan in turns.
Json cost() {
  std::printf("Cost of a scan, in turns; medians. The bare match hands out the pose only\n\n");
  Table table({"placement", "most outliers", "bare match us", "with all lists us", "obstacles us",
               "match, lists and obstacles / bare match", "at most 123 outliers, 99 %"});
  Json results = Json::array();
  const World world = corridor_world();
  Random random(1);
  const auto map = PointMap2::create(sample_map(world, random));
  for (const char* name : {"A1", "A2", "B2", "C2", "D2"}) {
    DriveOptions options;
    options.lidar.rate = 5.0;
    const SimulatedRun run = simulate_drive(corridor_world_with(name), route(world, "reference").waypoints, options);
    Localizer localizer(map);
    localizer.set_pose(run.truth.front().pose);
    Icp<2> bare, full;
    ObstacleFinder finder;
    finder.reserve(32, 1081);
    std::vector<double> bare_us, full_us, finder_us, ratios;
    std::size_t most = 0;
    const Outputs wanted{.outlier_indices = true, .outliers_in_map = true, .strays = true};
    for (const LaserScan& scanned : run.scans) {
      const Fix& fix = localizer.update(scanned);
      const Pose2 guess = fix.pose * Pose2{0.02, 0.01, 0.01};
      double best_bare = 1e9, best_full = 1e9, best_finder = 1e9;
      for (int round = 0; round < 5; ++round) {
        const Stopwatch for_bare;
        bare.align(map->indexed(), fix.scan.in_robot, guess);
        best_bare = std::min(best_bare, for_bare.microseconds());
        const Stopwatch for_full;
        full.align(map->indexed(), fix.scan.in_robot, guess, wanted);
        best_full = std::min(best_full, for_full.microseconds());
        const Stopwatch for_finder;
        finder.find(fix, scanned);
        best_finder = std::min(best_finder, for_finder.microseconds());
      }
      most = std::max(most, fix.outliers().size());
      if (fix.outliers().empty()) continue;
      bare_us.push_back(best_bare);
      full_us.push_back(best_full);
      finder_us.push_back(best_finder);
      ratios.push_back((best_full + best_finder) / best_bare);
    }
    table.add({name, text("%zu", most), text("%.1f", quantile(bare_us, 0.5)), text("%.1f", quantile(full_us, 0.5)),
               text("%.1f", quantile(finder_us, 0.5)), text("%.2f", quantile(ratios, 0.5)),
               text("%.2f", quantile(ratios, 0.99))});
    results.push_back({{"placement", name},
                       {"most_outliers", most},
                       {"bare_us", quantile(bare_us, 0.5)},
                       {"full_us", quantile(full_us, 0.5)},
                       {"obstacles_us", quantile(finder_us, 0.5)},
                       {"ratio", quantile(ratios, 0.5)},
                       {"ratio_p99", quantile(ratios, 0.99)}});
  }
  table.print();
  return results;
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp;
  using namespace slamicp::measure;
  return run([&] {
    const Words words(argc, argv, {{"--only", ""}, {"--runs", "3"}});
    const int runs = static_cast<int>(words.number("--runs"));
    const auto wants = [&](const char* name) { return words["--only"].empty() || words["--only"] == name; };
    Json results;
    if (wants("placements")) {
      const auto off_walls = [](const World& world, const PlacedObstacle& placed) {
        return with_gap(world, placed, 0.10);
      };
      results["zero_mean"] = placements("Zero-mean noise, 10 mm", 0.0, runs, off_walls);
      results["biased"] = placements("The same with 10 mm of systematic range error", 0.01, runs, off_walls);
      results["at_wall"] = placements("Zero-mean noise, touching the wall", 0.0, runs, at_wall);
    }
    if (wants("near_wall")) results["near_wall"] = near_wall(runs);
    if (wants("clean")) results["clean"] = clean(runs);
    if (wants("cost")) results["cost"] = cost();
    save_results("obstacle_shapes", results);
  });
}
