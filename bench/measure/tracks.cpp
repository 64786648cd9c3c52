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
#include <slamicp/io/scan_log.hpp>
#include <slamicp/mapping/scan_odometry.hpp>

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
  Table table({"scanner", "scans", "people", "ids", "people a scan"});
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
    table.add({side, text("%zu", scans.size()), "", text("%zu", ids),
               text("%.2f", static_cast<double>(people) / static_cast<double>(scans.size()))});
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
  save_results("tracks", results);
}

}  // namespace
}  // namespace slamicp::measure

int main(int argc, char** argv) {
  using namespace slamicp::measure;
  return run([&] { tracks(Words(argc, argv, {{"--only", "all"}, {"--hours", "10"}, {"--seed", "1"}})); });
}
