// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <string>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// What a match knows of the noise of its points.
struct PointNoise {
  double range = 0.0;  ///< of a range, 1 sigma [m]; 0: from the residuals of each match. Range 0 to 1
  /// What `range` never falls below where it comes from the residuals [m]. Range 1e-5 to 1.
  double least_range = 0.002;
  double map = 0.0;  ///< of a map point across its wall, 1 sigma [m]; 0: from the map's lines. Range 0 to 1

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// How the rays of a scan lie, which says how steeply they meet a wall and how many of them share a piece of it.
struct Rays {
  Point2 origin = Point2::Zero();                    ///< where they start, in the robot's frame [m]
  double spacing = 2.0 * std::numbers::pi / 1440.0;  ///< from one to the next [rad], > 0
};

/// How well a scan's pairs hold the pose, in the plane.
///
/// All matrices are of the error as seen from the robot: T_map_robot = truth * exp(error), error = (x ahead, y to the
/// left, theta) [m, m, rad].
struct Uncertainty {
  bool known = false;  ///< false: not asked for, or nothing matched
  /// Inverse of the covariance; without anything in a direction that the pairs do not hold.
  Matrix<3, 3> information = Matrix<3, 3>::Zero();
  /// Of the match alone. A direction that the pairs do not hold has `unheld_variance`.
  Matrix<3, 3> covariance = Matrix<3, 3>::Zero();
  /// The part of the covariance that is common to the scans made from one place, as the map's error is: it does not
  /// average out over time. Nothing in a direction that the pairs do not hold.
  Matrix<3, 3> systematic = Matrix<3, 3>::Zero();
  double range_noise = 0.0;  ///< of a range, as used [m]
  /// How much more neighbouring points pull together than noise explains, a mean over the directions, at least 1: the
  /// covariance is larger by it. Corners, doors ajar and things beside walls do it.
  double misfit = 1.0;
  /// How far the pairs' pose is from what a prior says, squared and in their common noise: about 3, and seldom above
  /// 16, where both are right. A blind direction has no part in it. 0 without a prior.
  double surprise = 0.0;
  /// True where the pairs hold some direction no better than the noise of the map's normals pretends.
  bool blind = false;
  /// The direction in which the pairs hold the position least, whatever the rotation: unit vector in the robot's frame.
  Vector<2> weakest = Vector<2>::UnitX();
  double weakest_sigma = 0.0;  ///< standard deviation in that direction [m]; infinite where blind
  /// How well the pairs know the direction of their lines together, by the noise of the map's normals [rad]: so far a
  /// blind direction may be turned.
  double tilt_sigma = 0.0;
  double twist_sigma = 0.0;     ///< how much the heading may seem to change along a blind direction, likewise [rad/m]
  double rotation_sigma = 0.0;  ///< of the heading [rad]; infinite where the pairs do not hold it

  /// The part of the covariance in directions that the pairs do not hold.
  Matrix<3, 3> unheld = Matrix<3, 3>::Zero();

  /// Of `surprise`: 0.1 % of chi-squared with three degrees of freedom are above.
  static constexpr double credible = 16.0;
  static constexpr double unheld_variance = 1e6;  ///< [m^2, rad^2]: a kilometre

  /// True where the pairs pull against each other: much more than noise explains.
  bool contradicts_itself() const noexcept { return misfit >= 3.0; }

  /// What the prior counts beside the pairs, in (0, 1]: the less, the less it can be right.
  double trust_in_prior() const noexcept { return surprise > credible ? credible / surprise : 1.0; }
};

/// What is known of a pose before the match.
struct PosePrior {
  Pose2 mean;                                       ///< T_map_robot
  Matrix<3, 3> information = Matrix<3, 3>::Zero();  ///< of its error as seen from the robot; zero: nothing is known
  /// Where the solver's gate starts [m], so that the match stays near, whatever stands there. 0: at
  /// IcpOptions::max_correspondence_distance, or farther out where the information is little.
  double first_gate = 0.0;

  bool given() const noexcept { return information.trace() > 0.0; }
};

}  // namespace slamicp
