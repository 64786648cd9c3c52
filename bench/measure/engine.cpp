// SPDX-License-Identifier: Apache-2.0
// the index and the match in the plane: memory, building, first fix, insertion, cost of outputs, instruction sets
//
// scripts/measure engine [--rounds 15] [--largest 1000000] [--long-run 10000]
//
// Contenders take turns, a round of all scans each; medians of all times. Larger maps are copies of the
// corridor, 40 m apart: the same density, a larger building.
#include <atomic>
#include <thread>

#include <slamicp/map/point_map.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/simulation/random.hpp>

#include "scene.hpp"

namespace slamicp::measure {
namespace {

constexpr double pitch = 40.0;  // from one copy of the corridor to the next [m]

PointCloud2 copies_of(const PointCloud2& corridor, std::size_t points) {
  const auto copies = std::max<std::size_t>(1, (points + corridor.size() / 2) / corridor.size());
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(copies))));
  PointCloud2 all;
  all.reserve(copies * corridor.size());
  for (std::size_t k = 0; k < copies; ++k) {
    const Point2 shift(pitch * static_cast<double>(k % side), pitch * static_cast<double>(k / side));
    for (const Point2& point : corridor) all.push_back(point + shift);
  }
  return all;
}

/// Spoils the order that a simulator wrote points in: a map file may have any.
void shuffle(PointCloud2& points) {
  Random random(1);
  for (std::size_t k = points.size(); k > 1; --k)
    std::swap(points[k - 1], points[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(k)))]);
}

Outputs all_but_the_map() {
  Outputs wanted = Outputs::all();
  wanted.updated_map = false;
  return wanted;
}

void matches(const Scene& scene, int rounds, Json& results) {
  struct Row {
    std::string name;
    Outputs wanted;
    Icp<2> icp;
    std::vector<double> round_times = {}, times = {}, errors = {};
    double quietest = 1e9;  // least median of a round [us]
    double passes = 0.0, iterations = 0.0;
    std::size_t failures = 0;
  };
  std::vector<Row> rows;
  const auto add = [&](const std::string& name, InstructionSet set, const Outputs& wanted) {
    IcpOptions options;
    options.instruction_set = set;
    if (is_available(set)) rows.push_back(Row{name, wanted, Icp<2>(options)});
  };
  add("pose only", InstructionSet::best, {});
  add("pose, outliers", InstructionSet::best, {.outlier_indices = true});
  add("pose, transformed scan", InstructionSet::best, {.transformed_scan = true});
  add("pose, mean distance", InstructionSet::best, {.mean_inlier_distance = true});
  add("all but the updated map", InstructionSet::best, all_but_the_map());
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::sse4,
                                   InstructionSet::neon, InstructionSet::portable, InstructionSet::scalar})
    add(std::string("pose, outliers: ") + to_string(set), set, {.outlier_indices = true});

  const IndexedPoints<2> map(scene.map);
  for (int round = 0; round < rounds; ++round)
    for (Row& row : rows) {
      for (const Trial& trial : scene.trials) {
        const Stopwatch watch;
        const IcpResult2& result = row.icp.align(map, scene.scans[trial.scan], trial.guess, row.wanted);
        row.round_times.push_back(watch.microseconds());
        if (round > 0) continue;
        const PoseDistance off = distance(result.pose, trial.truth);
        row.errors.push_back(1e3 * off.translation);
        row.failures += off.translation > 0.1 || deg_per_rad * off.rotation > 1.0 ? 1U : 0U;
        row.iterations += result.iterations;
        row.passes += static_cast<double>(result.searches) / static_cast<double>(scene.scans[trial.scan].size());
      }
      row.quietest = std::min(row.quietest, quantile(row.round_times, 0.5));
      row.times.insert(row.times.end(), row.round_times.begin(), row.round_times.end());
      row.round_times.clear();
    }
  const double reference = quantile(rows[1].times, 0.5);
  const auto trials = static_cast<double>(scene.trials.size());
  Table table({"match, " + scene.name, "us median", "quietest round", "p99", "ratio", "steps", "full passes",
               "error mm mean / p95 / max", "failures"});
  for (const Row& row : rows) {
    const double median = quantile(row.times, 0.5);
    table.add({row.name, text("%.1f", median), text("%.1f", row.quietest), text("%.1f", quantile(row.times, 0.99)),
               text("%.2f", median / reference), text("%.2f", row.iterations / trials),
               text("%.2f", row.passes / trials),
               text("%.2f / %.2f / %.2f", mean(row.errors), quantile(row.errors, 0.95), quantile(row.errors, 1.0)),
               text("%zu of %zu", row.failures, scene.trials.size())});
    results["match"][scene.name].push_back({{"name", row.name},
                                            {"median_us", median},
                                            {"quietest_round_us", row.quietest},
                                            {"p99_us", quantile(row.times, 0.99)},
                                            {"steps", row.iterations / trials},
                                            {"full_passes", row.passes / trials}});
  }
  table.print();
}

