// SPDX-License-Identifier: Apache-2.0
// slamicp map: a map from a log.
#include <memory>

#include <slamicp/error.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/occupancy_map_file.hpp>
#include <slamicp/io/picture.hpp>
#include <slamicp/io/trajectory_file.hpp>
#include <slamicp/map/grid_builder.hpp>
#include <slamicp/mapping/mapper.hpp>

#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct MapWords {
  std::string log, out, trajectory, picture, json;
  ScanLogOptions reading;
  MatchOptions match;
  MotionOptions motion;
  MapperOptions mapper;
  double resolution = GridOptions{}.resolution;
  bool all_points = false;
  bool raw = false;
};

MapperOptions mapper_options(const MapWords& words) {
  MapperOptions options = words.mapper;
  options.method = words.match.method;
  options.max_correspondence_distance = words.match.max_correspondence_distance;
  options.max_iterations = words.match.max_iterations;
  options.ranges = words.match.ranges;
  options.use_odometry = words.motion.use_odometry;
  options.deskew = words.motion.deskew;
  options.surfaces.threads = words.match.threads;
  options.update = words.all_points ? MapUpdate::all_points : MapUpdate::outliers;
  return options;
}

void draw(const MapWords& words, const Mapper& mapper, const PointMap2& map) {
  Picture picture({.title = "map of " + words.log});
  picture.points(map.points(), colours::map, 1.0, std::to_string(map.size()) + " map points");
  picture.path(mapper.trajectory(), colours::path, 1.2, "path");
  picture.robot(mapper.trajectory().back().pose, 0.25, colours::robot, "robot at the end");
  picture.save(file_named(words.picture));
}

/// The map as it is asked for: points, or cells that the scans found occupied and free.
void save(const MapWords& words, const PointMap2& map, const GridBuilder& builder, Json& summary) {
  if (!is_map_server(words.out)) return save_map(file_named(words.out), map);
  const OccupancyGrid grid = builder.grid();
  const CellCounts counts = count_cells(grid);
  save_occupancy_map(file_named(words.out), grid);
  summary["cells"] = {{"occupied", counts.occupied}, {"free", counts.free}, {"unknown", counts.unknown}};
}

void run(const MapWords& words) {
  const ScanLog log = open_scan_log(file_named(words.log), words.reading);
  warn(log.warnings);
  Mapper mapper(mapper_options(words));
  GridBuilder builder({.grid = {.resolution = words.resolution}});
  const bool wants_cells = is_map_server(words.out);
  const Stopwatch watch;
  {
    Progress progress("mapping", log.size());
    for (const LaserScan& scan : log) {
      const Fix& fix = mapper.add(scan);
      if (wants_cells && fix.usable()) builder.add(fix.scan.in_robot, scan.T_robot_laser.translation(), fix.pose);
      progress.step();
    }
  }
  const double seconds = watch.microseconds() * 1e-6;
  if (!mapper.map())
    throw Error("no scan has a return within the ranges", words.log, "raise --max-range, or see 'slamicp info'");

  const PointMap2::Pointer map = words.raw ? mapper.map() : mapper.refined_map();
  Json summary{{"verb", "map"},
               {"log", words.log},
               {"map", words.out},
               {"scans", log.size()},
               {"map_points", map->size()},
               {"keyframes", mapper.keyframes()},
               {"unmatched_scans", mapper.unmatched()},
               {"seconds", seconds},
               {"last_pose", to_json(mapper.trajectory().back().pose)}};
  save(words, *map, builder, summary);
  if (!words.trajectory.empty()) save_trajectory(file_named(words.trajectory), mapper.trajectory());
  if (!words.picture.empty()) draw(words, mapper, *map);
  write_json(words.json, summary);
  const Talk talk(words.json);
  talk(format("%zu scans, %d of them added to the map, %d unmatched; %zu map points in %.1f s -> %s", log.size(),
              mapper.keyframes(), mapper.unmatched(), map->size(), seconds, words.out.c_str()));
}

}  // namespace

void add_map(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("map", "SLAM by scan matching: a map from a log");
  const auto words = std::make_shared<MapWords>();
  verb->add_option("LOG", words->log, std::string("laser log: ") + log_words)->required();
  verb->add_option("--out", words->out, std::string("the map: ") + map_words)->required()->type_name("MAP");
  verb->add_option("--trajectory", words->trajectory, "poses T_map_robot, a line a scan")->type_name("TUM");
  verb->add_option("--picture", words->picture, "map and path")->type_name("FILE.svg|.png");
  add_resolution(*verb, words->resolution);
  add_motion_options(*verb, words->motion);
  add_match_options(*verb, words->match, words->mapper.max_correspondence_distance);
  words->match.max_iterations = words->mapper.max_iterations;
  verb->get_option("--max-iterations")->capture_default_str();
  verb->add_option("--outlier-distance", words->mapper.insertion_distance,
                   "points at least this far from the map are new and added: its resolution [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--keyframe-distance", words->mapper.keyframe_distance, "the map grows after moving this far [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--guess-share", words->mapper.guess_share,
                   "how much the prediction itself counts, as a share of the pairs: keeps corridors from sliding")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1.0));
  verb->add_flag("--all-points", words->all_points,
                 "add every point instead of outliers only (the paper's Figure 7b), for comparison");
  verb->add_flag("--raw", words->raw,
                 "the map as it grew; default: points moved to the mean of what was seen of them, noise left out");
  add_log_options(*verb, words->reading);
  add_config(*verb);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp map run.clf --out map.pcd --trajectory run.tum --picture map.svg");
  verb->callback([verb, words] {
    read_config(*verb);
    run(*words);
  });
}

}  // namespace slamicp::command
