// SPDX-License-Identifier: Apache-2.0
// slamicp localize: every scan of a log in a given map.
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/csv_table.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/trajectory_file.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/localization/odometry_calibrator.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/obstacles/obstacle_tracker.hpp>

#include "output.hpp"
#include "proposals.hpp"
#include "report.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct LocalizeWords {
  std::string log, map, trajectory, outliers, obstacles, metrics, update_map, proposals, report, json;
  std::optional<Pose2> initial_pose;
  std::optional<double> outlier_distance, obstacle_distance;
  ScanLogOptions reading;
  MatchOptions match;
  MotionOptions motion;
  bool calibrate_odometry = false;
  bool recover = false;
};

LocalizerOptions localizer_options(const LocalizeWords& words) {
  LocalizerOptions options;
  options.method = words.match.method;
  options.max_correspondence_distance = words.match.max_correspondence_distance;
  options.outlier_distance = words.outlier_distance;
  options.obstacle_distance = words.obstacle_distance;
  options.max_iterations = words.match.max_iterations;
  options.ranges = words.match.ranges;
  options.use_odometry = words.motion.use_odometry;
  options.deskew = words.motion.deskew;
  options.outputs.matches = !words.outliers.empty();  // they carry the distances
  return options;
}

/// The direction in the map that the scan does not hold, in [0, 180); NaN where it holds all.
double blind_deg(const Fix& fix) {
  const Vector<2>& blind = fix.blind_direction;
  if (blind.isZero()) return std::numeric_limits<double>::quiet_NaN();
  const double degrees = deg_per_rad * std::atan2(blind.y(), blind.x());
  return std::fmod(degrees + 360.0, 180.0);
}

/// The files that get lines while the log is read; one that was not asked for is null.
class Tables {
 public:
  explicit Tables(const LocalizeWords& words)
      : outliers_(open<OutlierRow>(words.outliers)),
        obstacles_(open<ObstacleRow>(words.obstacles)),
        metrics_(open<MetricsRow>(words.metrics)) {}

  void add(std::size_t scan_number, const Fix& fix, const LaserScan& scan, double time_us) {
    if (outliers_) add_outliers(scan_number, fix, scan);
    if (obstacles_) add_obstacles(scan_number, fix, scan);
    if (!metrics_) return;
    const Matrix<3, 3> covariance = fix.covariance_in_map();
    metrics_->add({scan_number, fix.stamp, fix.pose.x, fix.pose.y, fix.pose.theta, to_string(fix.stop()),
                   fix.match.iterations, fix.scan.in_robot.size(), fix.match.inliers, fix.outliers().size(),
                   fix.match.mean_inlier_distance, time_us, to_string(fix.quality.state), fix.quality.probability,
                   covariance(0, 0), covariance(1, 1), covariance(2, 2), blind_deg(fix)});
  }

  void commit() {
    if (outliers_) outliers_->commit();
    if (obstacles_) obstacles_->commit();
    if (metrics_) metrics_->commit();
  }

 private:
  template <typename Row>
  static std::unique_ptr<CsvTable<Row>> open(const std::string& file) {
    return file.empty() ? nullptr : std::make_unique<CsvTable<Row>>(file_named(file));
  }

  void add_outliers(std::size_t scan_number, const Fix& fix, const LaserScan& scan) {
    const std::vector<RayClass> classes = classify_outliers(fix, scan);
    for (std::size_t k = 0; k < fix.outliers().size(); ++k) {
      const auto point = static_cast<std::size_t>(fix.outliers()[k]);
      OutlierRow row;
      row.scan = scan_number;
      row.stamp = fix.stamp;
      row.beam = fix.scan.beams[point];
      row.x = fix.outliers_in_map()[k].x();
      row.y = fix.outliers_in_map()[k].y();
      row.distance = fix.match.matches[point].distance;
      row.kind = to_string(classes[k]);
      outliers_->add(row);
    }
  }

