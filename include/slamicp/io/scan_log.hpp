// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// In place of the names of all scan topics.
inline constexpr const char* every_topic = "*";

/// What a log does not say about itself.
struct ScanLogOptions {
  /// Field of view, first beam to last, centred ahead [deg], (0, 360]. Only for ranges CSV; wrong by half a degree
  /// costs centimetres at 5 m.
  double fov_deg = 270.0;
  /// Scans a second [1/s], > 0. Only for ranges CSV, which has no stamps: scan i is stamped i / rate.
  double scan_rate_hz = 40.0;
  /// Where the laser sits on the robot; overrides what the log says. Default: as the log says, else at its centre.
  std::optional<Pose2> laser_offset = std::nullopt;
  /// Which topics hold scans, for recordings of ROS. Empty: the only one there is, or the one named `scan`; where that
  /// does not decide, Error with the names to choose from. Several: one log of all their scans, each with its `laser`
  /// counted in this order; every_topic: all there are.
  std::vector<std::string> scan_topics = {};
  /// Which topic holds odometry (nav_msgs/Odometry). Empty: the only one there is, or the one named `odom`; else tf.
  std::string odometry_topic = {};
  /// The frame that moves with the robot and that its poses are of. Empty: what the odometry calls its child, else
  /// `base_footprint`, `base_link` or `base`, else the laser's own.
  std::string base_frame = {};

  /// The first rule broken, in words; empty if none is.
  std::string problem() const;
};

/// A log of lidar scans, all in memory, in the order of the file.
struct ScanLog {
  std::string name;                                          ///< the file
  std::string format;                                        ///< "CARMEN", "ranges CSV", "ROS 1 bag", ...
  std::vector<LaserScan> scans;                              ///< in file order; stamps may run backwards
  std::vector<std::string> lasers;                           ///< the name (topic) of each laser, where it has one
  std::map<std::string, std::size_t, std::less<>> messages;  ///< number of messages of each kind
  std::vector<std::string> warnings;                         ///< problems found that do not stop us, in words

  auto begin() const noexcept { return scans.begin(); }
  auto end() const noexcept { return scans.end(); }
  std::size_t size() const noexcept { return scans.size(); }
  bool empty() const noexcept { return scans.empty(); }
  const LaserScan& operator[](std::size_t scan) const noexcept { return scans[scan]; }
};

/// Reads a log by its file name's ending: `.clf`, `.log` CARMEN; `.csv` ranges, a scan a line; both also packed, with
/// `.gz`, `.xz`, `.zst` or `.bz2` after it; `.bag` (ROS 1), `.db3` or a folder with metadata.yaml (rosbag2), `.mcap`.
/// Throws Error with file and line for anything malformed; what was cut gives what came whole, and a warning.
ScanLog open_scan_log(const std::filesystem::path& path, const ScanLogOptions& options = {});

/// Writes a log by its file name's ending: `.clf`, `.log` CARMEN (ROBOTLASER1, with odometry); `.csv` ranges only, 0 =
/// no return. What is no return comes back as no return; all else comes back as it was, stamps to the microsecond.
void save_scan_log(const std::filesystem::path& path, std::span<const LaserScan> scans);

}  // namespace slamicp
