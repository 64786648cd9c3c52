// SPDX-License-Identifier: Apache-2.0
// slamicp demo: the main job on the embedded world. A robot explores a corridor and maps it; later something stands in
// its way; it drives through again, knows where it is, and finds what is new.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/trajectory_file.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/mapping/mapper.hpp>
#include <slamicp/obstacles/reconstruction.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>

#include "output.hpp"
#include "report.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct DemoWords {
  std::string out = "slamicp-demo", obstacle = "A1", json;
  std::uint64_t seed = 1;
};

SimulatedRun drive_through(const World& world, const char* way, const DriveOptions& options) {
  return simulate_drive(world, route(world, way).waypoints, options);
}

PointMap2::Pointer explore(const SimulatedRun& run, Trajectory& estimate) {
  MapperOptions options;
  options.initial_pose = run.truth.front().pose;  // so that the map's frame is the world's, and errors can be told
  options.insertion_distance = 0.012;             // a fine map, about 10,000 points
  options.keyframe_distance = 0.5;
  Mapper mapper(options);
  Progress progress("mapping", run.scans.size());
  for (const LaserScan& scan : run.scans) {
    mapper.add(scan);
    progress.step();
  }
  estimate = mapper.trajectory();
  return mapper.refined_map();
}

RunRecord localize(const SimulatedRun& run, const PointMap2::Pointer& map, const Pose2& start) {
  LocalizerOptions options;
  options.outlier_distance = 0.1;  // with 1 cm of noise; the paper's 0.3 m hides small things near walls
  Localizer localizer(map, options);
  localizer.set_pose(start);
  RunRecord record;
  record.map = map;
  record.initial_pose = start;
  Progress progress("localizing", run.scans.size());
  for (const LaserScan& scan : run.scans) {
    const Stopwatch watch;
    const Fix& fix = localizer.update(scan);
    record.add(fix, watch.microseconds());
    progress.step();
  }
  return record;
}

/// The box as it stands, to draw and print beside what was found.
Box true_box(const std::string& name) {
  const PlacedObstacle placed = corridor_obstacle(name);
  if (placed.boxes.empty()) throw Error("'" + name + "' is no box", "--obstacle", "the demo places A1, A2 or A3");
  return placed.boxes.front();
}

void save_pictures(const std::filesystem::path& folder, const RunRecord& record, const std::vector<Obstacle>& found,
                   const Box& standing) {
  Picture map({.title = "the map: outliers only, so walls stay thin"});
  map.points(record.map->points(), colours::map, 0.9, std::to_string(record.map->size()) + " map points");
  Picture run = draw_run(record, "localized in the map; what the map does not know is red");
  std::vector<Picture::Segment> outline;
  for (const Segment& side : sides(standing)) outline.push_back({side.a, side.b});
  run.segments(outline, colours::obstacle, 1.2, "the obstacle as it stands");
  for (const Obstacle& obstacle : found)
    run.label(obstacle.box.centre + Point2(-1.2, -1.8), "found: " + obstacle.brief());
  for (const char* ending : picture_endings()) {
    map.save(folder / (std::string("map") + ending));
    run.save(folder / (std::string("run") + ending));
  }
}

