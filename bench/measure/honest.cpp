// SPDX-License-Identifier: Apache-2.0
// how honest a fix is: its covariance against the truth, blind corridors, a robot at rest, and what it costs
//
// scripts/measure honest [--runs 1000] [--only calibration|causes|corridor|rest|cost] [--samples FILE.csv]
//
// Calibration: single matches beside the routes of four worlds, one setting for all, every fifth in a map with fresh
// noise; asked are a mean NEES/3 of 0.8 to 1.25 and 90 to 98 % of the truths in the 95 % ellipse. --samples writes
// each match's NEES; the results have the share of truths inside the ellipse of any share, which scripts/charts draws.
#include <Eigen/Eigenvalues>
#include <fstream>

#include <slamicp/evaluation/covariance_trial.hpp>
#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "coverage.hpp"
#include "support.hpp"

namespace slamicp::measure {
namespace {

struct Calibration {
  CovarianceScore score;
  std::vector<double> nees;  // of the matches that count there
};

Calibration calibrate(std::string_view world, double unmapped, int runs, const CovarianceTrialOptions& options = {}) {
  constexpr int matches_in_a_map = 5;
  Calibration all;
  for (int seed = 0; seed * matches_in_a_map < runs; ++seed) {
    CovarianceTrials trials(world, static_cast<std::uint64_t>(seed + 1), options);
    for (int k = 0; k < matches_in_a_map; ++k) {
      const CovarianceTrial trial = trials.draw(unmapped);
      const std::size_t counted = all.score.count();
      all.score.add(trial);
      if (all.score.count() > counted) all.nees.push_back(trial.nees());
    }
  }
  return all;
}

Json calibration(int runs, const std::string& samples) {
  std::ofstream csv;
  if (!samples.empty()) csv.open(samples);
  csv << "world,unmapped,nees\n";
  Table table({"world", "unmapped", "NEES/3", "in the 95 % ellipse", "failed", "blind", "RMSE mm", "as told mm",
               "bound mm", "RMSE / bound", "the same of the turn", "Censi's bound mm"});
  Json results = Json::array();
  for (const double unmapped : {0.0, 0.3})
    for (const std::string_view world : trial_world_names()) {
      const Calibration all = calibrate(world, unmapped, runs);
      const CovarianceScore& score = all.score;
      for (const double nees : all.nees) csv << world << ',' << unmapped << ',' << nees << '\n';
      const double ratio = score.rmse() / score.bound();
      const double turn_ratio = score.rmse_turn() / score.bound_turn();
      table.add({std::string(world), text("%.0f %%", 100.0 * unmapped), text("%.2f", score.nees()),
                 text("%.1f %%", 100.0 * score.inside()), text("%zu of %d", score.failed(), runs),
                 text("%zu", score.blind()), text("%.2f", 1e3 * score.rmse()), text("%.2f", 1e3 * score.told()),
                 text("%.2f", 1e3 * score.bound()), text("%.2f", ratio), text("%.2f", turn_ratio),
                 text("%.2f", 1e3 * score.plain_bound())});
      results.push_back({{"world", world},
                         {"unmapped", unmapped},
                         {"nees_over_3", score.nees()},
                         {"inside_95", score.inside()},
                         {"failed", score.failed()},
                         {"blind", score.blind()},
                         {"rmse_m", score.rmse()},
                         {"told_m", score.told()},
                         {"bound_m", score.bound()},
                         {"censi_bound_m", score.plain_bound()},
                         {"coverage", coverage(all.nees)}});
    }
  table.print();
  return results;
}

/// What stays of RMSE / bound where the map is true, where no reading is near a corner, and where both is so.
Json causes(int runs) {
  Table table(
      {"world", "as it is", "true map", "0.25 m off corners", "both", "RMSE mm", "true map", "off corners", "both"});
  Json results = Json::array();
  for (const std::string_view world : trial_world_names()) {
    std::vector<std::string> ratios, errors;
    Json of_world = {{"world", world}};
    for (const double off_corners : {0.0, 0.25})
      for (const double map_noise : {default_map_noise, 0.0}) {
        const CovarianceScore score =
            calibrate(world, 0.0, runs, {.map_noise = map_noise, .off_corners = off_corners}).score;
        ratios.push_back(text("%.2f", score.rmse() / score.bound()));
        errors.push_back(text("%.2f", 1e3 * score.rmse()));
        of_world["rmse_over_bound"].push_back(score.rmse() / score.bound());
      }
    std::vector<std::string> row = {std::string(world)};
    row.insert(row.end(), ratios.begin(), ratios.end());
    row.insert(row.end(), errors.begin(), errors.end());
    table.add(row);
    results.push_back(of_world);
  }
  table.print();
  return results;
}

/// What a drive through a corridor with two ends and nothing between them came to.
struct CorridorDrive {
  std::size_t blind_scans = 0, flagged = 0, carried = 0, seeing_scans = 0, flagged_seeing = 0;
  double across = 0.0;                // largest error [m]
  double along_over_odometry = -1.0;  // largest |along| - 1.05 |odometry's| in blind scans [m]
  double odometry_along = 0.0;        // largest [m]
  double after_one_second = 0.0;      // along, from 1 s after an end came into range on [m]
  double nees = 0.0;
  std::size_t scans = 0;
};

/// True where some beam meets an end of the corridor.
bool sees_an_end(const World& corridor, const Pose2& pose, const LidarModel& lidar, double length) {
  std::vector<double> ranges;
  true_ranges(corridor, pose, lidar, ranges);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!(ranges[i] < lidar.range_max)) continue;
    const double angle = pose.theta + lidar.angle_min + static_cast<double>(i) * lidar.angle_increment;
    const double x = pose.x + ranges[i] * std::cos(angle);
    if (x < 1e-3 || x > length - 1e-3) return true;
  }
  return false;
}