  void add_obstacles(std::size_t scan_number, const Fix& fix, const LaserScan& scan) {
    const std::vector<Obstacle> found = find_obstacles(fix, scan);
    const std::span<const Track> tracks = tracker_.update(fix, scan, found);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Obstacle& obstacle = found[k];
      ObstacleRow row;
      row.scan = scan_number;
      row.stamp = fix.stamp;
      row.state = "unknown";
      for (const Track& track : tracks)
        if (track.obstacles[0] == static_cast<int>(k) || track.obstacles[1] == static_cast<int>(k)) {
          row.id = track.id;
          row.speed = track.speed();
          row.state = word_of(track);
        }
      const Shape& shape = obstacle.shape;
      row.kind = to_string(shape.kind);
      row.x = shape.centre.x();
      row.y = shape.centre.y();
      row.width = shape.width;
      row.depth = shape.depth;
      row.heading = shape.heading;
      row.radius = shape.kind == ShapeKind::circle ? shape.radius : 0.5 * std::hypot(shape.width, shape.depth);
      row.points = obstacle.points.size();
      obstacles_->add(row);
    }
  }

  ObstacleTracker tracker_;
  std::unique_ptr<CsvTable<OutlierRow>> outliers_;
  std::unique_ptr<CsvTable<ObstacleRow>> obstacles_;
  std::unique_ptr<CsvTable<MetricsRow>> metrics_;
};

Json summary(const LocalizeWords& words, const RunRecord& record) {
  Json stops = Json::object();
  for (const auto& [stop, count] : record.stops) stops[to_string(stop)] = count;
  Json states = Json::object();
  for (const auto& [state, count] : record.states) states[to_string(state)] = count;
  return {
      {"verb", "localize"},
      {"log", words.log},
      {"map", words.map},
      {"scans", record.trajectory.size()},
      {"stops", stops},
      {"states", states},
      {"iterations_mean", record.mean(&ScanRecord::iterations)},
      {"points_mean", record.mean(&ScanRecord::points)},
      {"inliers_mean", record.mean(&ScanRecord::inliers)},
      {"outliers_mean", record.mean(&ScanRecord::outliers)},
      {"outliers_max", record.largest(&ScanRecord::outliers)},
      {"mean_inlier_distance", record.mean(&ScanRecord::mean_inlier_distance)},
      {"time_us",
       {{"median", record.quantile(&ScanRecord::time_us, 0.5)}, {"p99", record.quantile(&ScanRecord::time_us, 0.99)}}},
      {"initial_pose", to_json(record.initial_pose)},
      {"last_pose", to_json(record.trajectory.back().pose)}};
}

Json calibration_json(const OdometryCalibration<OdometryScale>& found) {
  if (!found.determined) return {{"determined", false}};
  const auto value = [&](double is, std::size_t k) { return Json{{"value", is}, {"sigma", found.sigmas[k]}}; };
  return {{"determined", true},
          {"translation", value(found.model.translation, 0)},
          {"rotation", value(found.model.rotation, 1)},
          {"drift_per_metre", value(found.model.drift_per_metre, 2)},
          {"rms_before", found.rms_before},
          {"rms_after", found.rms_after}};
}

/// What is wrong with the wheels all the time, in a line.
std::string told(const OdometryCalibration<OdometryScale>& found) {
  if (!found.determined) return "odometry: the run does not tell what to calibrate; drive and turn to both sides";
  return format(
      "odometry: metres x %.4f (+- %.4f), turns x %.4f (+- %.4f), veers %.4f rad/m (+- %.4f); a metre or a "
      "radian on it is %.0f mm off, then %.0f mm",
      found.model.translation, found.sigmas[0], found.model.rotation, found.sigmas[1], found.model.drift_per_metre,
      found.sigmas[2], 1e3 * found.rms_before, 1e3 * found.rms_after);
}

