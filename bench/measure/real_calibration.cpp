// SPDX-License-Identifier: Apache-2.0
// how honest fixes on real scans are: covariances against held-out estimates, probabilities against right and wrong
//
// scripts/measure real_calibration [--stretches 100] [--only covariance|probability] [--log NAME] [--samples FILE.csv]
//                                  [--pairs FILE.csv]
//
// Covariance: each log is mapped as a whole, then taken apart: two maps and a run without a scan in common. The even
// beams of a scan in the one map and its odd beams in the other are two estimates of one pose without a reading in
// common: they differ by the noise of both, NEES / 3 of 1, if their covariances are right.
// Probability: stretches of real runs with the robot put down where it is, or elsewhere. --samples writes each fix's
// evidence and whether its pose was right, --pairs the differences.
#include <array>
#include <cmath>
#include <fstream>

#include <slamicp/evaluation/covariance_trial.hpp>
#include <slamicp/evaluation/held_out.hpp>
#include <slamicp/evaluation/jump_trial.hpp>
#include <slamicp/evaluation/stretch_trials.hpp>
#include <slamicp/evaluation/trajectory_error.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/mapping/mapper.hpp>

#include "coverage.hpp"
#include "reliability.hpp"
#include "support.hpp"

namespace slamicp::measure {
namespace {

struct LogName {
  const char* name;
  const char* file;
};

constexpr std::array<LogName, 4> logs = {{{"fr079", "slam_benchmark/fr079.clf"},
                                          {"intel", "slam_benchmark/intel.clf"},
                                          {"birmingham0", "hokuyo/birmingham_trace0.bag"},
                                          {"birmingham1", "hokuyo/birmingham_trace1.bag"}}};

/// Differences of a kind, in one log.
struct PairScore {
  std::size_t all = 0, counted = 0, blind = 0, apart = 0, inside = 0;
  double position2 = 0.0, told2 = 0.0;
  std::vector<double> nees;

  void add(const IndependentPair& pair) {
    constexpr double other_place = 0.1;  // [m]
    ++all;
    blind += pair.usable && pair.blind;
    if (!pair.usable || pair.blind) return;
    if (pair.difference.head<2>().norm() > other_place) {
      ++apart;
      return;
    }
    ++counted;
    nees.push_back(pair.nees());
    inside += pair.nees() <= within_95_percent;
    position2 += pair.difference.head<2>().squaredNorm();
    told2 += pair.covariance(0, 0) + pair.covariance(1, 1);
  }
  double of(double sum) const { return counted > 0 ? sum / static_cast<double>(counted) : 0.0; }
};

void add_pairs(Table& table, Json& results, std::ostream& csv, const std::string& log, const std::string& what,
               const std::vector<IndependentPair>& pairs, int lost_tracks) {
  PairScore score;
  for (const IndependentPair& pair : pairs) {
    score.add(pair);
    csv << log << ',' << what << ',' << pair.usable << ',' << pair.blind << ',' << pair.nees() << ','
        << pair.difference.head<2>().norm() << ',' << pair.difference[2] << '\n';
  }
  const double inside = 100.0 * score.of(static_cast<double>(score.inside));
  const double rms = 1e3 * std::sqrt(score.of(score.position2));
  const double told = 1e3 * std::sqrt(score.of(score.told2));
  table.add({log, what, text("%zu", score.counted), text("%.2f", mean(score.nees) / 3.0), text("%.1f %%", inside),
             text("%.1f", rms), text("%.1f", told), text("%zu", score.apart), text("%zu", score.blind),
             text("%d", lost_tracks)});
  results.push_back({{"log", log},
                     {"of", what},
                     {"pairs", score.counted},
                     {"nees_over_3", mean(score.nees) / 3.0},
                     {"inside_95_percent", inside},
                     {"difference_mm", rms},
                     {"told_mm", told},
                     {"apart", score.apart},
                     {"blind", score.blind},
                     {"lost_tracks", lost_tracks},
                     {"coverage", coverage(score.nees)}});
}

/// What is measured, and where it goes.
struct Files {
  std::ofstream samples, pairs;