/// With all of the second-level cache full of something else before each scan, as on a robot that runs other programs.
void cold(const Scene& scene, Json& results) {
  std::vector<char> other(std::size_t{4} << 20U, 1);
  const IndexedPoints<2> map(scene.map);
  Icp<2> icp;
  std::vector<double> times;
  std::size_t sum = 0;
  for (int round = 0; round < 3; ++round)
    for (const Trial& trial : scene.trials) {
      for (std::size_t k = 0; k < other.size(); k += 64) sum += static_cast<std::size_t>(other[k]++);
      const Stopwatch watch;
      icp.align(map, scene.scans[trial.scan], trial.guess, {.outlier_indices = true});
      times.push_back(watch.microseconds());
    }
  std::printf("second-level cache evicted before each scan (%zu): median %.1f us, p99 %.1f us\n\n", sum % 2,
              quantile(times, 0.5), quantile(times, 0.99));
  results["cold_us"] = quantile(times, 0.5);
}

void steadiness(const Scene& scene, std::size_t scans, Json& results) {
  const IndexedPoints<2> map(scene.map);
  Icp<2> icp;
  std::vector<double> best(scans, 1e9);
  for (int round = 0; round < 5; ++round)
    for (std::size_t k = 0; k < scans; ++k) {
      const Trial& trial = scene.trials[k % scene.trials.size()];
      const Stopwatch watch;
      icp.align(map, scene.scans[trial.scan], trial.guess, {.outlier_indices = true});
      best[k] = std::min(best[k], watch.microseconds());
    }
  const double ratio = quantile(best, 0.99) / quantile(best, 0.5);
  std::printf("%zu scans, each one's best of 5: median %.1f us, p99 / median %.2f, max %.1f us\n\n", scans,
              quantile(best, 0.5), ratio, quantile(best, 1.0));
  results["p99_over_median"] = ratio;
}

void cells(const Scene& scene, Json& results) {
  Table table({"cell cm", "bytes a point", "build ms, one thread", "us a scan, outliers"});
  for (const double cell : {0.02, 0.03, 0.05}) {
    std::vector<double> builds, times;
    for (int k = 0; k < 5; ++k) {
      const Stopwatch watch;
      const IndexedPoints<2> made(scene.map, {}, {.cell = cell});
      builds.push_back(watch.milliseconds());
    }
    const IndexedPoints<2> map(scene.map, {}, {.cell = cell});
    Icp<2> icp;
    for (int round = 0; round < 3; ++round)
      for (const Trial& trial : scene.trials) {
        const Stopwatch watch;
        icp.align(map, scene.scans[trial.scan], trial.guess, {.outlier_indices = true});
        times.push_back(watch.microseconds());
      }
    const double bytes = static_cast<double>(map.cells().memory()) / static_cast<double>(map.size());
    table.add({text("%.0f", 100.0 * cell), text("%.0f", bytes), text("%.1f", quantile(builds, 0.5)),
               text("%.1f", quantile(times, 0.5))});
    results["cells"].push_back({{"cell_m", cell}, {"bytes_a_point", bytes}, {"build_ms", quantile(builds, 0.5)}});
  }
  table.print();
}

/// 100 outliers as a box beside a wall leaves them, somewhere in a map.
PointCloud2 box_beside(const Point2& place, Random& random) {
  PointCloud2 points;
  for (int k = 0; k < 100; ++k) {
    const double along = 0.00695 * k;
    points.push_back(place + Point2(0.25 + std::min(along, 0.48), 0.25 + std::max(along - 0.48, 0.0)) +
                     Point2(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01)));
  }
  return points;
}

