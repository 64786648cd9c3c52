// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <slamicp/geometry/trajectory.hpp>
#include <slamicp/io/picture.hpp>
#include <slamicp/localization/fix.hpp>

namespace slamicp::command {

/// What a report tells of one scan.
struct ScanRecord {
  double iterations = 0.0;
  double points = 0.0;
  double inliers = 0.0;
  double outliers = 0.0;
  double mean_inlier_distance = 0.0;  // [m]
  double time_us = 0.0;
  TrackingState state = TrackingState::tracking;
  double probability = 1.0;
  Matrix<3, 3> covariance = Matrix<3, 3>::Zero();  // along the map's axes
  Vector<2> blind_direction = Vector<2>::Zero();   // in the map; zero where there is none
};

/// What a report tells of a run.
struct RunRecord {
  std::string log;
  std::string map_file;
  PointMap2::Pointer map;
  Pose2 initial_pose;
  Trajectory trajectory;
  std::vector<ScanRecord> scans;
  std::map<Stop, std::size_t> stops;
  std::map<TrackingState, std::size_t> states;
  PointCloud2 outliers;  // of all scans, in the map

  /// The scan with the most outliers: the one to show.
  struct Shown {
    std::size_t scan = 0;
    Pose2 pose;
    PointCloud2 inliers;   // in the map
    PointCloud2 outliers;  // in the map
  } shown;

  void add(const Fix& fix, double time_us);

  double mean(double ScanRecord::*field) const;
  double largest(double ScanRecord::*field) const;
  double quantile(double ScanRecord::*field, double share) const;
  /// Since the first scan [s], where stamps rise; else scans.
  std::vector<double> times() const;
  bool has_times() const;
  /// One line for people.
  std::string brief() const;

 private:
  void show(const Fix& fix);
};

/// One self-contained page: figures, the picture of the run, charts along the scans.
void write_report(const std::string& file, const RunRecord& record);

/// The map, the run's outliers, the scan with the most of them, and the path with what it thinks of itself: states, 95
/// % ellipses, blind directions.
/// @param bounds  what to show [m]; default: all
Picture draw_run(const RunRecord& record, const std::string& title, std::optional<Bounds<2>> bounds = {});

}  // namespace slamicp::command
