// SPDX-License-Identifier: Apache-2.0
// slamicp info: what a file holds.
#include <map>
#include <memory>
#include <numbers>
#include <set>

#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/file_kind.hpp>
#include <slamicp/io/occupancy_map_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/search/indexed_points.hpp>

#include "info_world.hpp"
#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct InfoWords {
  std::string file, json;
  ScanLogOptions reading;
};

/// What is told of each laser.
struct LaserFacts {
  std::size_t scans = 0;
  std::set<std::size_t> beam_counts;
  const LaserScan* first = nullptr;
};

struct LogFacts {
  std::map<int, LaserFacts> lasers;
  std::size_t returns = 0;
  std::size_t beams = 0;
  double nearest = 1e300, farthest = 0.0;
  double first_stamp = 1e300, last_stamp = -1e300;
  std::size_t with_odometry = 0;
  std::size_t with_sweep_motion = 0;
  double odometry_path = 0.0;
};

LogFacts facts_of(const ScanLog& log) {
  LogFacts facts;
  const LaserScan* before = nullptr;
  for (const LaserScan& scan : log) {
    LaserFacts& laser = facts.lasers[scan.laser];
    if (laser.scans++ == 0) laser.first = &scan;
    laser.beam_counts.insert(scan.ranges.size());
    facts.beams += scan.ranges.size();
    for (const float range : scan.ranges) {
      if (!is_return(scan, range)) continue;
      ++facts.returns;
      facts.nearest = std::min(facts.nearest, static_cast<double>(range));
      facts.farthest = std::max(facts.farthest, static_cast<double>(range));
    }
    facts.first_stamp = std::min(facts.first_stamp, scan.stamp);
    facts.last_stamp = std::max(facts.last_stamp, scan.stamp);
    if (scan.sweep_motion) ++facts.with_sweep_motion;
    if (scan.T_odom_robot) {
      ++facts.with_odometry;
      if (before != nullptr && before->T_odom_robot)
        facts.odometry_path += distance(*before->T_odom_robot, *scan.T_odom_robot).translation;
    }
    before = &scan;
  }
  return facts;
}

std::string name_of(const ScanLog& log, int laser) {
  const auto number = static_cast<std::size_t>(laser);
  return number < log.lasers.size() ? log.lasers[number] : std::string();
}

/// One laser: its beams, how long a sweep takes, where it sits on the robot.
Json tell_laser(const std::string& name, const LaserFacts& facts, const Talk& talk) {
  const LaserScan& first = *facts.first;
  std::string beams;
  for (const std::size_t count : facts.beam_counts) beams += (beams.empty() ? "" : ", ") + std::to_string(count);
  const double fov_deg = field_of_view(first) * deg_per_rad;
  talk(format("  beams                  %s, field of view %.2f deg, first beam at %.2f deg", beams.c_str(), fov_deg,
              first.angle_min * deg_per_rad));
  talk(first.time_increment == 0.0
           ? std::string("  sweep                  beams without stamps of their own")
           : format("  sweep                  %.4f s from the first beam to the last", sweep_time(first)));
  talk(format("  laser on the robot     %s", to_string(first.T_robot_laser).c_str()));
  return {{"name", name},
          {"scans", facts.scans},
          {"beams", facts.beam_counts},
          {"fov_deg", fov_deg},
          {"angle_min", first.angle_min},
          {"sweep_time", sweep_time(first)},
          {"laser_offset", to_json(first.T_robot_laser)}};
}

Json tell_lasers(const ScanLog& log, const LogFacts& facts, const Talk& talk) {
  Json lasers = Json::array();
  for (const auto& [laser, its] : facts.lasers) {
    const std::string name = name_of(log, laser);
    if (!name.empty()) talk(format("  scans                  %zu of %s", its.scans, name.c_str()));
    lasers.push_back(tell_laser(name, its, talk));
  }
  return lasers;
}

