// SPDX-License-Identifier: Apache-2.0
// obstacles followed from scan to scan: legs and people in real logs, simulated people, what stands still, the cost
//
// scripts/measure tracks [--only legs|demo|people|still|cost] [--hours 10] [--seed 1]
//
// Asked: of the 324 labelled legs at least 85 % within 0.3 m, with the one setting that gives at most 0.1 leg tracks a
// scan where nobody is; no static obstacle called moving in 10 h; obstacles and tracks at most one more bare match.
#include <cstdlib>
#include <set>

#include <slamicp/evaluation/leg_trial.hpp>
#include <slamicp/evaluation/recorded_drive.hpp>
#include <slamicp/evaluation/tracking_score.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/mapping/scan_odometry.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/simulation/agent_drive.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/crowd.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "support.hpp"
#include "support/leg_labels.hpp"

namespace slamicp::measure {
namespace {

constexpr double reach = 0.3;  // of a label [m]

std::vector<LaserScan> scans_of(const std::string& bag, const std::string& topic) {
  ScanLogOptions options;
  options.scan_topics = {topic};
  return open_scan_log(data("obstacles/" + bag), options).scans;
}

Trajectory standing(const std::vector<LaserScan>& scans) {
  Trajectory trajectory;
  for (const LaserScan& scan : scans) trajectory.push_back({scan.stamp, {}});
  return trajectory;
}

Trajectory by_scan_odometry(const std::vector<LaserScan>& scans) {
  ScanOdometry odometry;
  for (const LaserScan& scan : scans) odometry.add(scan);
  return odometry.trajectory();
}

/// The way of each track, by id.
using Ways = std::map<int, PointCloud2>;

Colour colour_of_track(int id) {
  constexpr Colour several[] = {{214, 39, 40},  {31, 119, 180}, {44, 160, 44}, {148, 103, 189},
                                {255, 127, 14}, {23, 190, 207}, {140, 86, 75}, {227, 119, 194}};
  return several[static_cast<std::size_t>(id) % std::size(several)];
}

void draw(const std::string& name, const std::string& title, const PointMap2& map, const Ways& ways,
          const std::map<int, std::string>& labels) {
  PictureOptions options;
  options.title = title;
  Picture picture(options);
  picture.points(to_cloud<2>(map.points()), colours::map, 1.2, "background");
  for (const auto& [id, way] : ways) {
    picture.polyline(way, colour_of_track(id), 1.5);
    const auto label = labels.find(id);
    picture.label(way.back(), text("%d %s", id, label != labels.end() ? label->second.c_str() : ""),
                  colour_of_track(id));
  }
  save_picture(name, picture);
}

/// Goes through a log, and keeps the ways of legs and people.
LegScore score_legs(const std::vector<LaserScan>& scans, const Trajectory& trajectory,
                    const std::vector<PointCloud2>& labels, const std::string& name) {
  const PointMap2::Pointer map = background_of(scans, trajectory);
  LegScore score;
  Ways ways;
  std::map<int, std::string> kinds;
  std::size_t k = 0;
  follow_log(scans, map, trajectory.front().pose, setup_for_legs(), [&](const TrackedScan& tracked) {
    add_legs(tracked, k < labels.size() ? PointView<2>(labels[k]) : PointView<2>(), reach, score);
    ++k;
    for (const Track& track : tracked.tracks)
      if (track.kind != TrackKind::thing && track.state == TrackState::confirmed) {
        ways[track.id].push_back(track.position);
        kinds[track.id] = to_string(track.kind);
      }
  });
  draw(name, name + ": legs and people", *map, ways, kinds);
  return score;
}

Json legs() {
  Table table({"log", "scans", "labels", "recall", "leg tracks a scan"});
  Json results = Json::array();
  const auto add = [&](const std::string& name, const LegScore& score) {
    table.add({name, text("%zu", score.scans), text("%zu", score.labels),
               score.labels > 0 ? text("%.3f", score.recall()) : "-", text("%.3f", score.leg_tracks_a_scan())});
    results.push_back({{"log", name}, {"recall", score.recall()}, {"leg_tracks_a_scan", score.leg_tracks_a_scan()}});
  };
  const std::string positive = "leg_positive_1_extracted.bag";
  const std::vector<LaserScan> walked = scans_of(positive, "/training_scan");
  add("leg_positive_1",
      score_legs(walked, standing(walked), test::read_leg_labels(data("obstacles/" + positive)), "leg_positive_1"));
  LegScore all;
  for (const std::string side : {"left", "rear", "right"}) {
    const std::vector<LaserScan> empty = scans_of("leg_negative_2.bag", "/" + side + "_scan");
    const LegScore one = score_legs(empty, by_scan_odometry(empty), {}, "leg_negative_2_" + side);
    add("leg_negative_2 " + side, one);
    all.scans += one.scans;
    all.leg_tracks += one.leg_tracks;
  }
  add("leg_negative_2, all three", all);
  table.print();
  return results;
}

Json demo() {
  Table table({"scanner", "scans", "ids of people", "people a scan"});
  Json results = Json::array();
  for (const std::string side : {"front", "rear"}) {
    const std::vector<LaserScan> scans = scans_of("obstacle_detector_scans_demo.bag", "/" + side + "_scan");
    const PointMap2::Pointer map = background_of(scans, standing(scans));
    Ways ways;
    std::map<int, std::string> kinds;
    std::size_t people = 0;
    follow_log(scans, map, {}, setup_for_legs(), [&](const TrackedScan& tracked) {
      for (const Track& track : tracked.tracks) {
        if (track.state != TrackState::confirmed || track.kind == TrackKind::thing) continue;
        ways[track.id].push_back(track.position);
        kinds[track.id] = text("%s %.1f-%.1f s", to_string(track.kind), track.born - scans[0].stamp,
                               track.last_seen - scans[0].stamp);
        people += track.kind == TrackKind::person;
      }
    });
    std::size_t ids = 0;
    for (const auto& [id, kind] : kinds) {
      ids += kind.starts_with("person");
      std::printf("%s %d: %s, %zu scans\n", side.c_str(), id, kind.c_str(), ways[id].size());
    }
    draw("demo_" + side, "obstacle_detector_scans_demo, " + side + ": legs and people", *map, ways, kinds);
    results.push_back({{"scanner", side}, {"ids_of_people", ids}});
    table.add({side, text("%zu", scans.size()), text("%zu", ids),
               text("%.2f", static_cast<double>(people) / static_cast<double>(scans.size()))});
  }
  table.print();
  return results;
}

/// How many returns of a scan are of somebody.
int beams_on(const PersonOutline& outline, const Fix& fix, const Pose2& truth) {
  int beams = 0;
  for (const Point2& in_robot : fix.scan.in_robot) {
    const Point2 in_map = truth * in_robot;
    for (std::size_t k = 0; k < outline.count; ++k)
      beams += std::abs((in_map - outline.centres[k]).norm() - outline.radius) < 0.05;
  }
  return beams;
}

/// Everybody as they really are; who shows less than eight beams, or is more than 8 m away, does not count.
std::vector<TrackedTruth> truths_of(const World& world, const Fix& fix, const Pose2& robot) {
  std::vector<TrackedTruth> truths;
  for (std::size_t k = 0; k < world.people.size(); ++k) {
    const Person& person = world.people[k];
    const Point2 place = pose_at(person, fix.stamp).translation();
    const Vector<2> velocity = (pose_at(person, fix.stamp + 0.01).translation() - place) / 0.01;
    const bool counts =
        (place - robot.translation()).norm() < 8.0 && beams_on(outline_at(person, fix.stamp), fix, robot) >= 8;
    truths.push_back({static_cast<int>(k), place, velocity, counts});
  }
  return truths;
}

/// Of all that moves, or has moved and is as wide as somebody.
std::vector<TrackedGuess> guesses_of(std::span<const Track> tracks) {
  std::vector<TrackedGuess> guesses;
  for (const Track& track : tracks)
    if (track.state == TrackState::confirmed && (track.kind != TrackKind::thing || track.motion == TrackMotion::moving))
      guesses.push_back({track.id, track.position, track.velocity});
  return guesses;
}

/// From when somebody counts until they are found the first time [s].
struct Delays {
  std::map<int, double> since;
  std::set<int> found;
  std::vector<double> seconds;

