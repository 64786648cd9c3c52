// SPDX-License-Identifier: Apache-2.0
// SLAM by scan matching on Intel and FR079: the benchmark's relation errors beside published ones, and their spread
//
// scripts/measure slam [--log intel|fr079] [--spread no]
//
// Scores of robot poses, as `slamicp evaluate --relations` gives them for the file that `slamicp map --trajectory`
// writes; for the default also those of laser poses, T_map_robot * T_robot_laser.
#include <slamicp/evaluation/relation_error.hpp>
#include <slamicp/io/relations_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/mapping/mapper.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

struct Published {
  const char* log;
  const char* method;
  const char* translation;
};

// Mean absolute translational error [m]: Kuemmerle et al. 2009; Cartographer: Hess et al. 2016.
constexpr Published published[] = {
    {"intel", "published: scan matching", "0.220"}, {"intel", "published: RBPF (GMapping)", "0.070"},
    {"intel", "published: graph mapping", "0.031"}, {"intel", "published: Cartographer (2016)", "0.0229"},
    {"fr079", "published: scan matching", "0.258"}, {"fr079", "published: RBPF (GMapping)", "0.061"},
    {"fr079", "published: graph mapping", "0.056"}, {"fr079", "published: Cartographer (2016)", "0.0452"},
};

struct Log {
  std::string name;
  ScanLog scans;
  std::vector<Relation> relations;
};

Log load(const std::string& name) {
  return {name, open_scan_log(data("slam_benchmark/" + name + ".clf")),
          load_relations(data("slam_benchmark/" + name + ".relations"))};
}

Trajectory odometry(const ScanLog& log) {
  Trajectory poses;
  for (const LaserScan& scan : log)
    if (scan.T_odom_robot) poses.push_back({scan.stamp, *scan.T_odom_robot});
  return poses;
}

Trajectory of_laser(const ScanLog& log, Trajectory poses) {
  for (std::size_t k = 0; k < poses.size(); ++k) poses[k].pose = poses[k].pose * log[k].T_robot_laser;
  return poses;
}

struct MapRun {
  Trajectory trajectory;
  std::size_t map_points = 0;
  int keyframes = 0;
  int unmatched = 0;
  double seconds = 0.0;
};

MapRun build_map(const ScanLog& log, const MapperOptions& options) {
  const Stopwatch watch;
  Mapper mapper(options);
  for (const LaserScan& scan : log) mapper.add(scan);
  return {mapper.trajectory(), mapper.map()->size(), mapper.keyframes(), mapper.unmatched(), watch.seconds()};
}

Json numbers(const RelationErrorStatistics& errors) {
  const auto of = [](const ErrorStatistics& e) {
    return Json{{"count", e.count}, {"mean", e.mean}, {"std", e.standard_deviation}, {"p95", e.p95}, {"max", e.max}};
  };
  return {{"translation_m", of(errors.translation)}, {"rotation_deg", of(errors.rotation_deg)}};
}

void add_score(Table& table, Json& results, const Log& log, const std::string& method, const Trajectory& trajectory,
               const MapRun* run = nullptr) {
  const RelationError error = relation_error(trajectory, log.relations);
  const ErrorStatistics& all = error.all.translation;
  table.add({log.name, method, text("%.3f +- %.3f", all.mean, all.standard_deviation),
             text("%.2f +- %.2f", error.all.rotation_deg.mean, error.all.rotation_deg.standard_deviation),
             text("%.2f", all.max), text("%.3f", error.long_spans.translation.mean),
             run != nullptr ? text("%zu", run->map_points) : "-", run != nullptr ? text("%.0f", run->seconds) : "-"});
  Json result{
      {"log", log.name}, {"method", method}, {"all", numbers(error.all)}, {"over_60_s", numbers(error.long_spans)}};
  if (run != nullptr)
    result.update({{"map_points", run->map_points},
                   {"keyframes", run->keyframes},
                   {"unmatched_scans", run->unmatched},
                   {"seconds", run->seconds}});
  results.push_back(result);
}

struct Change {
  std::string name;
  double insertion_distance;
  double keyframe_distance;
};

void measure_spread(const Log& log, const MapRun& base, Table& table, Json& results) {
  const MapperOptions usual;
  std::vector<double> errors;
  const auto add = [&](const std::string& name, const MapRun& run) {
    const RelationError error = relation_error(run.trajectory, log.relations);
    errors.push_back(error.all.translation.mean);
    table.add({log.name, name, text("%.3f", error.all.translation.mean), text("%.2f", error.all.rotation_deg.mean),
               text("%.2f", error.all.translation.max), text("%.3f", error.long_spans.translation.mean),
               text("%zu", run.map_points), text("%d", run.unmatched)});
    results.push_back({{"log", log.name}, {"change", name}, {"mean_m", error.all.translation.mean}});
  };
  add("default (0.05 m, 0.3 m)", base);
  for (const Change& change : {Change{"insertion distance 0.04 m", 0.04, usual.keyframe_distance},
                               Change{"insertion distance 0.06 m", 0.06, usual.keyframe_distance},
                               Change{"keyframe distance 0.2 m", usual.insertion_distance, 0.2},
                               Change{"keyframe distance 0.4 m", usual.insertion_distance, 0.4}}) {
    MapperOptions options;
    options.insertion_distance = change.insertion_distance;
    options.keyframe_distance = change.keyframe_distance;
    add(change.name, build_map(log.scans, options));
  }
  table.add({log.name, "**all five: mean (least to largest)**",
             text("**%.3f (%.3f to %.3f)**", mean(errors), quantile(errors, 0.0), quantile(errors, 1.0))});
}

void slam(const Words& words) {
  Table scores(
      {"log", "method", "relation error m", "rotation deg", "largest m", "over 60 s apart, m", "map points", "s"});
  Table spread({"log", "options changed", "relation error m", "rotation deg", "largest m", "over 60 s apart, m",
                "map points", "unmatched scans"});
  Json results{{"scores", Json::array()}, {"spread", Json::array()}};
  for (const std::string name : {"intel", "fr079"}) {
    if (!words["--log"].empty() && words["--log"] != name) continue;
    const Log log = load(name);
    add_score(scores, results["scores"], log, "raw odometry", odometry(log.scans));
    for (const Published& row : published)
      if (name == row.log) scores.add({row.log, row.method, row.translation});
    const MapRun run = build_map(log.scans, {});
    add_score(scores, results["scores"], log, "**slamicp map** (robot poses)", run.trajectory, &run);
    add_score(scores, results["scores"], log, "slamicp map (laser poses)", of_laser(log.scans, run.trajectory), &run);
    if (words["--spread"] == "yes") measure_spread(log, run, spread, results["spread"]);
  }
  std::printf(
      "Relation error: mean +- standard deviation of |trans(e)| and |rot(e)| over all relations of the benchmark\n"
      "(Kuemmerle et al. 2009). Scan matching only, no loop closure. One thread.\n\n");
  scores.print();
  if (words["--spread"] == "yes") {
    std::printf("How much that hangs on the options (mean relation error):\n\n");
    spread.print();
  }
  save_results("slam", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] { slam(Words(argc, argv, {{"--log", ""}, {"--spread", "yes"}})); });
}
