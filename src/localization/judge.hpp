// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <slamicp/localization/quality.hpp>
#include <slamicp/scan/scan_points.hpp>
#include <slamicp/search/indexed_points.hpp>

namespace slamicp {

/// A scan at the pose of its fix, to be held against the map.
struct PlacedScan {
  const ScanPoints& points;
  std::span<const Point2> origins;  ///< of the rays of each joined scan, in the robot's frame
  Pose2 T_map_robot;
};

/// What `rays` of the scan, evenly chosen, show. @param noise  of a point from its line, 1 sigma [m]
Evidence look(const IndexedPoints<2>& map, const PlacedScan& scan, int rays, double match_distance,
              double noise) noexcept;

/// For a pose being right, by one scan's evidence: logistic regression over right and wrong poses in four simulated
/// worlds, with things that came and things that left, and in five real ones (`scripts/measure doubt --only calibration
/// --samples FILE`, `scripts/measure real_calibration --samples FILE`), right and wrong and each world weighing alike.
double log_odds(const Evidence& evidence) noexcept;
double probability_of(double log_odds) noexcept;

/// Follows from scan to scan whether the pose is right.
class Judge {
 public:
  explicit Judge(const QualityOptions& options) noexcept : options_(options) {}

  /// The pose was set: it is believed until scans speak against it.
  void forget() noexcept;

  /// @param matched  false where the match found no pose
  /// @param held     false where some direction is blind
  /// @param surprise  what of the record a match costs that contradicts the prediction, 0 to 1
  Quality update(const Evidence& evidence, bool matched, bool held, double surprise) noexcept;

 private:
  TrackingState next_state(bool held) noexcept;
  double probability() const noexcept { return probability_of(log_odds_ + record_); }

  static constexpr double at_first = 2.0;  // log odds of a pose that was set
  // A pose that was followed from scan to scan, without a doubt or a surprise, is rarely wrong: log odds that this
  // adds, and how many scans it takes.
  static constexpr double best_record = 4.0;
  static constexpr double scans_of_a_record = 600.0;

  QualityOptions options_;
  double log_odds_ = at_first;  // by the last scans
  double record_ = 0.0;         // by all before, as far as nothing surprised
  double awareness_ = 1.0;
  int scans_ = 0;     // since the pose was set
  int doubtful_ = 0;  // scans in a row
};

}  // namespace slamicp
