// SPDX-License-Identifier: Apache-2.0
// hours of simulated drives without obstacles: false stops, false obstacles, path tracking by speed, x real time
//
// scripts/measure false_stops [--hours 10] [--seed 1] [--map explored]   or --map sampled: without a survey's errors
//
// The robot is the slipping APR-02 with its 50 ms delay, the lidar a real Hokuyo; each drive has noise of its own.
#include <array>

#include <slamicp/evaluation/experiment_site.hpp>
#include <slamicp/evaluation/false_alarms.hpp>
#include <slamicp/simulation/agent_drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "support.hpp"

namespace slamicp::measure {
namespace {

/// What the drives at one speed came to.
struct Speed {
  double speed = 0.0;           // [m/s]
  double simulated = 0.0;       // [s]
  double taken = 0.0;           // [s]
  double true_squares = 0.0;    // of the way off the path, by the truth [m^2]
  double mapped_squares = 0.0;  // the same by the agent's own fixes
  double cycles = 0.0;
  std::size_t drives = 0;
  std::size_t unfinished = 0;
  FalseAlarms alarms;

  double true_rms_mm() const { return 1e3 * std::sqrt(true_squares / std::max(1.0, cycles)); }
  double mapped_rms_mm() const { return 1e3 * std::sqrt(mapped_squares / std::max(1.0, cycles)); }
  double per_hour(std::size_t count) const { return static_cast<double>(count) * 3600.0 / std::max(1.0, simulated); }
};

ExperimentSite site_with(const std::string& map) {
  ExperimentSite site = explore_site(1);
  if (map == "explored") return site;
  if (map != "sampled") throw std::invalid_argument("--map is explored or sampled");
  Random random(1);
  site.map = PointMap2::create(sample_map(site.world, random));
  return site;
}

void drive(const ExperimentSite& site, std::uint64_t seed, Speed& speed) {
  AgentDriveOptions options;
  options.agent.tracking.speed = speed.speed;
  options.seed = seed;
  const Stopwatch watch;
  speed.alarms.next_drive();
  const AgentDriveResult result = drive_agent(site.world, site.map, site.path, options, [&](const DriveMoment& now) {
    const Tracking& tracking = now.cycle.tracking;
    const PathPlace really =
        site.path->nearest(now.T_map_robot.translation(), tracking.travelled - 0.5, tracking.travelled + 0.5);
    speed.true_squares += really.cross_track * really.cross_track;
    speed.mapped_squares += tracking.cross_track * tracking.cross_track;
    ++speed.cycles;
    speed.alarms.add(now.cycle);
    return true;
  });
  speed.taken += watch.seconds();
  speed.simulated += result.seconds;
  speed.unfinished += result.finished ? 0 : 1;
  ++speed.drives;
}

void add_row(Table& table, const Speed& speed) {
  table.add({text("%.2f", speed.speed), text("%.2f", speed.simulated / 3600.0), text("%zu", speed.drives),
             text("%zu", speed.unfinished), text("%zu", speed.alarms.stops()), text("%zu", speed.alarms.slow_downs()),
             text("%zu", speed.alarms.confirmed().size()),
             text("%.2f", speed.per_hour(speed.alarms.confirmed().size())), text("%zu", speed.alarms.seen()),
             text("%.1f", speed.true_rms_mm()), text("%.1f", speed.mapped_rms_mm()),
             text("%.0f", speed.simulated / std::max(1e-9, speed.taken))});
}

Json to_json(const Speed& speed) {
  Json places = Json::array();
  for (const Point2& place : speed.alarms.confirmed()) places.push_back({place.x(), place.y()});
  return {{"speed", speed.speed},
          {"hours", speed.simulated / 3600.0},
          {"drives", speed.drives},
          {"unfinished", speed.unfinished},
          {"stops", speed.alarms.stops()},
          {"slow_downs", speed.alarms.slow_downs()},
          {"confirmed_obstacles", places},
          {"obstacles_of_single_scans", speed.alarms.seen()},
          {"true_rms_mm", speed.true_rms_mm()},
          {"mapped_rms_mm", speed.mapped_rms_mm()},
          {"times_real_time", speed.simulated / std::max(1e-9, speed.taken)}};
}

void false_stops(const Words& words) {
  const ExperimentSite site = site_with(words["--map"]);
  std::array<Speed, 5> speeds;
  for (std::size_t v = 0; v < speeds.size(); ++v) speeds[v].speed = 0.15 + 0.1 * static_cast<double>(v);
  const double wanted = 3600.0 * words.number("--hours") / static_cast<double>(speeds.size());
  auto seed = static_cast<std::uint64_t>(words.number("--seed"));
  for (Speed& speed : speeds)
    while (speed.simulated < wanted) drive(site, seed++, speed);

  Table table({"speed m/s", "hours", "drives", "unfinished", "stops", "slow-downs", "confirmed obstacles", "an hour",
               "in single scans", "off the path mm RMS, truth", "by its fixes", "x real time"});
  Json results = Json::array();
  double simulated = 0.0;
  std::size_t confirmed = 0;
  for (const Speed& speed : speeds) {
    add_row(table, speed);
    results.push_back(to_json(speed));
    simulated += speed.simulated;
    confirmed += speed.alarms.confirmed().size();
  }
  std::printf(
      "No obstacles stand there: whatever is found is false. Map: %s, %zu points. Confirmed: three scans in a "
      "row show it.\n\n",
      words["--map"].c_str(), site.map->size());
  table.print();
  std::printf("%.2f simulated hours: %.2f confirmed false obstacles an hour.\n", simulated / 3600.0,
              static_cast<double>(confirmed) * 3600.0 / simulated);
  for (const Speed& speed : speeds)
    for (const Point2& place : speed.alarms.confirmed())
      std::printf("  at %.2f m/s: %.2f m, %.2f m\n", speed.speed, place.x(), place.y());
  save_results("false_stops_" + words["--map"], results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] { false_stops(Words(argc, argv, {{"--hours", "10"}, {"--seed", "1"}, {"--map", "explored"}})); });
}