CorridorDrive drive_corridor(std::uint64_t seed, double speed) {
  constexpr double length = 120.0;
  const World corridor = featureless_corridor(length, 2.5);
  Random random(seed);
  DriveOptions options;
  options.speed = speed;
  options.seed = seed;
  options.odometry = no_odometry_noise();
  options.odometry.translation_scale_error = 0.02;
  const SimulatedRun run = simulate_drive(corridor, route(corridor, "reference").waypoints, options);
  Localizer localizer(PointMap2::create(sample_map(corridor, random)));
  localizer.set_pose(run.truth.front().pose);
  CorridorDrive drive;
  double seen_since = -1.0;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    const Fix& fix = localizer.update(run.scans[k]);
    const Pose2& truth = run.truth[k].pose;
    const Pose2 by_wheels = run.truth.front().pose * *run.scans[k].T_odom_robot;
    const double along = std::abs(fix.pose.x - truth.x);
    const double odometry = std::abs(by_wheels.x - truth.x);
    const bool flagged = fix.blind_direction.norm() > 0.5 && std::abs(fix.blind_direction.x()) > 0.99;
    const Pose2::Tangent error = (truth.inverse() * fix.pose).log();
    drive.nees += error.dot(Eigen::Matrix3d(fix.covariance).inverse() * error) / 3.0;
    ++drive.scans;
    drive.across = std::max(drive.across, std::abs(fix.pose.y - truth.y));
    if (sees_an_end(corridor, truth, options.lidar, length)) {
      ++drive.seeing_scans;
      drive.flagged_seeing += flagged ? 1U : 0U;
      if (seen_since < 0.0) seen_since = run.scans[k].stamp;
      if (run.scans[k].stamp > seen_since + 1.0) drive.after_one_second = std::max(drive.after_one_second, along);
    } else {
      seen_since = -1.0;
      ++drive.blind_scans;
      drive.flagged += flagged ? 1U : 0U;
      drive.carried += fix.carried_by == Carrier::odometry ? 1U : 0U;
      drive.odometry_along = std::max(drive.odometry_along, odometry);
      drive.along_over_odometry = std::max(drive.along_over_odometry, along - 1.05 * odometry);
    }
  }
  return drive;
}

Json blind_corridor(int runs) {
  Table table({"seed", "blind scans", "flagged", "carried by odometry", "across mm, most", "odometry along m, most",
               "along - 1.05 odometry's mm", "along 1 s after an end, most mm", "flagged though an end is seen",
               "NEES/3"});
  Json results = Json::array();
  for (int seed = 1; seed <= runs; ++seed) {
    const CorridorDrive drive = drive_corridor(static_cast<std::uint64_t>(seed), 0.5);
    const auto share = [](std::size_t part, std::size_t all) {
      return all > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(all) : 0.0;
    };
    const double flagged = share(drive.flagged, drive.blind_scans);
    table.add({text("%d", seed), text("%zu of %zu", drive.blind_scans, drive.scans), text("%.2f %%", flagged),
               text("%.2f %%", share(drive.carried, drive.blind_scans)), text("%.1f", 1e3 * drive.across),
               text("%.2f", drive.odometry_along), text("%.1f", 1e3 * drive.along_over_odometry),
               text("%.1f", 1e3 * drive.after_one_second),
               text("%.1f %%", share(drive.flagged_seeing, drive.seeing_scans)),
               text("%.2f", drive.nees / static_cast<double>(drive.scans))});
    results.push_back({{"seed", seed},
                       {"flagged_percent", flagged},
                       {"across_m", drive.across},
                       {"along_over_odometry_m", drive.along_over_odometry},
                       {"after_one_second_m", drive.after_one_second}});
  }
  table.print();
  return results;
}