std::string odometry_told(const LogFacts& facts) {
  if (facts.with_odometry == 0) return "  odometry               none";
  std::string told =
      format("  odometry               with %zu scans, a path of %.1f m", facts.with_odometry, facts.odometry_path);
  if (facts.with_sweep_motion > 0) told += format(", within %zu sweeps too", facts.with_sweep_motion);
  return told;
}

/// What a log with scans holds.
void tell_scans(const ScanLog& log, const Talk& talk, Json& summary) {
  const LogFacts facts = facts_of(log);
  const double duration = facts.last_stamp - facts.first_stamp;
  const double return_share =
      facts.beams == 0 ? 0.0 : static_cast<double>(facts.returns) / static_cast<double>(facts.beams);
  const Json lasers = tell_lasers(log, facts, talk);
  talk(format("  returns                %.1f %% of the beams, %.2f m to %.2f m", 100.0 * return_share, facts.nearest,
              facts.farthest));
  talk(format("  duration               %.2f s, stamps %.6f to %.6f", duration, facts.first_stamp, facts.last_stamp));
  talk(odometry_told(facts));
  // The first laser's facts stand at the top too: most robots have one.
  summary.update({{"beams", lasers[0]["beams"]},
                  {"fov_deg", lasers[0]["fov_deg"]},
                  {"angle_min", lasers[0]["angle_min"]},
                  {"sweep_time", lasers[0]["sweep_time"]},
                  {"laser_offset", lasers[0]["laser_offset"]},
                  {"lasers", lasers},
                  {"return_share", return_share},
                  {"range_min", facts.nearest},
                  {"range_max", facts.farthest},
                  {"duration", duration},
                  {"first_stamp", facts.first_stamp},
                  {"last_stamp", facts.last_stamp},
                  {"scans_with_odometry", facts.with_odometry},
                  {"scans_with_sweep_motion", facts.with_sweep_motion},
                  {"odometry_path", facts.odometry_path}});
}

void tell_log(const InfoWords& words) {
  ScanLogOptions reading = words.reading;
  if (reading.scan_topics.empty()) reading.scan_topics = {every_topic};
  const ScanLog log = open_scan_log(file_named(words.file), reading);
  const Talk talk(words.json);
  talk(format("%s: a %s log of %zu scans", words.file.c_str(), log.format.c_str(), log.size()));
  for (const auto& [kind, count] : log.messages) talk(format("  %-22s %zu", kind.c_str(), count));
  Json summary{{"verb", "info"}, {"file", words.file}, {"kind", "log"}, {"format", log.format}, {"scans", log.size()}};
  if (!log.empty()) tell_scans(log, talk, summary);
  if (log.lasers.size() > 1)
    talk(format("  lasers                 %zu: --scan-topic says which, where they are not all meant",
                log.lasers.size()));
  summary["messages"] = log.messages;
  summary["problems"] = log.warnings;
  for (const std::string& warning : log.warnings) talk("  problem                " + warning);
  write_json(words.json, summary);
}

template <int D>
void tell_points(const PointCloud<D>& points, const Cloud& cloud, const InfoWords& words) {
  const Talk talk(words.json);
  const Bounds<D> bounds = bounds_of<D>(points);
  const double spacing = IndexedPoints<D>(points, {.neighbours = 0}).spacing();
  talk(format("%s: a %dD cloud of %zu points (%s)", words.file.c_str(), D, points.size(), cloud.format.c_str()));
  Json summary{{"verb", "info"},         {"file", words.file}, {"kind", "cloud"},
               {"format", cloud.format}, {"dimension", D},     {"points", points.size()}};
  if (!bounds.empty()) {
    Json lower = Json::array(), upper = Json::array();
    for (int axis = 0; axis < D; ++axis) {
      talk(format("  %c                      %.3f m to %.3f m", "xyz"[axis], bounds.lower[axis], bounds.upper[axis]));
      lower.push_back(bounds.lower[axis]);
      upper.push_back(bounds.upper[axis]);
    }
    talk(format("  spacing                %.4f m to the nearest neighbour (median)", spacing));
    summary.update({{"lower", lower}, {"upper", upper}, {"spacing", spacing}});
  }
  summary["problems"] = cloud.warnings;
  for (const std::string& warning : cloud.warnings) talk("  problem                " + warning);
  write_json(words.json, summary);
}

