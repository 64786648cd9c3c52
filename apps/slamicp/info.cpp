// SPDX-License-Identifier: Apache-2.0
// slamicp info: what a file holds.
#include <memory>
#include <numbers>
#include <set>

#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/file_kind.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/search/indexed_points.hpp>

#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

constexpr double deg_per_rad = 180.0 / std::numbers::pi;

struct Words {
  std::string file, json;
  ScanLogOptions reading;
};

struct LogFacts {
  std::set<std::size_t> beam_counts;
  std::size_t returns = 0;
  std::size_t beams = 0;
  double nearest = 1e300, farthest = 0.0;
  double first_stamp = 1e300, last_stamp = -1e300;
  std::size_t with_odometry = 0;
  double odometry_path = 0.0;
};

LogFacts facts_of(const ScanLog& log) {
  LogFacts facts;
  const LaserScan* before = nullptr;
  for (const LaserScan& scan : log) {
    facts.beam_counts.insert(scan.ranges.size());
    facts.beams += scan.ranges.size();
    for (const float range : scan.ranges) {
      if (!is_return(scan, range)) continue;
      ++facts.returns;
      facts.nearest = std::min(facts.nearest, static_cast<double>(range));
      facts.farthest = std::max(facts.farthest, static_cast<double>(range));
    }
    facts.first_stamp = std::min(facts.first_stamp, scan.stamp);
    facts.last_stamp = std::max(facts.last_stamp, scan.stamp);
    if (scan.T_odom_robot) {
      ++facts.with_odometry;
      if (before != nullptr && before->T_odom_robot)
        facts.odometry_path += distance(*before->T_odom_robot, *scan.T_odom_robot).translation;
    }
    before = &scan;
  }
  return facts;
}

void tell_log(const Words& words) {
  const ScanLog log = open_scan_log(words.file, words.reading);
  const LogFacts facts = facts_of(log);
  const Talk talk(words.json);
  std::string beams;
  for (const std::size_t count : facts.beam_counts) beams += (beams.empty() ? "" : ", ") + std::to_string(count);
  const double fov_deg = log.empty() ? 0.0 : field_of_view(log[0]) * deg_per_rad;
  const double duration = log.empty() ? 0.0 : facts.last_stamp - facts.first_stamp;
  const double return_share =
      facts.beams == 0 ? 0.0 : static_cast<double>(facts.returns) / static_cast<double>(facts.beams);
  talk(format("%s: a %s log of %zu scans", words.file.c_str(), log.format.c_str(), log.size()));
  for (const auto& [kind, count] : log.messages) talk(format("  %-22s %zu", kind.c_str(), count));
  Json summary{{"verb", "info"}, {"file", words.file}, {"kind", "log"}, {"format", log.format}, {"scans", log.size()}};
  if (!log.empty()) {
    talk(format("  beams                  %s, field of view %.2f deg, first beam at %.2f deg", beams.c_str(), fov_deg,
                log[0].angle_min * deg_per_rad));
    talk(format("  returns                %.1f %% of the beams, %.2f m to %.2f m", 100.0 * return_share, facts.nearest,
                facts.farthest));
    talk(format("  duration               %.2f s, stamps %.6f to %.6f", duration, facts.first_stamp, facts.last_stamp));
    talk(facts.with_odometry == 0 ? std::string("  odometry               none")
                                  : format("  odometry               with %zu scans, a path of %.1f m",
                                           facts.with_odometry, facts.odometry_path));
    const Pose2& laser = log[0].T_robot_laser;
    talk(format("  laser on the robot     %s", to_string(laser).c_str()));
    summary.update({{"beams", facts.beam_counts},
                    {"fov_deg", fov_deg},
                    {"angle_min", log[0].angle_min},
                    {"return_share", return_share},
                    {"range_min", facts.nearest},
                    {"range_max", facts.farthest},
                    {"duration", duration},
                    {"first_stamp", facts.first_stamp},
                    {"last_stamp", facts.last_stamp},
                    {"scans_with_odometry", facts.with_odometry},
                    {"odometry_path", facts.odometry_path},
                    {"laser_offset", to_json(laser)}});
  }
  summary["messages"] = log.messages;
  summary["problems"] = log.warnings;
  for (const std::string& warning : log.warnings) talk("  problem                " + warning);
  write_json(words.json, summary);
}

template <int D>
void tell_points(const PointCloud<D>& points, const Cloud& cloud, const Words& words) {
  const Talk talk(words.json);
  const Bounds<D> bounds = bounds_of<D>(points);
  const double spacing = IndexedPoints<D>(points, {.neighbours = 0}).spacing();
  talk(format("%s: a %dD cloud of %zu points (%s)", words.file.c_str(), D, points.size(), cloud.format.c_str()));
  Json summary{{"verb", "info"},         {"file", words.file}, {"kind", "cloud"},
               {"format", cloud.format}, {"dimension", D},     {"points", points.size()}};
  if (!bounds.empty()) {
    Json lower = Json::array(), upper = Json::array();
    for (int axis = 0; axis < D; ++axis) {
      talk(format("  %c                      %.3f m to %.3f m", "xyz"[axis], bounds.lower[axis], bounds.upper[axis]));
      lower.push_back(bounds.lower[axis]);
      upper.push_back(bounds.upper[axis]);
    }
    talk(format("  spacing                %.4f m to the nearest neighbour (median)", spacing));
    summary.update({{"lower", lower}, {"upper", upper}, {"spacing", spacing}});
  }
  summary["problems"] = cloud.warnings;
  for (const std::string& warning : cloud.warnings) talk("  problem                " + warning);
  write_json(words.json, summary);
}

void run(const Words& words) {
  if (kind_of(words.file) == FileKind::scan_log) return tell_log(words);
  const Cloud cloud = load_cloud(words.file);
  if (const auto* plane = std::get_if<PointCloud2>(&cloud.points))
    tell_points<2>(*plane, cloud, words);
  else
    tell_points<3>(std::get<PointCloud3>(cloud.points), cloud, words);
}

}  // namespace

void add_info(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("info", "what a log, cloud or map holds, and what is wrong with it");
  const auto words = std::make_shared<Words>();
  verb->add_option("FILE", words->file, "a log (.clf .log .csv) or a cloud or map (.csv .xyz .pcd .ply)")->required();
  add_log_options(*verb, words->reading);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp info run.clf");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::command
