// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/registration/uncertainty.hpp>
#include <slamicp/search/line_noise.hpp>

namespace slamicp {

/// Sums over the pairs of a match to lines, for its covariance; w a pair's weight, r its residual, j the derivative of
/// its distance by the unknowns (x, y, turn) as seen from the robot, both times the trust in its line, v = w trust^2, p
/// its scan point in the robot's frame.
struct NoiseSums {
  Eigen::Matrix3d by_range = Eigen::Matrix3d::Zero();  // w^2 cos^2(incidence) j j^T
  Eigen::Matrix3d by_map = Eigen::Matrix3d::Zero();    // w^2 n j j^T, n the rays that share a line
  Eigen::Matrix3d together = Eigen::Matrix3d::Zero();  // s s^T, s = sum w r j over neighbouring pairs
  double weights = 0.0;                                // v
  Point2 moment = Point2::Zero();                      // v p
  double squared_ranges = 0.0;                         // v p^2
  double squared_residuals = 0.0;                      // w r^2
  double squared_cosines = 0.0;                        // w cos^2(incidence)
  double sharing = 0.0;                                // v^2 n

  /// Adds a pair's w r j to `together`: in groups of 16 with what each has in common with the next (Newey, West 1987).
  void pull(const Eigen::Vector3d& pull) noexcept;
  /// The last group is complete.
  void close_group() noexcept;

 private:
  Eigen::Vector3d group_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d last_group_ = Eigen::Vector3d::Zero();
  int in_group_ = 0;
};

/// Where a pair's noise comes from. A residual's variance is that of the range, as far as the ray meets the wall head
/// on, and that of the line's offset, which rays that meet the same piece of wall have in common.
struct NoiseModel {
  PointNoise noise;
  LineNoise line;  // of the map, with the noise as chosen
  Rays rays;

  /// How many rays meet one line a metre away, head on [m].
  double sharing() const noexcept { return line.window / rays.spacing; }
  /// Of a line's offset [m^2].
  double offset_variance() const noexcept { return line.across * line.across / line.points; }
};

/// Adds one pair. @param jacobian  j  @param on_ray  p from where the rays start  @param normal  in the robot's frame,
/// as long as the line is trusted
void add_noise(const NoiseModel& model, const Point2& in_robot, const Vector<2>& normal, const Vector<3>& jacobian,
               double residual, double weight, NoiseSums& sums) noexcept;

/// What pairs tell of the pose, and how well.
struct Assessment {
  Uncertainty uncertainty;
  /// G^-1 from the left by the held information: turns a gradient into one that is weighted by its noise.
  Eigen::Matrix3d weighting = Eigen::Matrix3d::Zero();
  /// The normal matrix of the weighted equations, blind directions left out.
  Eigen::Matrix3d weighted = Eigen::Matrix3d::Zero();
  /// Where exactly one direction is blind, that direction, a turn counted by what it moves at the reach: unit vector.
  Eigen::Vector3d blind = Eigen::Vector3d::Zero();
};

/// Lets the pairs be blind in the direction in which the prior is by far the least sure, where that is the same to
/// within what their noise can tell. The walls' direction as the pairs know it varies a little from scan to scan; taken
/// for many directions, they would seem to hold together what none of them holds (the inconsistency of filters with
/// varying unobservable directions: Huang, Mourikis, Roumeliotis 2010, "Observability-based rules").
void align_blind_direction(const Eigen::Matrix3d& prior_information, double reach, Assessment& pairs) noexcept;

/// @param information  of the pairs, sum w j j^T
/// @param gradient     sum w r j
/// @param reach        root mean square distance of the pairs from the robot, above 0 [m]
Assessment assess(const Eigen::Matrix3d& information, const Eigen::Vector3d& gradient, const NoiseSums& sums,
                  const NoiseModel& model, double reach) noexcept;

/// The motion that makes the pairs' residuals and what the prior says least together, each by its noise.
/// @param from_prior  log(pose^-1 prior)
Eigen::Vector3d fused_motion(const Assessment& pairs, const Eigen::Vector3d& gradient,
                             const Eigen::Matrix3d& prior_information, const Eigen::Vector3d& from_prior) noexcept;

}  // namespace slamicp