const char* name_of(OccupancyMode mode) {
  return mode == OccupancyMode::trinary ? "trinary" : mode == OccupancyMode::scale ? "scale" : "raw";
}

/// The bounds of a grid, which may be turned.
Bounds<2> bounds_of(const OccupancyGrid& grid) {
  Bounds<2> bounds;
  for (const int column : {0, grid.width})
    for (const int row : {0, grid.height})
      bounds.include(grid.T_map_grid * Point2(column * grid.resolution, row * grid.resolution));
  return bounds;
}

void tell_map(const InfoWords& words) {
  const OccupancyMap map = load_occupancy_map(file_named(words.file));
  const OccupancyGrid& grid = map.grid;
  const CellCounts counts = count_cells(grid);
  const Bounds<2> bounds = bounds_of(grid);
  const std::size_t walls = wall_points(grid).size();
  const std::string image = map.header.image.string();
  const Talk talk(words.json);
  talk(format("%s: a map_server map of %d x %d cells of %g m (%s, %s)", words.file.c_str(), grid.width, grid.height,
              grid.resolution, image.c_str(), map.format.c_str()));
  talk(format("  cells                  %zu occupied, %zu free, %zu unknown", counts.occupied, counts.free,
              counts.unknown));
  talk(format("  wall points            %zu", walls));
  talk(format("  origin                 %s", to_string(grid.T_map_grid).c_str()));
  for (int axis = 0; axis < 2; ++axis)
    talk(format("  %c                      %.3f m to %.3f m", "xy"[axis], bounds.lower[axis], bounds.upper[axis]));
  talk(format("  greys                  %s%s, occupied above %g, free below %g", name_of(map.header.mode),
              map.header.negate ? ", white is occupied" : "", map.header.occupied_threshold,
              map.header.free_threshold));
  for (const std::string& warning : map.warnings) talk("  problem                " + warning);
  write_json(words.json, {{"verb", "info"},
                          {"file", words.file},
                          {"kind", "map"},
                          {"format", map.format},
                          {"image", image},
                          {"width", grid.width},
                          {"height", grid.height},
                          {"resolution", grid.resolution},
                          {"origin", to_json(grid.T_map_grid)},
                          {"occupied", counts.occupied},
                          {"free", counts.free},
                          {"unknown", counts.unknown},
                          {"wall_points", walls},
                          {"lower", {bounds.lower.x(), bounds.lower.y()}},
                          {"upper", {bounds.upper.x(), bounds.upper.y()}},
                          {"mode", name_of(map.header.mode)},
                          {"negate", map.header.negate},
                          {"occupied_thresh", map.header.occupied_threshold},
                          {"free_thresh", map.header.free_threshold},
                          {"problems", map.warnings}});
}

void run(const InfoWords& words) {
  const FileKind kind = kind_of(file_named(words.file));
  if (kind == FileKind::scan_log) return tell_log(words);
  if (kind == FileKind::occupancy_map) return tell_map(words);
  if (kind == FileKind::world) return tell_world(words.file, words.json);
  const Cloud cloud = load_cloud(file_named(words.file));
  if (const auto* plane = std::get_if<PointCloud2>(&cloud.points))
    tell_points<2>(*plane, cloud, words);
  else
    tell_points<3>(std::get<PointCloud3>(cloud.points), cloud, words);
}

}  // namespace

void add_info(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("info", "what a log, cloud, map or world holds, and what is wrong with it");
  const auto words = std::make_shared<InfoWords>();
  verb->add_option("FILE", words->file,
                   std::string("a log (") + log_words + "), a cloud or map (" + map_words + "), or a world (.yaml)")
      ->required();
  add_log_options(*verb, words->reading);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp info run.clf");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::command
