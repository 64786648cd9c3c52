// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "contender.hpp"

namespace slamicp::bench {

/// A scan, where the robot was, and where it thought it was.
struct Trial {
  PointCloud2 scan;
  Pose2 truth;
  Pose2 guess;
};

/// What all contenders are given.
struct Scene {
  std::string name;
  SharedCloud map;
  std::vector<Trial> trials;
};

/// Points of the scans, on average.
double mean_scan_points(const Scene& scene);

struct SceneFiles {
  std::filesystem::path map;     ///< x,y a line
  std::filesystem::path ranges;  ///< a scan a line
  std::filesystem::path poses;   ///< a header, then truth_x,truth_y,truth_th,guess_x,guess_y,guess_th for each scan
  double fov_deg = 270.0;        ///< of the ranges, first beam to last
};

/// Reads a scene; of its scans `scans`, evenly spread, or all for 0. Throws Error with file and line.
Scene load_scene(const SceneFiles& files, std::size_t scans);

}  // namespace slamicp::bench