  explicit Files(const Words& words) {
    if (!words["--samples"].empty()) samples.open(words["--samples"]);
    if (!words["--pairs"].empty()) pairs.open(words["--pairs"]);
    samples
        << "world,stretch,scan,put_elsewhere,right,off_m,off_rad,rays,explained,beside,violations,spread,fit,"
           "inlier_share,mean_inlier_distance,innovation_m,innovation_rad,stop,scan_probability,probability,state\n";
    pairs << "log,of,usable,blind,nees,difference_m,difference_rad\n";
  }
};

struct ProbabilityScore {
  Reliability by_scan, averaged;
  int displaced = 0, noticed = 0, right_again = 0, confidently_wrong = 0;
  int right_scans = 0, alarms = 0;
};

void write_sample(std::ostream& csv, const std::string& world, int stretch, int scan, bool put_elsewhere,
                  const Fix& fix, const Pose2& truth) {
  const Evidence& evidence = fix.quality.evidence;
  const PoseDistance off = distance(fix.pose, truth);
  const PoseDistance innovation = distance(fix.predicted, fix.pose);
  const double near = evidence.explained + evidence.beside;
  const double points = std::max(1.0, static_cast<double>(fix.scan.in_robot.size()));
  csv << world << ',' << stretch << ',' << scan << ',' << put_elsewhere << ',' << is_right(fix.pose, truth) << ','
      << off.translation << ',' << off.rotation << ',' << evidence.rays << ',' << evidence.explained << ','
      << evidence.beside << ',' << evidence.violations << ',' << evidence.spread << ','
      << (near > 0.0 ? evidence.explained / near : 0.0) << ',' << static_cast<double>(fix.match.inliers) / points << ','
      << fix.match.mean_inlier_distance << ',' << innovation.translation << ',' << innovation.rotation << ','
      << to_string(fix.stop()) << ',' << fix.quality.scan_probability << ',' << fix.quality.probability << ','
      << to_string(fix.quality.state) << '\n';
}

ProbabilityScore try_stretches(const std::string& world, const ReferenceRun& run, int count, std::ostream& csv) {
  ProbabilityScore score;
  StretchTrials trials(run, 1);
  int stretch = 0, scan = 0;
  bool put_elsewhere = false;
  trials.watch([&](const Fix& fix, const Pose2& truth) {
    const bool right = is_right(fix.pose, truth);
    score.by_scan.add(fix.quality.scan_probability, right);
    score.averaged.add(fix.quality.probability, right);
    write_sample(csv, world, stretch, scan++, put_elsewhere, fix, truth);
  });
  for (; stretch < 2 * count; ++stretch) {
    put_elsewhere = stretch % 2 != 0;
    scan = 0;
    const StretchOutcome outcome = trials.draw(put_elsewhere);
    score.right_scans += outcome.right_scans;
    score.alarms += outcome.alarms;
    if (!put_elsewhere) continue;
    ++score.displaced;
    score.noticed += outcome.noticed;
    score.right_again += outcome.right_again;
    score.confidently_wrong += outcome.longest_confident > 3.0;
  }
  return score;
}

void add_probabilities(Table& table, Table& curve, Json& results, const std::string& world,
                       const ProbabilityScore& score) {
  const auto percent = [&](int part) { return 100.0 * part / std::max(1, score.displaced); };
  const double brier = score.by_scan.brier();
  const double averaged = score.averaged.brier();
  table.add({world, text("%d", score.displaced), text("%.1f %%", percent(score.noticed)),
             text("%.1f %%", percent(score.right_again)), text("%.1f %%", percent(score.confidently_wrong)),
             text("%d in %d scans", score.alarms, score.right_scans), text("%.4f / %.4f", brier, averaged)});
  std::vector<std::string> row = {world};
  for (std::size_t k = 0; k < 10; ++k) {
    const int all = score.averaged.all[k];
    row.push_back(all > 0 ? text("%.0f %% of %d", 100.0 * score.averaged.right[k] / all, all) : "-");
  }
  curve.add(row);
  results.push_back({{"world", world},
                     {"displaced", score.displaced},
                     {"noticed_percent", percent(score.noticed)},
                     {"right_again_percent", percent(score.right_again)},
                     {"confidently_wrong_percent", percent(score.confidently_wrong)},
                     {"right_scans", score.right_scans},
                     {"alarms", score.alarms},
                     {"brier", brier},
                     {"brier_averaged", averaged},
                     {"bins", bins_json(score.by_scan, score.averaged)}});
}

/// The scans of a log that its map has not, and where the joint map run put them.
ReferenceRun held_out_run(std::span<const PlacedRecord> placed, const PointMap2::Pointer& map) {
  ReferenceRun run;
  run.map = map;
  for (std::size_t k = 0; k < placed.size(); ++k) {
    if (k % 4 == 0) continue;
    run.scans.push_back(placed[k].scan);
    run.reference.push_back(placed[k].pose);
  }
  return run;
}

/// A run in another map; the reference is the log's own map run, laid over what was found there.
ReferenceRun laid_over(const ScanLog& log, const PointMap2::Pointer& map, const Trajectory& found) {
  Trajectory own;
  for (const PlacedRecord& record : place_scans(log.scans)) own.push_back({record.scan.stamp, record.pose});
  const TrajectoryError apart = absolute_error(own, found, {.alignment = Alignment::se2});
  std::printf("%s: its own map run lies %.0f mm (95 %%: %.0f, most %.0f mm) and %.2f deg beside what was found\n\n",
              log.name.c_str(), 1e3 * apart.translation.mean, 1e3 * apart.translation.p95, 1e3 * apart.translation.max,
              deg_per_rad * apart.rotation.mean);
  ReferenceRun run{map, log.scans, {}};
  for (const StampedPose& stamped : own) run.reference.push_back(apart.T_truth_estimate * stamped.pose);
  return run;
}

/// Poses in a map that may grow by what it does not know.
Trajectory follow(const ScanLog& log, const PointMap2::Pointer& map, const Pose2& start, bool grows) {
  LocalizerOptions options;
  options.outlier_distance = 0.05;
  Localizer localizer(map, options);
  localizer.set_pose(start);
  Trajectory found;
  for (const LaserScan& scan : log) {
    const Fix& fix = localizer.update(scan);
    found.push_back({fix.stamp, fix.pose});
    if (grows && fix.usable() && fix.carried_by == Carrier::scan)
      localizer.set_map(update_with_outliers<2>(fix.map, fix.match));
  }
  return found;
}

ReferenceRun trace1_in_map_of_trace0() {
  Mapper mapper;
  for (const LaserScan& scan : open_scan_log(data("hokuyo/birmingham_trace0.bag"))) mapper.add(scan);
  const ScanLog log = open_scan_log(data("hokuyo/birmingham_trace1.bag"));
  const PointMap2::Pointer map = mapper.refined_map();
  return laid_over(log, map, follow(log, map, {-0.4, 0.0, -0.06}, true));
}

ReferenceRun macfirst_in_its_map() {
  const ScanLog log = open_scan_log(data("maps_localization/macfirst_floor_take_2_0.db3"));
  const PointMap2::Pointer map = load_map(data("maps_localization/mac_1st_floor_final.yaml"));
  return laid_over(log, map, follow(log, map, {6.859, -8.351, 1.773}, false));
}

void real_calibration(const Words& words) {
  Files files(words);
  const int count = static_cast<int>(words.number("--stretches"));
  const auto wanted = [&](const std::string& name) { return words["--log"].empty() || words["--log"] == name; };
  const bool covariance = words["--only"] != "probability", probability = words["--only"] != "covariance";
  Table differences({"log", "of", "pairs", "NEES/3", "in the 95 % ellipse", "apart mm, RMS", "as told mm",
                     "over 0.1 m apart", "blind", "tracks lost"});
  Table noticed({"run", "put elsewhere", "noticed within 40 scans", "of these right again", "wrong and sure > 3 s",
                 "alarms while right", "Brier score, scan / averaged"});
  Table curve({"right, where told", "0 to 10 %", "10 to 20", "20 to 30", "30 to 40", "40 to 50", "50 to 60", "60 to 70",
               "70 to 80", "80 to 90", "90 to 100 %"});
  Json results{{"covariance", Json::array()}, {"probability", Json::array()}};
  const auto try_run = [&](const std::string& name, const ReferenceRun& run) {
    add_probabilities(noticed, curve, results["probability"], name, try_stretches(name, run, count, files.samples));
  };
  for (const LogName& log : logs) {
    if (!wanted(log.name)) continue;
    const std::vector<PlacedRecord> placed = place_scans(open_scan_log(data(log.file)).scans);
    const HeldOutLog parts = take_apart(placed);
    if (covariance) {
      const HeldOutPairs pairs = compare(parts);
      add_pairs(differences, results["covariance"], files.pairs, log.name, "single matches", pairs.matches,
                pairs.lost_tracks);
      add_pairs(differences, results["covariance"], files.pairs, log.name, "fixes", pairs.fixes, pairs.lost_tracks);
    }
    if (probability) try_run(log.name, held_out_run(placed, parts.map));
  }
  if (probability && wanted("trace1_in_trace0")) try_run("trace1_in_trace0", trace1_in_map_of_trace0());
  if (probability && wanted("macfirst")) try_run("macfirst", macfirst_in_its_map());
  if (covariance) differences.print();
  if (probability) {
    noticed.print();
    curve.print();
  }
  save_results("real_calibration", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] {
    real_calibration(
        Words(argc, argv, {{"--stretches", "100"}, {"--only", ""}, {"--log", ""}, {"--samples", ""}, {"--pairs", ""}}));
  });
}
