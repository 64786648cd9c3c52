// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <slamicp/map/point_map.hpp>
#include <slamicp/registration/icp.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>
#include <slamicp/simulation/random.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// The least covariance with which any unbiased estimator can find the pose from a scan: the inverse of
/// sum h h^T / (sigma_r^2 cos^2(beta) + sigma_m^2) over the rays that meet what the map knows, h the derivative of a
/// ray's distance to its wall by the pose as seen from the robot, beta its angle of incidence (Censi 2007, "On
/// achievable accuracy for range-finder localization", with the map's noise added).
/// @param known        the world that the map knows; `world` has what else stands there
/// @param off_corners  rays that end this near to a corner or a pillar of what is known are left out [m]; 0: none
Matrix<3, 3> least_covariance(const World& known, const World& world, const Pose2& T_map_robot, const LidarModel& lidar,
                              double range_noise, double map_noise, double off_corners = 0.0);

/// NEES of three unknowns that 95 % of the errors stay below: chi-squared with three degrees of freedom.
inline constexpr double within_95_percent = 7.814728;

/// A single match in a world with truth.
struct CovarianceTrial {
  Pose2::Tangent error;  ///< as seen from the robot: T_map_robot = truth * exp(error)
  Uncertainty told;      ///< by the match
  Matrix<3, 3> least;    ///< least_covariance() with the map's noise as lines smooth it: sigma / sqrt(points of a line)
  Matrix<3, 3> plain;    ///< the same with a perfect map: Censi's bound
  bool usable = false;

  /// Normalized estimation error squared: 3 on average where the covariance is right (Bar-Shalom, Li, Kirubarajan
  /// 2001).
  double nees() const noexcept;
};

/// What of the errors is there; to switch off, to see what each one does.
struct CovarianceTrialOptions {
  double map_noise = default_map_noise;  ///< of the map's points, 1 sigma [m], at least 0
  double off_corners = 0.0;              ///< readings this near to a corner or a pillar are left out [m]; 0: none

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// One noisy map of a world, and matches in it.
class CovarianceTrials {
 public:
  /// @param world_name  of trial_world(). Throws Error where there is none, or with options.problem().
  CovarianceTrials(std::string_view world_name, std::uint64_t seed, const CovarianceTrialOptions& options = {});

  /// One match at a place beside the route, from a guess 2 cm, 2 cm and 10 mrad off (1 sigma).
  /// @param unmapped  share of the rays that meet what the map does not know
  CovarianceTrial draw(double unmapped);

 private:
  CovarianceTrialOptions options_;
  World world_;
  LidarModel lidar_;
  Random random_;
  PointMap2::Pointer map_;
  Icp<2> icp_;
};

/// Sums over trials.
class CovarianceScore {
 public:
  void add(const CovarianceTrial& trial) noexcept;

  std::size_t count() const noexcept { return count_; }
  std::size_t failed() const noexcept { return failed_; }       ///< not usable, or off by more than 0.1 m
  std::size_t blind() const noexcept { return blind_; }         ///< a direction was not held: no ellipse to speak of
  double nees() const noexcept { return nees_ / (3.0 * n()); }  ///< mean, over 3: 1 where covariances are right
  double inside() const noexcept { return static_cast<double>(inside_) / n(); }  ///< share in the 95 % ellipse
  double rmse() const noexcept;                                                  ///< of the position [m]
  double rmse_turn() const noexcept;                                             ///< [rad]
  double told() const noexcept;         ///< root mean variance of the position as told [m]
  double bound() const noexcept;        ///< the same of least_covariance() [m]
  double bound_turn() const noexcept;   ///< [rad]
  double plain_bound() const noexcept;  ///< with a perfect map [m]

 private:
  double n() const noexcept { return count_ > 0 ? static_cast<double>(count_) : 1.0; }

  std::size_t count_ = 0, failed_ = 0, blind_ = 0, inside_ = 0;
  double nees_ = 0.0, position2_ = 0.0, turn2_ = 0.0, told2_ = 0.0, bound2_ = 0.0, bound_turn2_ = 0.0, plain2_ = 0.0;
};

}  // namespace slamicp