  void add(const std::vector<TrackedTruth>& truths, const std::vector<TrackedGuess>& guesses, double stamp) {
    for (const TrackedTruth& truth : truths) {
      if (truth.counts) since.try_emplace(truth.id, stamp);
      if (!since.contains(truth.id) || found.contains(truth.id)) continue;
      for (const TrackedGuess& guess : guesses)
        if ((guess.position - truth.position).norm() < 0.5 && found.insert(truth.id).second)
          seconds.push_back(stamp - since[truth.id]);
    }
  }
};

Json people(std::uint64_t first_seed) {
  constexpr int crowd = 12;
  constexpr std::uint64_t runs = 3;
  const World empty = corridor_world();
  const auto& waypoints = route(empty, "reference").waypoints;
  Random random(1);
  const PointMap2::Pointer map = PointMap2::create(sample_map(empty, random));
  Table table({"layout", "truths", "MOTA", "recall", "false a scan", "switches", "MOTP m", "velocity m/s RMS",
               "seconds to find, median", "p95"});
  Json results = Json::array();
  for (const auto& [layout, name] :
       {std::pair(CrowdLayout::crossing, "crossing"), std::pair(CrowdLayout::along, "along"),
        std::pair(CrowdLayout::random_walk, "random walk")}) {
    TrackingScore score;
    std::vector<double> seconds;
    for (std::uint64_t seed = first_seed; seed < first_seed + runs; ++seed) {
      CrowdOptions people;
      people.people = crowd;
      people.layout = layout;
      people.seed = seed;
      const World world = with_crowd(empty, waypoints, people);
      DriveOptions drive;
      drive.seed = seed;
      drive.speed = 0.5;
      drive.lidar = real_hokuyo_utm30lx();
      const SimulatedRun run = simulate_drive(world, waypoints, drive);
      score.next_run();
      Delays delays;
      std::size_t k = 0;
      TrackingSetup setup;
      setup.localization.outlier_distance = 0.15;
      follow_log(run.scans, map, run.truth.front().pose, setup, [&](const TrackedScan& tracked) {
        const std::vector<TrackedTruth> truths = truths_of(world, tracked.fix, run.truth[k++].pose);
        const std::vector<TrackedGuess> guesses = guesses_of(tracked.tracks);
        score.add(truths, guesses);
        delays.add(truths, guesses, tracked.fix.stamp);
      });
      seconds.insert(seconds.end(), delays.seconds.begin(), delays.seconds.end());
    }
    const double recall = static_cast<double>(score.found()) / std::max(1.0, static_cast<double>(score.truths()));
    table.add({name, text("%zu", score.truths()), text("%.3f", score.mota()), text("%.3f", recall),
               text("%.3f", static_cast<double>(score.false_ones()) / static_cast<double>(score.frames())),
               text("%zu", score.switches()), text("%.3f", score.motp()), text("%.2f", score.velocity_rmse()),
               text("%.2f", quantile(seconds, 0.5)), text("%.2f", quantile(seconds, 0.95))});
    results.push_back({{"layout", name},
                       {"mota", score.mota()},
                       {"recall", recall},
                       {"switches", score.switches()},
                       {"motp", score.motp()},
                       {"velocity_rmse", score.velocity_rmse()},
                       {"seconds_to_find", quantile(seconds, 0.5)}});
  }
  std::printf(
      "%d people, %llu drives of each kind through the corridor. A truth: somebody who shows 8 beams within "
      "8 m, in one scan.\n\n",
      crowd, static_cast<unsigned long long>(runs));
  table.print();
  return results;
}

/// Robots that drive past the twelve obstacles, and past all of those that leave the way free at once.
Json still(double hours, std::uint64_t seed) {
  const ExperimentSite site = explore_site(1);
  World all = site.world;
  for (const char* name : {"A2", "B3", "C3", "D3"}) all = with_obstacle(all, corridor_obstacle(name));
  constexpr const char* names[] = {"A1", "A2", "A3", "B1", "B2", "B3", "C1", "C2", "C3", "D1", "D2", "D3"};
  double simulated = 0.0;
  std::size_t scans = 0, ids = 0, moving = 0, stops = 0;
  std::vector<double> seconds;
  const Stopwatch watch;
  for (std::size_t drive = 0; simulated < 3600.0 * hours; ++drive, ++seed) {
    const bool with_all = drive % 4 == 3;
    const World world = with_all ? all : with_obstacle(site.world, corridor_obstacle(names[(drive * 3 / 4) % 12]));
    AgentDriveOptions options;
    options.agent.tracking.speed = 0.15 + 0.1 * static_cast<double>(drive % 5);
    options.agent.evaluation.corridor_half_width = 0.3;
    options.seed = seed;
    options.most_seconds = 300.0;
    std::set<int> seen, moved, decided;
    Decision last = Decision::ignore;
    const AgentDriveResult result = drive_agent(world, site.map, site.path, options, [&](const DriveMoment& now) {
      ++scans;
      for (const Track& track : now.cycle.tracks) {
        if (track.state == TrackState::tentative) continue;
        seen.insert(track.id);
        if (track.motion == TrackMotion::moving) moved.insert(track.id);
        if (track.motion == TrackMotion::still && decided.insert(track.id).second)
          seconds.push_back(now.scan.stamp - track.born);
      }
      stops += now.cycle.decision == Decision::stop && last != Decision::stop;
      last = now.cycle.decision;
      return true;
    });
    simulated += result.seconds;
    ids += seen.size();
    moving += moved.size();
  }
  std::printf(
      "%.2f simulated hours, %zu scans, real Hokuyo: %zu tracks of things that stand, %zu of them called moving; "
      "%zu stops; static after %.2f s, median; %.0f x real time\n\n",
      simulated / 3600.0, scans, ids, moving, stops, quantile(seconds, 0.5), simulated / watch.seconds());
  return {{"hours", simulated / 3600.0},
          {"tracks", ids},
          {"called_moving", moving},
          {"stops", stops},
          {"seconds_to_static", quantile(seconds, 0.5)}};
}

/// The bare match, what finds obstacles and what follows them, by turns, scan by scan.
Json cost() {
  const ExperimentSite site = explore_site(1);
  DrivePlan plan;
  plan.obstacle = "D3";
  const RecordedDrive drive = record_drive(site, plan);
  const LocalizerOptions localization = agent_of(plan).localization;
  std::vector<std::vector<double>> match(drive.scans.size()), find(drive.scans.size()), follow(drive.scans.size());
  std::vector<std::size_t> outliers(drive.scans.size());
  for (int repeat = 0; repeat < 5; ++repeat) {
    Localizer localizer(site.map, localization);
    localizer.set_pose(drive.samples.front().truth);
    Icp<2> icp(localization.icp());
    ObstacleFinder finder(agent_of(plan).detection);
    ObstacleTracker tracker;
    for (std::size_t k = 0; k < drive.scans.size(); ++k) {
      const Fix& fix = localizer.update(drive.scans[k]);
      const Stopwatch of_match;
      icp.align(site.map->indexed(), fix.scan.in_robot, fix.predicted, Outputs{});
      match[k].push_back(of_match.microseconds());
      const Stopwatch of_find;
      const std::span<const Obstacle> obstacles = finder.find(fix, drive.scans[k]);
      find[k].push_back(of_find.microseconds());
      const Stopwatch of_follow;
      tracker.update(fix, drive.scans[k], obstacles);
      follow[k].push_back(of_follow.microseconds());
      outliers[k] = fix.outliers().size();
    }
  }
  Table table({"scans", "count", "bare match us", "find obstacles us", "follow them us", "both / match"});
  Json results = Json::array();
  for (const auto& [what, least, most] : {std::tuple("at least 80 outliers", 80, 1000), std::tuple("all", 0, 1000)}) {
    std::vector<double> a, b, c;
    for (std::size_t k = 1; k < drive.scans.size(); ++k) {
      const int count = static_cast<int>(outliers[k]);
      if (count < least || count > most) continue;
      a.push_back(quantile(match[k], 0.5));
      b.push_back(quantile(find[k], 0.5));
      c.push_back(quantile(follow[k], 0.5));
    }
    const double ratio = (quantile(b, 0.5) + quantile(c, 0.5)) / std::max(1e-9, quantile(a, 0.5));
    table.add({what, text("%zu", a.size()), text("%.1f", quantile(a, 0.5)), text("%.1f", quantile(b, 0.5)),
               text("%.1f", quantile(c, 0.5)), text("%.2f", ratio)});
    results.push_back({{"scans", what}, {"ratio", ratio}});
  }
  table.print();
  return results;
}

void tracks(const Words& words) {
  const std::string& only = words["--only"];
  Json results;
  const auto part = [&](const std::string& name, const auto& measurement) {
    if (only == "all" || only == name) results[name] = measurement();
  };
  part("legs", legs);
  part("demo", demo);
  part("people", [&] { return people(static_cast<std::uint64_t>(words.number("--seed"))); });
  part("still", [&] { return still(words.number("--hours"), static_cast<std::uint64_t>(words.number("--seed"))); });
  part("cost", cost);
  save_results("tracks", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] { tracks(Words(argc, argv, {{"--only", "all"}, {"--hours", "10"}, {"--seed", "1"}})); });
}