void run(const LocalizeWords& words) {
  if (!words.proposals.empty() && !words.update_map.empty())
    throw Error("--proposals and --update-map do not go together", "slamicp localize",
                "propose first; a map that grows has nothing left to propose");
  const ScanLog log = open_scan_log(file_named(words.log), words.reading);
  warn(log.warnings);
  if (log.empty()) throw Error("the log holds no scan", words.log, "see 'slamicp info'");
  SurfaceOptions surfaces;
  surfaces.threads = words.match.threads;
  Localizer localizer(load_map(file_named(words.map), surfaces), localizer_options(words));
  if (!words.initial_pose) warn("no --initial-pose: starting at the map's origin, 0,0,0, where 'slamicp map' starts");

  Tables tables(words);
  OdometryCalibrator wheels;
  ObstacleFinder finder;
  MapChanges changes;
  RunRecord record;
  record.log = words.log;
  record.map_file = words.map;
  record.initial_pose = words.initial_pose.value_or(Pose2{});
  localizer.set_pose(record.initial_pose);
  constexpr int places_a_scan = 2000;
  int recoveries = 0;
  {
    Progress progress("localizing", log.size());
    for (std::size_t number = 0; number < log.size(); ++number) {
      const Stopwatch watch;
      const Fix& fix = localizer.update(log[number]);
      const double time_us = watch.microseconds();
      tables.add(number, fix, log[number], time_us);
      record.add(fix, time_us);
      if (words.calibrate_odometry) wheels.add(log[number], fix);
      if (!words.proposals.empty()) changes.add(fix, log[number], finder.find(fix, log[number]));
      // What a blind direction was guessed for must not get into the map.
      if (!words.update_map.empty() && fix.usable() && fix.carried_by == Carrier::scan)
        localizer.set_map(update_with_outliers<2>(fix.map, fix.match));
      if (words.recover && localizer.recover(places_a_scan)) ++recoveries;
      progress.step();
    }
  }
  record.map = localizer.map();

  tables.commit();
  if (!words.trajectory.empty()) save_trajectory(file_named(words.trajectory), record.trajectory);
  if (!words.update_map.empty()) save_map(file_named(words.update_map), *localizer.map());
  const std::vector<ProposedChange> proposals = changes.proposals();
  if (!words.proposals.empty()) write_proposals(words.proposals, record, proposals);
  if (!words.report.empty()) write_report(words.report, record);
  Json results = summary(words, record);
  if (words.recover) results["recoveries"] = recoveries;
  const Talk talk(words.json);
  talk(record.brief());
  for (const ProposedChange& change : proposals) talk("proposed: " + change.brief());
  if (!words.proposals.empty()) results["proposals"] = proposals.size();
  if (words.calibrate_odometry) {
    const OdometryCalibration<OdometryScale> found = wheels.calibration();
    results["odometry_calibration"] = calibration_json(found);
    talk(told(found));
  }
  write_json(words.json, results);
}

}  // namespace

void add_localize(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("localize", "localize every scan of a log in a given map");
  const auto words = std::make_shared<LocalizeWords>();
  verb->add_option("LOG", words->log, std::string("laser log: ") + log_words)->required();
  verb->add_option("--map", words->map, std::string("the map: ") + map_words)->required();
  add_pose(*verb, "--initial-pose", words->initial_pose, "where the robot starts in the map; default 0,0,0");
  verb->add_option("--trajectory", words->trajectory, "poses T_map_robot, a line a scan")->type_name("TUM");
  verb->add_option("--outliers", words->outliers, "points that fit nothing in the map")->type_name("CSV");
  verb->add_option("--obstacles", words->obstacles, "outliers grouped into obstacles")->type_name("CSV");
  verb->add_option("--metrics", words->metrics, "what each match was like")->type_name("CSV");
  verb->add_option("--update-map", words->update_map, "the map with the outliers of usable scans added, step by step")
      ->type_name("MAP_OUT");
  verb->add_option("--proposals", words->proposals,
                   "what the map should have or not have, with the evidence: a list, and a picture beside it (.svg)")
      ->type_name("JSON");
  verb->add_option("--report", words->report, "pictures, figures and charts in one page")->type_name("HTML");
  verb->add_flag("--recover", words->recover,
                 "where the pose is suspect or lost, look around: 3 m, all headings, 2000 places a scan");
  verb->add_flag("--calibrate-odometry", words->calibrate_odometry,
                 "tell what the log's odometry gets wrong all the time: its scales, and how it veers");
  add_motion_options(*verb, words->motion);
  add_match_options(*verb, words->match, 0.3);
  verb->add_option("--outlier-distance", words->outlier_distance,
                   "points at least this far from every map point are outliers: the paper's O_t [m]; default: "
                   "--max-correspondence-distance")
      ->check(CLI::PositiveNumber);
  verb->add_option("--obstacle-distance", words->obstacle_distance,
                   "an obstacle is at least this far from the map's surface [m]; default: from the noise, four sigma, "
                   "0.05 at least")
      ->check(CLI::PositiveNumber);
  add_log_options(*verb, words->reading);
  add_config(*verb);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp localize run.clf --map map.pcd --trajectory run.tum --outliers outliers.csv");
  verb->callback([verb, words] {
    read_config(*verb);
    run(*words);
  });
}

}  // namespace slamicp::command
