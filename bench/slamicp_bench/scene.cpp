// SPDX-License-Identifier: Apache-2.0
#include "scene.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>

#include <slamicp/error.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/scan/scan_points.hpp>

namespace slamicp::bench {
namespace {

constexpr const char* poses_form = "truth_x,truth_y,truth_th,guess_x,guess_y,guess_th";

struct Poses {
  Pose2 truth;
  Pose2 guess;
};

/// Six numbers between commas, [m, m, rad, m, m, rad].
Poses parse_poses(std::string_view line, const std::string& where) {
  std::array<double, 6> value{};
  std::size_t count = 0;
  while (!line.empty()) {
    const std::string_view word = line.substr(0, line.find(','));
    line.remove_prefix(std::min(word.size() + 1, line.size()));
    double number = 0.0;
    const auto [stop, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (problem != std::errc() || stop != word.data() + word.size() || !std::isfinite(number))
      throw Error("'" + std::string(word) + "' is not a number", where, std::string("write ") + poses_form);
    if (count < value.size()) value[count] = number;
    ++count;
  }
  if (count != value.size())
    throw Error(std::to_string(count) + " values, not 6", where, std::string("write ") + poses_form);
  return {{value[0], value[1], wrap_angle(value[2])}, {value[3], value[4], wrap_angle(value[5])}};
}

std::vector<Poses> load_poses(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw Error("cannot open the file", file.string(), "give a CSV of poses: " + std::string(poses_form));
  std::vector<Poses> all;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    const bool is_header = number == 1 && line.starts_with("truth_x");
    if (!line.empty() && !is_header) all.push_back(parse_poses(line, file.string() + ":" + std::to_string(number)));
  }
  return all;
}

/// `wanted` of `all` numbers from 0, evenly spread.
std::vector<std::size_t> spread(std::size_t all, std::size_t wanted) {
  if (wanted == 0 || wanted > all) wanted = all;
  std::vector<std::size_t> numbers(wanted);
  for (std::size_t k = 0; k < wanted; ++k) numbers[k] = k * all / wanted;
  return numbers;
}

}  // namespace

double mean_scan_points(const Scene& scene) {
  double sum = 0.0;
  for (const Trial& trial : scene.trials) sum += static_cast<double>(trial.scan.size());
  return scene.trials.empty() ? 0.0 : sum / static_cast<double>(scene.trials.size());
}

Scene load_scene(const SceneFiles& files, std::size_t scans) {
  Scene scene{files.ranges.stem().string(), std::make_shared<const PointCloud2>(load_cloud2(files.map)), {}};
  if (scene.map->empty()) throw Error("the map has no points", files.map.string(), "give a CSV of x,y");
  ScanLogOptions options;
  options.fov_deg = files.fov_deg;
  const ScanLog log = open_scan_log(files.ranges, options);
  const std::vector<Poses> poses = load_poses(files.poses);
  if (log.empty()) throw Error("no scans", files.ranges.string(), "give a CSV of ranges, a scan a line");
  if (log.size() != poses.size())
    throw Error(std::to_string(poses.size()) + " poses, but " + std::to_string(log.size()) + " scans in " +
                    files.ranges.string(),
                files.poses.string(), "give a line of poses for each scan");
  for (const std::size_t k : spread(log.size(), scans))
    scene.trials.push_back({to_points(log[k]).in_robot, poses[k].truth, poses[k].guess});
  return scene;
}

}  // namespace slamicp::bench