/// A robot that stands: how much its pose trembles.
Json at_rest() {
  Table table({"world", "std mm", "std of the turn deg", "as told mm", "systematic part mm"});
  Json results = Json::array();
  for (const std::string_view name : trial_world_names()) {
    const World world = trial_world(name);
    const LidarModel lidar = hokuyo_utm30lx();
    Random random(3);
    const PointMap2::Pointer map = PointMap2::create(sample_map(world, random));
    double most = 0.0, most_turn = 0.0, told = 0.0, systematic = 0.0;
    for (int place = 0; place < 10; ++place) {
      Localizer localizer(map);
      const Pose2 truth = place_beside_route(world, random);
      localizer.set_pose(truth);
      std::vector<double> x, y, turn;
      for (int k = 0; k < 220; ++k) {
        LaserScan seen = scan(world, truth, lidar, random);
        seen.stamp = k / lidar.rate;
        seen.T_odom_robot = Pose2{};
        const Fix& fix = localizer.update(seen);
        if (k < 20) continue;
        x.push_back(fix.pose.x);
        y.push_back(fix.pose.y);
        turn.push_back(wrap_angle(fix.pose.theta - truth.theta));
      }
      const auto deviation = [](const std::vector<double>& values) {
        double sum = 0.0;
        for (const double value : values) sum += (value - mean(values)) * (value - mean(values));
        return std::sqrt(sum / static_cast<double>(values.size()));
      };
      const Fix& fix = localizer.fix();
      most = std::max(most, std::hypot(deviation(x), deviation(y)));
      most_turn = std::max(most_turn, deviation(turn));
      told = std::max(told, std::sqrt(fix.covariance(0, 0) + fix.covariance(1, 1)));
      const Matrix<3, 3>& common = fix.match.uncertainty.systematic;
      systematic = std::max(systematic, std::sqrt(common(0, 0) + common(1, 1)));
    }
    table.add({std::string(name), text("%.2f", 1e3 * most), text("%.4f", deg_per_rad * most_turn),
               text("%.2f", 1e3 * told), text("%.2f", 1e3 * systematic)});
    results.push_back({{"world", name}, {"std_m", most}, {"told_m", told}});
  }
  table.print();
  return results;
}

/// The match with and without the covariance, in turns.
Json cost() {
  Table table({"world", "bare match us", "with covariance and blindness us", "more"});
  Json results = Json::array();
  for (const std::string_view name : trial_world_names()) {
    const World world = trial_world(name);
    const LidarModel lidar = hokuyo_utm30lx();
    Random random(4);
    const PointMap2::Pointer map = PointMap2::create(sample_map(world, random));
    Icp<2> icp;
    std::vector<double> bare, full, ratios;
    for (int place = 0; place < 100; ++place) {
      const Pose2 truth = place_beside_route(world, random);
      const ScanPoints points = to_points(scan(world, truth, lidar, random));
      const Pose2 guess = truth * Pose2{0.03, -0.02, 0.01};
      std::vector<double> of_bare, of_full;
      for (int round = 0; round < 21; ++round)
        for (const bool with : {false, true}) {
          const Stopwatch watch;
          icp.align(map->indexed(), points.in_robot, guess, {.covariance = with});
          (with ? of_full : of_bare).push_back(watch.microseconds());
        }
      bare.push_back(quantile(of_bare, 0.5));
      full.push_back(quantile(of_full, 0.5));
      ratios.push_back(full.back() / bare.back() - 1.0);
    }
    const double more = 100.0 * quantile(ratios, 0.5);
    table.add({std::string(name), text("%.1f", quantile(bare, 0.5)), text("%.1f", quantile(full, 0.5)),
               text("%.1f %%", more)});
    results.push_back({{"world", name}, {"bare_us", quantile(bare, 0.5)}, {"more_percent", more}});
  }
  table.print();
  return results;
}

void honest(const Words& words) {
  const std::string& only = words["--only"];
  const int runs = static_cast<int>(words.number("--runs"));
  Json results;
  const auto wanted = [&](const char* name) { return only.empty() || only == name; };
  if (wanted("calibration")) results["calibration"] = calibration(runs, words["--samples"]);
  if (wanted("causes")) results["causes"] = causes(runs);
  if (wanted("corridor")) results["corridor"] = blind_corridor(std::max(1, std::min(5, runs)));
  if (wanted("rest")) results["rest"] = at_rest();
  if (wanted("cost")) results["cost"] = cost();
  save_results("honest", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] { honest(Words(argc, argv, {{"--runs", "1000"}, {"--only", ""}, {"--samples", ""}})); });
}
