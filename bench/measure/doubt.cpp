// SPDX-License-Identifier: Apache-2.0
// whether a localizer knows when its pose is wrong: robots put down elsewhere, false alarms, calibration, cost
//
// scripts/measure doubt [--jumps 500] [--hours 1] [--only jumps|recovery|alarms|calibration|cost]
//                        [--world NAME] [--samples FILE.csv]    NAME: alarms in one world only
//
// Asked: of 500 jumps of at least 2 m or 45 deg 97 % noticed within 40 scans and a metre, at most 0.5 % confidently
// wrong for more than 3 s, at most one false alarm an hour, also with 40 % of the scan on unmapped things.
// --samples writes each fix's evidence and whether its pose was right: what the probability was fitted to.
#include <array>
#include <cmath>
#include <fstream>

#include <slamicp/evaluation/cluttered_drive.hpp>
#include <slamicp/evaluation/jump_trial.hpp>
#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "reliability.hpp"
#include "support.hpp"

namespace slamicp::measure {
namespace {

constexpr std::array<double, 2> shares = {0.0, 0.4};
constexpr int three_seconds = 120;  // scans

struct Jumps {
  int all = 0, alike = 0, noticed = 0, right_again = 0, confidently_wrong = 0, recovered = 0;
  std::vector<double> scans_until;

