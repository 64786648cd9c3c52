// SPDX-License-Identifier: Apache-2.0
#include "throughput.hpp"

#include <atomic>
#include <barrier>
#include <thread>

#include "measure/support.hpp"

namespace slamicp::bench {
namespace {

/// Localizes scan after scan from `first` on, until told to stop. Returns how many.
std::size_t localize_until(const std::atomic<bool>& stop, const Scene& scene, Matcher& matcher, std::size_t first) {
  Estimate estimate;
  std::size_t done = 0;
  for (; !stop.load(std::memory_order_relaxed); ++done) {
    const Trial& trial = scene.trials[(first + done) % scene.trials.size()];
    matcher.localize(trial.scan, trial.guess, estimate);
  }
  return done;
}

double count_scans(const Scene& scene, const MakeMatcher& make, int threads, double seconds) {
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> scans = 0;
  std::barrier start(threads + 1);
  std::vector<std::thread> crew;
  const auto count = static_cast<std::size_t>(threads);
  for (std::size_t k = 0; k < count; ++k)
    crew.emplace_back([&, k] {
      const std::unique_ptr<Matcher> matcher = make();
      Estimate warm_up;
      matcher->localize(scene.trials.front().scan, scene.trials.front().guess, warm_up);
      start.arrive_and_wait();
      scans += localize_until(stop, scene, *matcher, k * scene.trials.size() / count);
    });
  start.arrive_and_wait();
  const measure::Stopwatch watch;
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  stop = true;
  for (std::thread& thread : crew) thread.join();
  return static_cast<double>(scans) / watch.seconds();
}

}  // namespace

std::vector<std::vector<double>> scans_per_second(const Scene& scene, std::span<const Contender> contenders,
                                                  std::span<const int> threads, int rounds) {
  constexpr double seconds_of_a_run = 1.0;
  std::vector<MakeMatcher> makers;
  for (const Contender& contender : contenders) makers.push_back(contender.prepare(scene.map));
  std::vector counts(threads.size(), std::vector(makers.size(), std::vector<double>()));
  for (int round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < makers.size(); ++k)
      for (std::size_t t = 0; t < threads.size(); ++t)
        counts[t][k].push_back(count_scans(scene, makers[k], threads[t], seconds_of_a_run));

  std::vector medians(threads.size(), std::vector<double>(makers.size()));
  for (std::size_t t = 0; t < threads.size(); ++t)
    for (std::size_t k = 0; k < makers.size(); ++k) medians[t][k] = measure::quantile(counts[t][k], 0.5);
  return medians;
}

}  // namespace slamicp::bench
