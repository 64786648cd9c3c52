// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/registration/icp_options.hpp>
#include <slamicp/scan/scan_points.hpp>

namespace slamicp::command {

/// Says on the last line of a verb's help how it is used.
void add_example(CLI::App& verb, const std::string& example);

/// `--name X,Y,THETA`: metres and radians.
CLI::Option* add_pose(CLI::App& verb, const std::string& name, std::optional<Pose2>& pose, const std::string& meaning);

/// The files that a verb takes as a log.
inline constexpr const char* log_words =
    ".clf .log (CARMEN), .csv (ranges), both also packed (.gz .xz .zst .bz2); .bag, .db3, .mcap, a rosbag2 folder "
    "(ROS)";

/// The files that a verb takes as a cloud, and those that it takes as a map.
inline constexpr const char* cloud_words = ".csv .xyz .pcd .ply";
inline constexpr const char* map_words = ".csv .xyz .pcd .ply, .yaml (ROS map_server)";

/// True for the name of a map_server map.
bool is_map_server(const std::string& file);

/// `--resolution`: the cells of a map_server map that is written.
void add_resolution(CLI::App& verb, double& resolution);

/// How to read a log: `--laser-offset`; for ROS `--scan-topic`, `--odometry-topic` and `--base-frame`; for ranges CSV
/// `--fov-deg` and `--scan-rate-hz`.
void add_log_options(CLI::App& verb, ScanLogOptions& log);

/// The options that `map` and `localize` share.
struct MatchOptions {
  Method method = Method::point_to_line;
  double max_correspondence_distance = 0.3;
  std::optional<double> outlier_distance;
  int max_iterations = 50;
  RangeFilter ranges;
  int threads = 1;
};
/// @param distance  the verb's default for --max-correspondence-distance [m]
void add_match_options(CLI::App& verb, MatchOptions& options, double distance);

/// How the motion between scans, and during one, is told.
struct MotionOptions {
  bool use_odometry = true;
  bool deskew = true;
};
void add_motion_options(CLI::App& verb, MotionOptions& options);

/// `--method`, with the names that fit the verb.
void add_method(CLI::App& verb, Method& method);

/// `--config FILE.yaml`: `name: value` pairs, named as the options; the command line goes before. Call it last, and
/// `read_config` first in the verb's callback.
void add_config(CLI::App& verb);
void read_config(CLI::App& verb);

}  // namespace slamicp::command
