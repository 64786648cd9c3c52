// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <slamicp/geometry/trajectory.hpp>
#include <slamicp/localization/fix.hpp>
#include <slamicp/mapping/mapper.hpp>

namespace slamicp {

/// What each scan is matched to.
enum class OdometryReference {
  local_map,      ///< what is known of the surroundings: drifts little
  previous_scan,  ///< the scan before (the paper, section 2.3): least memory, drifts with every match
};

struct ScanOdometryOptions {
  OdometryReference reference = OdometryReference::local_map;
  /// Pairs farther apart take no part [m]. Larger: faster motion is followed; smaller: less is mistaken.
  double max_correspondence_distance = 1.0;
  /// A point at least this far from the local map is added to it [m].
  double insertion_distance = 0.05;
  /// The local map reaches this far from the robot [m], > 0. Smaller: less memory; larger: less drift where the robot
  /// comes back.
  double map_radius = 20.0;
  Method method = Method::point_to_line;
  int max_iterations = 60;
  RangeFilter ranges = {};    ///< readings to leave out
  bool use_odometry = false;  ///< predict by wheels, where scans have them
  bool deskew = true;         ///< see LocalizerOptions

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// Where a robot has got to, told by its laser alone: odometry without wheels and without a map of the building
/// (Kohlbrecher et al. 2011, Hector, is the case; Censi 2008 scan to scan).
class ScanOdometry {
 public:
  /// Throws Error with options.problem().
  explicit ScanOdometry(const ScanOdometryOptions& options = {});
  ~ScanOdometry();
  ScanOdometry(ScanOdometry&&) noexcept;
  ScanOdometry& operator=(ScanOdometry&&) noexcept;

  /// Takes the next scan. The Fix is good until the next call; its pose is T_start_robot.
  const Fix& add(const LaserScan& scan);

  /// T_start_robot of every scan, in the order they came.
  const Trajectory& trajectory() const noexcept;
  /// Scans that found nothing to match and were placed by prediction.
  int unmatched() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slamicp
