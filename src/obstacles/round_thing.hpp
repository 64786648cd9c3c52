// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <numbers>
#include <optional>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// A circle through points.
struct RoundThing {
  Point2 centre = Point2::Zero();
  double radius = 0.0;
  Matrix<3, 3> covariance = Matrix<3, 3>::Zero();  ///< of centre and radius

  /// Cosine: a ray meets no surface so flat that its noise counts less.
  static constexpr double flattest = 0.2;
  /// How much of it must be seen to show that it is round [rad].
  static constexpr double least_arc = std::numbers::pi / 3.0;
};

/// How a circle is looked for.
struct RoundSearch {
  std::size_t stride = 1;             ///< every so many points take part
  const RoundThing* start = nullptr;  ///< where to begin; null: at the algebraic circle
  /// Squared errors, in variances of the noise and summed, that are too many to go on with.
  double most = std::numeric_limits<double>::infinity();
};

/// The circle that makes the points' errors along their rays small, bent away from the lasers; nothing where there is
/// none of 15 mm to 1 m. O(points) a step.
/// @param lasers  where the points were seen from: one for all, or one for each
/// @param noise   of a range, 1 sigma [m]
std::optional<RoundThing> fit_round(PointView<2> points, PointView<2> lasers, double noise,
                                    const RoundSearch& search = {}) noexcept;

}  // namespace slamicp
