// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// Where a point is beside a path.
struct PathPlace {
  double distance = 0.0;     ///< along the path, of the nearest place on it [m]
  double cross_track = 0.0;  ///< of the point from that place, positive to the left [m]
};

/// A smooth way through waypoints, read by the distance travelled: the natural cubic spline over the chord length,
/// re-parametrized by arc length, so that equal steps are equal distances (the paper, section 2.5: fixed-distance
/// spline interpolation). The heading is the curve's direction.
class SplinePath {
 public:
  /// Throws Error for fewer than two waypoints, coordinates that are not finite, and the same waypoint twice in a row.
  explicit SplinePath(std::span<const Point2> waypoints);

  /// From the first waypoint to the last, along the curve [m].
  double length() const noexcept { return distances_.back(); }

  /// The place after `distance` metres, clamped to the curve's ends. O(log length).
  Pose2 at(double distance) const noexcept;

  /// How much it bends there, positive to the left [1/m].
  double curvature(double distance) const noexcept;

  /// From one of places() to the next, along the curve [m]; to the last one less.
  static constexpr double place_spacing = 0.05;
  /// The whole way as a polyline, from the start to the end. In the sharpest curve that a robot takes, its chords are a
  /// millimetre off.
  PointView<2> places() const noexcept { return places_; }

  /// The whole way in steps of `spacing` [m], > 0, and the end. Throws Error for a spacing that is none.
  std::vector<Pose2> sampled(double spacing) const;

  /// The place nearest to a point among those from `from` to `to` [m]: give the part of the path where it can be, as
  /// paths may cross themselves. O(to - from).
  PathPlace nearest(const Point2& point, double from, double to) const noexcept;

 private:
  struct CurvePoint;
  CurvePoint curve_at(double distance) const noexcept;

  PointCloud2 knots_;
  std::vector<double> parameters_;  // chord length at each knot
  PointCloud2 second_derivatives_;  // at each knot, by chord length
  std::vector<double> distances_;   // arc length, tabled at equal steps of the chord length
  double table_step_ = 0.0;
  PointCloud2 places_;
};

}  // namespace slamicp
