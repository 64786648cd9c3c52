// SPDX-License-Identifier: Apache-2.0
// slamicp odometry: where the laser alone says that the robot has got to.
#include <map>
#include <memory>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/picture.hpp>
#include <slamicp/io/trajectory_file.hpp>
#include <slamicp/mapping/scan_odometry.hpp>

#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct OdometryWords {
  std::string log, trajectory, picture, json;
  ScanLogOptions reading;
  MatchOptions match;
  ScanOdometryOptions odometry;
  bool no_deskew = false;
};

ScanOdometryOptions odometry_options(const OdometryWords& words) {
  ScanOdometryOptions options = words.odometry;
  options.method = words.match.method;
  options.max_correspondence_distance = words.match.max_correspondence_distance;
  options.max_iterations = words.match.max_iterations;
  options.ranges = words.match.ranges;
  options.deskew = !words.no_deskew;
  return options;
}

/// What the picture shows of the surroundings: a tenth of the points of every scan.
void sample(const Fix& fix, PointCloud2& seen) {
  for (std::size_t k = 0; k < fix.scan.in_robot.size(); k += 10) seen.push_back(fix.pose * fix.scan.in_robot[k]);
}

void draw(const OdometryWords& words, const Trajectory& trajectory, const PointCloud2& seen) {
  Picture picture({.title = "odometry of " + words.log});
  picture.points(seen, colours::map, 0.6, "what was seen");
  picture.path(trajectory, colours::path, 1.2, "path");
  picture.robot(trajectory.back().pose, 0.25, colours::robot, "robot at the end");
  picture.save(file_named(words.picture));
}

void run(const OdometryWords& words) {
  const ScanLog log = open_scan_log(file_named(words.log), words.reading);
  warn(log.warnings);
  if (log.empty()) throw Error("the log holds no scan", words.log, "see 'slamicp info'");
  ScanOdometry odometry(odometry_options(words));
  PointCloud2 seen;
  const Stopwatch watch;
  {
    Progress progress("matching", log.size());
    for (const LaserScan& scan : log) {
      const Fix& fix = odometry.add(scan);
      if (!words.picture.empty()) sample(fix, seen);
      progress.step();
    }
  }
  const double seconds = watch.microseconds() * 1e-6;
  const Trajectory& trajectory = odometry.trajectory();
  const PoseDistance back = distance(trajectory.front().pose, trajectory.back().pose);
  if (!words.trajectory.empty()) save_trajectory(file_named(words.trajectory), trajectory);
  if (!words.picture.empty()) draw(words, trajectory, seen);
  write_json(words.json, {{"verb", "odometry"},
                          {"log", words.log},
                          {"scans", log.size()},
                          {"unmatched_scans", odometry.unmatched()},
                          {"path_length", path_length(trajectory)},
                          {"end_to_start", {{"translation", back.translation}, {"rotation", back.rotation}}},
                          {"seconds", seconds},
                          {"last_pose", to_json(trajectory.back().pose)}});
  Talk{words.json}(format(
      "%zu scans, %d unmatched; %.1f m of path, the end is %.3f m and %.2f deg from the start; %.1f s", log.size(),
      odometry.unmatched(), path_length(trajectory), back.translation, back.rotation * deg_per_rad, seconds));
}

}  // namespace

void add_odometry(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("odometry", "scan odometry: without a map, without wheels");
  const auto words = std::make_shared<OdometryWords>();
  verb->add_option("LOG", words->log, std::string("laser log: ") + log_words)->required();
  verb->add_option("--trajectory", words->trajectory, "poses T_start_robot, a line a scan")->type_name("TUM");
  verb->add_option("--picture", words->picture, "what was seen, and the path")->type_name("FILE.svg|.png");
  static const std::map<std::string, OdometryReference> references{{"local-map", OdometryReference::local_map},
                                                                   {"previous-scan", OdometryReference::previous_scan}};
  verb->add_option("--reference", words->odometry.reference, "what each scan is matched to: local-map, previous-scan")
      ->transform(CLI::Transformer(references, CLI::ignore_case))
      ->default_str("local-map")
      ->type_name("NAME");
  verb->add_option("--map-radius", words->odometry.map_radius, "how far the local map reaches [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_flag("--wheels", words->odometry.use_odometry, "predict by the log's wheel odometry, where it has it");
  verb->add_flag("--no-deskew", words->no_deskew,
                 "take each scan as if measured all at once, though the log says it was not");
  add_match_options(*verb, words->match, words->odometry.max_correspondence_distance);
  words->match.max_iterations = words->odometry.max_iterations;
  verb->get_option("--max-iterations")->capture_default_str();
  add_log_options(*verb, words->reading);
  add_config(*verb);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp odometry run.bag --trajectory odometry.tum --picture odometry.svg");
  verb->callback([verb, words] {
    read_config(*verb);
    run(*words);
  });
}

}  // namespace slamicp::command
