// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <slamicp/agent/agent.hpp>
#include <slamicp/evaluation/experiment_site.hpp>
#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// Which drive to make.
struct DrivePlan {
  std::string obstacle;           ///< "A1" to "D3"; empty: none
  double speed = 0.35;            ///< along the path [m/s], > 0
  std::uint64_t seed = 1;         ///< of all noise; the same with and without an obstacle
  double outlier_distance = 0.3;  ///< the paper's O_t [m], > 0
  /// See ObstacleEvaluationOptions [m]. Below its default: D3 stands 0.38 m beside the path, and a map that is a few
  /// centimetres off leads the robot nearer.
  double corridor_half_width = 0.3;
  std::vector<double> views = {};  ///< where on the path to keep what was seen [m], rising
  double start = 0.0;              ///< where on the path it begins [m]
  double most_seconds = 3600.0;    ///< it ends then, if not at the end of the path [s]
  bool keeps_scans = true;         ///< false: neither scans nor outliers are kept, only the samples
};

/// One control cycle of a drive.
struct DriveSample {
  double stamp = 0.0;      ///< [s]
  double travelled = 0.0;  ///< along the path, as the agent has it [m]
  Pose2 truth;             ///< T_map_robot
  Pose2 estimate;          ///< T_map_robot
  std::size_t outliers = 0;
  std::size_t inliers = 0;
  double mean_inlier_distance = 0.0;  ///< [m]
  std::size_t obstacles = 0;          ///< that the agent found
  bool found = false;                 ///< one of those stands where the placed obstacle does
  int beams_on_it = 0;                ///< on the placed obstacle within near_range, by the truth
  Decision decision = Decision::ignore;
};

/// What the agent saw from one place.
struct DriveView {
  double travelled = 0.0;  ///< [m]
  Pose2 pose;              ///< T_map_robot, as estimated
  PointCloud2 inliers;     ///< in the map
  PointCloud2 outliers;    ///< in the map
};

/// A drive along the reference path, as a log would hold it, with the truth.
struct RecordedDrive {
  DrivePlan plan;
  bool finished = false;         ///< at the end of the path
  std::vector<LaserScan> scans;  ///< one a sample
  std::vector<DriveSample> samples;
  std::vector<DriveView> views;  ///< one for each place asked for that was reached
  PointCloud2 outliers;          ///< of all scans, in the map

  std::size_t most_outliers() const noexcept;
  /// Over all scans [m].
  double mean_inlier_distance() const noexcept;
};

/// Drives the site's path by the improved agent, with a real Hokuyo on the slipping APR-02, the map frozen. The same
/// arguments give the same drive. Throws Error where the plan is absurd.
RecordedDrive record_drive(const ExperimentSite& site, const DrivePlan& plan);

/// The agent that drives it: the improved form, with the plan's distances.
AgentOptions agent_of(const DrivePlan& plan);

/// How soon a placed obstacle was found, by the truth.
struct Sighting {
  /// From when the laser has enough beams on it, near enough [s]; infinite: never so.
  double due = std::numeric_limits<double>::infinity();
  /// The first cycle that found it [s]; infinite: none.
  double found = std::numeric_limits<double>::infinity();
  double found_at_range = 0.0;  ///< from robot to obstacle then [m]

  bool was_due() const noexcept { return due < std::numeric_limits<double>::infinity(); }
  bool was_found() const noexcept { return found < std::numeric_limits<double>::infinity(); }
  /// After it was due [s]; negative: before.
  double delay() const noexcept { return found - due; }
};

/// "Enough beams, near enough" of a Sighting: so many, within so far [m].
inline constexpr int beams_to_find = 5;
inline constexpr double near_range = 4.0;

Sighting sighting_of(const RecordedDrive& drive);

}  // namespace slamicp