  void add(const JumpOutcome& outcome) {
    ++all;
    if (outcome.alike) {
      ++alike;
      return;
    }
    noticed += outcome.noticed;
    right_again += outcome.right_again;
    confidently_wrong += outcome.longest_confident > three_seconds;
    recovered += outcome.recovered;
    if (outcome.noticed) scans_until.push_back(outcome.scans_until);
  }
  double percent(int of) const { return 100.0 * of / std::max(1, all - alike); }
};

Json jumps(int count, int budget) {
  Table table({"world", "unmapped", "jumps", "alike", "noticed", "of these right again", "median scans",
               "confidently wrong > 3 s", "right and sure at the end"});
  Json results = Json::array();
  for (const double unmapped : shares)
    for (const std::string_view world : trial_world_names()) {
      Jumps sum;
      for (int k = 0; k < count; k += 5) {
        JumpTrials trials(world, static_cast<std::uint64_t>(k + 1));
        for (int n = 0; n < 5; ++n) sum.add(trials.draw(unmapped, budget));
      }
      table.add({std::string(world), text("%.0f %%", 100.0 * unmapped), text("%d", sum.all), text("%d", sum.alike),
                 text("%.1f %%", sum.percent(sum.noticed)), text("%.1f %%", sum.percent(sum.right_again)),
                 text("%.0f", sum.scans_until.empty() ? 0.0 : quantile(sum.scans_until, 0.5)),
                 text("%.1f %%", sum.percent(sum.confidently_wrong)), text("%.1f %%", sum.percent(sum.recovered))});
      results.push_back({{"world", world},
                         {"unmapped", unmapped},
                         {"jumps", sum.all},
                         {"alike", sum.alike},
                         {"noticed_percent", sum.percent(sum.noticed)},
                         {"confidently_wrong_percent", sum.percent(sum.confidently_wrong)},
                         {"recovered_percent", sum.percent(sum.recovered)}});
    }
  table.print();
  return results;
}

/// Fixes of a robot that follows its way among things that its map does not know.
template <class See>
void drive_among_things(std::string_view world, const ClutteredDriveOptions& options, double seconds,
                        std::uint64_t seed, See see) {
  ClutteredDrive drive(world, seed, options);
  Localizer localizer(drive.map());
  localizer.set_pose(drive.truth());
  for (int k = 0; k < static_cast<int>(40.0 * seconds); ++k) {
    const Fix& fix = localizer.update(drive.next());
    see(fix, drive.truth());
  }
}

Json false_alarms(double hours, const std::string& only_world) {
  Table table({"world", "unmapped", "hours", "alarms", "an hour", "wrong poses", "of them doubted", "mean awareness",
               "position off mm, p95", "p99", "most", "most in an alarm"});
  Json results = Json::array();
  const auto drive = [&](std::string_view world, const char* name, const ClutteredDriveOptions& options) {
    int alarms = 0, wrong = 0, wrong_and_doubted = 0, scans = 0;
    bool was_alarm = false;
    double awareness = 0.0, off_in_alarm = 0.0;
    std::vector<double> off;
    drive_among_things(world, options, hours * 3600.0, 11, [&](const Fix& fix, const Pose2& truth) {
      const bool is_wrong = !is_right(fix.pose, truth);
      const bool alarm = !is_wrong && fix.quality.doubted();
      alarms += alarm && !was_alarm;
      was_alarm = alarm;
      wrong += is_wrong;
      wrong_and_doubted += is_wrong && fix.quality.doubted();
      awareness += fix.quality.awareness;
      ++scans;
      off.push_back(1e3 * distance(fix.pose, truth).translation);
      if (alarm) off_in_alarm = std::max(off_in_alarm, off.back());
    });
    const double simulated = scans / 40.0 / 3600.0;
    table.add({std::string(world), name, text("%.2f", simulated), text("%d", alarms), text("%.2f", alarms / simulated),
               text("%d", wrong), text("%d", wrong_and_doubted), text("%.2f", awareness / scans),
               text("%.1f", quantile(off, 0.95)), text("%.1f", quantile(off, 0.99)), text("%.1f", quantile(off, 1.0)),
               text("%.1f", off_in_alarm)});
    results.push_back({{"world", world},
                       {"unmapped", name},
                       {"hours", simulated},
                       {"alarms", alarms},
                       {"wrong", wrong},
                       {"wrong_and_doubted", wrong_and_doubted},
                       {"position_off_p95_mm", quantile(off, 0.95)}});
  };
  for (const std::string_view world : trial_world_names()) {
    if (!only_world.empty() && world != only_world) continue;
    drive(world, "0 %", {.unmapped = 0.0});
    drive(world, "40 %", {.unmapped = 0.4});
    drive(world, "40 %, walking", {.unmapped = 0.4, .moving = true});
  }
  table.print();
  return results;
}

Json calibration(int count, const std::string& samples) {
  Reliability by_scan, averaged;
  std::ofstream csv;
  if (!samples.empty()) csv.open(samples);
  if (csv) csv << "right,explained,beside,violations,spread\n";
  const std::uint64_t first = samples.empty() ? 50000 : 1000;  // what is measured is not what was fitted to
  int seen = 0;
  const auto add = [&](const Fix& fix, bool right) {
    by_scan.add(fix.quality.scan_probability, right);
    averaged.add(fix.quality.probability, right);
    const Evidence& evidence = fix.quality.evidence;
    if (csv && ++seen % 10 == 0)
      csv << right << ',' << evidence.explained << ',' << evidence.beside << ',' << evidence.violations << ','
          << evidence.spread << '\n';
  };
  for (const double unmapped : {0.0, 0.2, 0.4, 0.6})
    for (const std::string_view world : trial_world_names())
      for (int k = 0; k < count; k += 5) {
        const int gone = k % 2 == 0 ? 0 : 2;
        JumpTrials trials(world, first + static_cast<std::uint64_t>(k), gone);
        trials.watch(add);
        for (int n = 0; n < 5; ++n) trials.draw(unmapped);
        drive_among_things(world, {.unmapped = unmapped, .furniture_gone = gone}, 25.0,
                           first + 1000 + static_cast<std::uint64_t>(k),
                           [&](const Fix& fix, const Pose2& truth) { add(fix, is_right(fix.pose, truth)); });
      }
  Table table({"told", "scans", "right by one scan's word", "scans", "right by the average's"});
  for (std::size_t k = 0; k < 10; ++k) {
    const auto share = [&](const Reliability& bins) {
      return bins.all[k] > 0 ? text("%.1f %%", 100.0 * bins.right[k] / bins.all[k]) : std::string("-");
    };
    table.add({text("%zu to %zu %%", 10 * k, 10 * k + 10), text("%d", by_scan.all[k]), share(by_scan),
               text("%d", averaged.all[k]), share(averaged)});
  }
  table.print();
  std::printf("Brier score: %.4f by one scan, %.4f averaged\n", by_scan.brier(), averaged.brier());
  return bins_json(by_scan, averaged);
}

/// A localizer's update with and without the look at its quality, in turns.
Json cost() {
  Table table({"world", "update us", "with quality us", "more us"});
  Json results = Json::array();
  for (const std::string_view name : trial_world_names()) {
    const World world = trial_world(name);
    const LidarModel lidar = hokuyo_utm30lx();
    Random random(5);
    const PointMap2::Pointer map = PointMap2::create(sample_map(world, random));
    LocalizerOptions bare;
    bare.quality.rays = 0;
    Localizer without(map, bare), with(map);
    std::vector<double> of_without, of_with, more;
    for (int place = 0; place < 200; ++place) {
      const Pose2 truth = place_beside_route(world, random);
      const LaserScan seen = scan(world, truth, lidar, random);
      std::vector<double> a, b;
      for (int round = 0; round < 11; ++round) {
        without.set_pose(truth);
        with.set_pose(truth);
        const Stopwatch first;
        without.update(seen);
        a.push_back(first.microseconds());
        const Stopwatch second;
        with.update(seen);
        b.push_back(second.microseconds());
      }
      of_without.push_back(quantile(a, 0.5));
      of_with.push_back(quantile(b, 0.5));
      more.push_back(of_with.back() - of_without.back());
    }
    table.add({std::string(name), text("%.1f", quantile(of_without, 0.5)), text("%.1f", quantile(of_with, 0.5)),
               text("%.1f", quantile(more, 0.5))});
    results.push_back({{"world", name}, {"update_us", quantile(of_without, 0.5)}, {"more_us", quantile(more, 0.5)}});
  }
  table.print();
  return results;
}

void doubt(const Words& words) {
  const std::string& only = words["--only"];
  const int count = static_cast<int>(words.number("--jumps"));
  Json results;
  const auto wanted = [&](const char* name) { return only.empty() || only == name; };
  if (wanted("jumps")) results["jumps"] = jumps(count, 0);
  if (wanted("recovery")) results["recovery"] = jumps(count, 2000);
  if (wanted("alarms")) results["alarms"] = false_alarms(words.number("--hours"), words["--world"]);
  if (wanted("calibration")) results["calibration"] = calibration(std::max(5, count / 10), words["--samples"]);
  if (wanted("cost")) results["cost"] = cost();
  save_results("doubt", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] {
    doubt(
        Words(argc, argv, {{"--jumps", "500"}, {"--hours", "1"}, {"--only", ""}, {"--world", ""}, {"--samples", ""}}));
  });
}