void run(const DemoWords& words) {
  const std::filesystem::path folder = file_named(words.out);
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw Error("the folder cannot be made: " + problem.message(), words.out, "give another one with --out");
  const Talk talk(words.json);

  // The first visit: nothing in the way, no map yet.
  const World corridor = corridor_world();
  DriveOptions drive;
  drive.seed = words.seed;
  drive.speed = 0.5;
  drive.lidar.rate = 20.0;
  const SimulatedRun exploration = drive_through(corridor, "survey", drive);
  Trajectory mapped;
  const PointMap2::Pointer map = explore(exploration, mapped);
  const TrajectoryError map_error = absolute_error(mapped, exploration.truth);
  talk(format("map       %zu points from %zu scans; path error %.1f mm mean, %.1f mm largest", map->size(),
              exploration.scans.size(), 1e3 * map_error.translation.mean, 1e3 * map_error.translation.max));

  // The second visit: something stands there.
  drive.seed = words.seed + 1;
  drive.lidar.rate = 40.0;
  const SimulatedRun visit = drive_through(corridor_world_with(words.obstacle), "reference", drive);
  const Trajectory& truth = visit.truth;
  RunRecord record = localize(visit, map, truth.front().pose);
  record.log = "the robot's second visit";
  record.map_file = "map.pcd";
  const TrajectoryError error = absolute_error(record.trajectory, truth);
  talk(format("pose      error %.1f mm, %.3f deg mean; %.1f mm, %.3f deg at 95 %%, over %zu scans",
              1e3 * error.translation.mean, deg_per_rad * error.rotation.mean, 1e3 * error.translation.p95,
              deg_per_rad * error.rotation.p95, truth.size()));
  talk(format("outliers  %.1f a scan, %.0f at most (at least 0.10 m from every map point)",
              record.mean(&ScanRecord::outliers), record.largest(&ScanRecord::outliers)));

  const Box standing = true_box(words.obstacle);
  const std::vector<Obstacle> found = reconstruct_obstacles(record.outliers);
  if (found.empty()) talk("obstacle  none found");
  for (const Obstacle& obstacle : found) talk("obstacle  " + obstacle.brief() + " over the run");
  talk(format("  truth   %.2f m x %.2f m at %.2f m, %.2f m", standing.width, standing.depth, standing.centre.x(),
              standing.centre.y()));
  talk(format("time      %.0f us a scan, pose, inliers and outliers (median; 99 %% below %.0f us)",
              record.quantile(&ScanRecord::time_us, 0.5), record.quantile(&ScanRecord::time_us, 0.99)));

  save_map(folder / "map.pcd", *map);
  save_trajectory(folder / "run.tum", record.trajectory);
  save_trajectory(folder / "truth.tum", truth);
  save_pictures(folder, record, found, standing);
  write_report((folder / "report.html").string(), record);
  talk(format("written   %s/{map,run}.{svg,png}, report.html, map.pcd, run.tum, truth.tum", words.out.c_str()));

  Json obstacles = Json::array();
  for (const Obstacle& obstacle : found)
    obstacles.push_back({{"x", obstacle.box.centre.x()},
                         {"y", obstacle.box.centre.y()},
                         {"width", obstacle.box.width},
                         {"depth", obstacle.box.depth},
                         {"heading", obstacle.box.heading},
                         {"points", obstacle.points.size()}});
  write_json(
      words.json,
      {{"verb", "demo"},
       {"map_points", map->size()},
       {"scans", truth.size()},
       {"map_error", to_json(map_error.translation)},
       {"translation_error", to_json(error.translation)},
       {"rotation_error", to_json(error.rotation)},
       {"outliers_mean", record.mean(&ScanRecord::outliers)},
       {"outliers_max", record.largest(&ScanRecord::outliers)},
       {"obstacles", obstacles},
       {"true_obstacle",
        {{"x", standing.centre.x()}, {"y", standing.centre.y()}, {"width", standing.width}, {"depth", standing.depth}}},
       {"time_us",
        {{"median", record.quantile(&ScanRecord::time_us, 0.5)},
         {"p99", record.quantile(&ScanRecord::time_us, 0.99)}}}});
}

}  // namespace

void add_demo(CLI::App& program) {
  CLI::App* verb =
      program.add_subcommand("demo", "the main job on the embedded world: map, localize, find the obstacle");
  const auto words = std::make_shared<DemoWords>();
  verb->add_option("--out", words->out, "folder for report, pictures, map and trajectories")
      ->capture_default_str()
      ->type_name("DIR");
  verb->add_option("--obstacle", words->obstacle, "where the box stands")->capture_default_str()->type_name("A1..A3");
  verb->add_option("--seed", words->seed, "of all noise")->capture_default_str();
  add_json(*verb, words->json);
  add_example(*verb, "slamicp demo --out demo");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::command
