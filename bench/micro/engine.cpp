// SPDX-License-Identifier: Apache-2.0
// Micro-benchmarks of the engine (Google Benchmark), on a simulated corridor: a query, a match, a build, an insertion.
#include <benchmark/benchmark.h>

#include <slamicp/registration/icp.hpp>
#include <slamicp/simulation/random.hpp>

namespace slamicp {
namespace {

PointCloud2 corridor_map() {
  PointCloud2 map;
  Random random(1);
  for (double x = 0.0; x < 20.0; x += 0.0074)
    for (const double y : {0.0, 2.5}) map.emplace_back(x, y + 0.01 * random.normal());
  for (double y = 0.0; y < 2.5; y += 0.0074) map.emplace_back(20.0 + 0.01 * random.normal(), y);
  return map;
}

PointCloud2 corridor_scan() {
  PointCloud2 scan;
  Random random(2);
  for (int beam = 0; beam < 1081; ++beam) {
    const double angle = (-135.0 + 0.25 * beam) * 3.14159265358979 / 180.0;
    const double c = std::cos(angle), s = std::sin(angle);
    double range = c > 0.0 ? 12.0 / c : 30.0;  // the end wall, from the middle of the corridor
    if (s != 0.0) range = std::min(range, 1.25 / std::abs(s));
    if (range < 30.0) scan.emplace_back((range + 0.01 * random.normal()) * c, (range + 0.01 * random.normal()) * s);
  }
  return scan;
}

const Pose2 standing{8.0, 1.25, 0.0};

template <typename Index>
void query(benchmark::State& state) {
  const Index map(corridor_map());
  const PointCloud2 scan = corridor_scan();
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(map.nearest(standing * scan[k], 0.3));
    k = k + 1 == scan.size() ? 0 : k + 1;
  }
}

/// A step over all points: two matches that differ by one step, see the difference.
void match(benchmark::State& state, InstructionSet set, bool coarse_to_fine, int steps) {
  if (!is_available(set)) return state.SkipWithError("not on this machine");
  const IndexedPoints<2> map(corridor_map());
  const PointCloud2 scan = corridor_scan();
  Icp<2> icp({.max_iterations = steps, .coarse_to_fine = coarse_to_fine, .instruction_set = set});
  for (auto _ : state) benchmark::DoNotOptimize(icp.align(map, scan, {8.03, 1.28, 0.02}).pose);
}

void build(benchmark::State& state) {
  const PointCloud2 map = corridor_map();
  for (auto _ : state) benchmark::DoNotOptimize(IndexedPoints<2>(map).size());
}

void insert(benchmark::State& state) {
  const IndexedPoints<2> map(corridor_map());
  PointCloud2 box;
  for (int k = 0; k < 100; ++k) box.emplace_back(9.0 + 0.005 * k, 1.0);
  for (auto _ : state) benchmark::DoNotOptimize(map.with_added(box).size());
}

BENCHMARK(query<IndexedPoints<2>>);
BENCHMARK(query<KdTree<2>>);
BENCHMARK_CAPTURE(match, best, InstructionSet::best, true, 50);
BENCHMARK_CAPTURE(match, best_one_full_pass, InstructionSet::best, false, 1);
BENCHMARK_CAPTURE(match, best_two_full_passes, InstructionSet::best, false, 2);
BENCHMARK_CAPTURE(match, avx512, InstructionSet::avx512, true, 50);
BENCHMARK_CAPTURE(match, avx2, InstructionSet::avx2, true, 50);
BENCHMARK_CAPTURE(match, sse4, InstructionSet::sse4, true, 50);
BENCHMARK_CAPTURE(match, neon, InstructionSet::neon, true, 50);
BENCHMARK_CAPTURE(match, portable, InstructionSet::portable, true, 50);
BENCHMARK_CAPTURE(match, scalar, InstructionSet::scalar, true, 50);
BENCHMARK(build)->Unit(benchmark::kMillisecond);
BENCHMARK(insert)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace slamicp

BENCHMARK_MAIN();
