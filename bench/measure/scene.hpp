// SPDX-License-Identifier: Apache-2.0
// Scans of a world, its map, and where the robot was and thought it was; in the files of SLAMICP_DATA_DIR/corridor.
#pragma once

#include <fstream>
#include <sstream>

#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/scan/scan_points.hpp>

#include "support.hpp"

namespace slamicp::measure {

struct Trial {
  std::size_t scan = 0;
  Pose2 truth;
  Pose2 guess;
};

/// Scans of a world, its map, and where the robot was and thought it was.
struct Scene {
  std::string name;
  PointCloud2 map;
  std::vector<PointCloud2> scans;
  std::vector<Trial> trials;
};

inline std::vector<Trial> load_poses(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<Trial> trials;
  for (std::string line; std::getline(in, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    Trial trial;
    trial.scan = trials.size();
    Pose2 &t = trial.truth, &g = trial.guess;
    if (numbers >> t.x >> t.y >> t.theta >> g.x >> g.y >> g.theta) trials.push_back(trial);
  }
  return trials;
}

inline Scene load_scene(const std::string& name, const std::filesystem::path& map, const std::filesystem::path& ranges,
                        const std::filesystem::path& poses, double fov_deg) {
  Scene scene{name, load_cloud2(map), {}, load_poses(poses)};
  ScanLogOptions options;
  options.fov_deg = fov_deg;
  for (const LaserScan& scan : open_scan_log(ranges, options)) scene.scans.push_back(to_points(scan).in_robot);
  if (scene.scans.size() != scene.trials.size() || scene.scans.empty())
    throw std::runtime_error(text("%zu scans in %s, but %zu poses in %s", scene.scans.size(), ranges.c_str(),
                                  scene.trials.size(), poses.c_str()));
  return scene;
}

inline Scene load_corridor(const std::string& name) {
  return load_scene(name, data("corridor/map.csv"), data("corridor/ranges_" + name + ".csv"),
                    data("corridor/poses_" + name + ".csv"), 270.0);
}

}  // namespace slamicp::measure
