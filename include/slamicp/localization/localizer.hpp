// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include <slamicp/localization/fix.hpp>
#include <slamicp/localization/local_search.hpp>
#include <slamicp/localization/prediction_noise.hpp>
#include <slamicp/registration/icp_options.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// The options of a localizer; those of the match have the names and meanings of IcpOptions.
struct LocalizerOptions {
  double max_correspondence_distance = 0.3;  ///< the paper's *indist* [m]
  std::optional<double> outlier_distance{};  ///< the paper's *O_t* [m]; default: the distance above
  /// What makes an obstacle [m], see IcpOptions; default: from the noise.
  std::optional<double> obstacle_distance{};
  Method method = Method::point_to_line;
  int max_iterations = 50;
  RobustKernel kernel = RobustKernel::none;
  double kernel_scale = 0.05;  ///< [m]
  double guess_share = 0.0;    ///< how much the prediction itself counts, see IcpOptions
  double final_gate = 0.0;     ///< [m]; 0: from the map
  RangeFilter ranges{};        ///< readings to leave out
  bool use_odometry = true;    ///< predict by the scans' T_odom_robot and sweep_motion, where they have them
  /// Points are taken from where the robot was when their beam was measured, for scans with a time increment: by
  /// `sweep_motion`, else with the velocity since the last fix, and once more with what the match says it was.
  bool deskew = true;
  PointNoise noise{};            ///< of ranges and map, see IcpOptions
  PredictionNoise prediction{};  ///< of odometry, or of constant velocity where there is none
  QualityOptions quality{};      ///< when to doubt the pose
  LocalSearchOptions search{};   ///< where `recover` looks
  /// What to compute for each fix besides the pose. Per-point matches cost a distance a point. With the covariance the
  /// prediction takes part in the fix by its own, so that a direction the scan does not hold follows odometry.
  Outputs outputs = {.mean_inlier_distance = true,
                     .outlier_indices = true,
                     .outliers_in_map = true,
                     .covariance = true,
                     .strays = true};

  IcpOptions icp() const noexcept;
  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// Follows a robot through its map, scan by scan: predict by odometry (or constant velocity), match, hand out a Fix.
///
/// Belongs to one thread. After the first scan `update` allocates nothing, as long as scans do not grow.
///
/// Without a map it works scan to scan (the paper, section 2.3): the first scan stands at the pose that was set, and
/// each further one is matched against the one before. Then each update makes a map of its scan, which does allocate.
class Localizer {
 public:
  /// Throws Error with options.problem(), or if `map` is null.
  explicit Localizer(PointMap2::Pointer map, const LocalizerOptions& options = {});
  /// No map yet: scan to scan.
  explicit Localizer(const LocalizerOptions& options = {});
  ~Localizer();
  Localizer(Localizer&&) noexcept;
  Localizer& operator=(Localizer&&) noexcept;

  /// Where the robot is now, T_map_robot; motion is forgotten. Throws Error if it is not finite.
  void set_pose(const Pose2& pose);

  /// Another snapshot, from the next scan on. The pose stays. Throws Error if it is null.
  void set_map(PointMap2::Pointer map);
  const PointMap2::Pointer& map() const noexcept;

  /// Localizes one scan. The Fix is good until the next call.
  const Fix& update(const LaserScan& scan) noexcept;

  /// One fix from the scans of several lasers of one robot, each with its own place on it and its own stamp. The pose
  /// is that at the first scan's stamp. No scan: the last Fix again.
  const Fix& update(std::span<const LaserScan> scans) noexcept;

  /// Looks for the robot near where it was last trusted, where the quality says `suspect` or `lost`: one call a scan,
  /// each of which looks at up to `budget` places more (a thousand in about half a millisecond, see LocalSearch). True
  /// where it found the robot and set the pose anew, from the next update on; motion since the search began is counted
  /// in. Allocates.
  bool recover(int budget);

  /// The last Fix; before the first scan one at the pose that was set, not usable.
  const Fix& fix() const noexcept;
  const LocalizerOptions& options() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slamicp