/// Inserts into a map while another thread localizes in it: the time of the insertion, and what the first match in the
/// new map takes more than a match takes else. The robot moves on from box to box.
std::vector<double> insertion_times(const PointMap2::Pointer& map, const Scene& scene) {
  std::atomic<bool> done{false};
  std::thread robot([&, first = map] {
    Icp<2> icp;
    for (std::size_t k = 0; !done; k = (k + 1) % scene.trials.size())
      icp.align(first->indexed(), scene.scans[scene.trials[k].scan], scene.trials[k].guess, {.outlier_indices = true});
  });
  std::vector<double> times;
  Random random(3);
  Icp<2> icp;
  constexpr std::size_t apart = 15;  // poses, about a metre: what a robot inserts, it did not insert before
  for (int repeat = 0; repeat < 8; ++repeat) {
    PointMap2::Pointer grown = map;
    for (std::size_t k = 0; k < scene.trials.size(); k += apart) {
      const Trial& trial = scene.trials[k];
      const PointCloud2& scan = scene.scans[trial.scan];
      const auto match = [&] {
        const Stopwatch watch;
        icp.align(grown->indexed(), scan, trial.guess, {.outlier_indices = true});
        return watch.microseconds();
      };
      match();
      const double before = match();
      const PointCloud2 added = box_beside(trial.truth * scan[scan.size() / 3], random);
      const Stopwatch watch;
      grown = grown->with_added(added);
      const double insertion = watch.microseconds();
      times.push_back(insertion + match() - before);
    }
  }
  done = true;
  robot.join();
  return times;
}

void sizes(const Scene& scene, std::size_t largest, Json& results) {
  Table table({"map points", "usable after ms", "first fix ms", "built after ms, 2 threads", "us a scan",
               "x the corridor's", "100 outliers inserted us median", "p90"});
  const IndexedPoints<2> corridor(scene.map);
  for (std::size_t points = 10000; points <= largest; points *= 10) {
    PointCloud2 cloud = copies_of(scene.map, points);
    shuffle(cloud);
    const Trial& first = scene.trials.front();
    std::vector<double> usable, fix;
    for (int k = 0; k < 3; ++k) {
      PointCloud2 raw = cloud;
      const Stopwatch watch;
      const auto lazy = PointMap2::create(std::move(raw), {}, {.eager = false});
      usable.push_back(watch.milliseconds());
      Icp<2>().align(lazy->indexed(), scene.scans[first.scan], first.guess, {.outlier_indices = true});
      fix.push_back(watch.milliseconds());
    }
    const Stopwatch watch;
    const auto map = PointMap2::create(std::move(cloud), {.threads = 2});
    const double built = watch.milliseconds();
    std::vector<double> here, small;
    Icp<2> icp_here, icp_small;
    for (int round = 0; round < 5; ++round)
      for (const Trial& trial : scene.trials) {
        const Stopwatch one;
        icp_small.align(corridor, scene.scans[trial.scan], trial.guess, {.outlier_indices = true});
        small.push_back(one.microseconds());
        const Stopwatch other;
        icp_here.align(map->indexed(), scene.scans[trial.scan], trial.guess, {.outlier_indices = true});
        here.push_back(other.microseconds());
      }
    const std::vector<double> insertion = insertion_times(map, scene);
    const double ratio = quantile(here, 0.5) / quantile(small, 0.5);
    table.add({text("%zu", map->size()), text("%.1f", quantile(usable, 0.5)), text("%.1f", quantile(fix, 0.5)),
               text("%.0f", built), text("%.1f", quantile(here, 0.5)), text("%.2f", ratio),
               text("%.0f", quantile(insertion, 0.5)), text("%.0f", quantile(insertion, 0.9))});
    results["sizes"].push_back({{"points", map->size()},
                                {"first_fix_ms", quantile(fix, 0.5)},
                                {"built_ms", built},
                                {"scan_us", quantile(here, 0.5)},
                                {"ratio", ratio},
                                {"insertion_us", quantile(insertion, 0.5)}});
  }
  table.print();
}

void engine(const Words& words) {
  Json results;
  const int rounds = static_cast<int>(words.number("--rounds"));
  std::printf("Best instruction set here: %s. One thread unless said.\n\n", to_string(best_instruction_set()));
  const Scene none = load_corridor("none");
  matches(none, rounds, results);
  matches(load_corridor("box"), rounds, results);
  cold(none, results);
  steadiness(none, static_cast<std::size_t>(words.number("--long-run")), results);
  cells(none, results);
  sizes(none, static_cast<std::size_t>(words.number("--largest")), results);
  save_results("engine", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] {
    engine(Words(argc, argv, {{"--rounds", "15"}, {"--largest", "1000000"}, {"--long-run", "10000"}}));
  });
}
