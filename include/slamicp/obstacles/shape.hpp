// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

enum class ShapeKind : unsigned char {
  unknown,  ///< too few points, or none of the others: `width` and `depth` are those of the smallest box around them
  line,     ///< one straight side; what lies behind it was not seen, so `depth` is 0
  circle,   ///< a round thing; `width` and `depth` are its diameter
  box,      ///< two sides at a right angle
};

/// "unknown", "line", "circle", "box"
const char* to_string(ShapeKind kind) noexcept;

/// What points say about the thing they are of, in the map's frame. Extents are of what was seen: where an end was not
/// (`width_seen`, `depth_seen`), the thing may be larger, and nothing is guessed.
struct Shape {
  ShapeKind kind = ShapeKind::unknown;
  /// Of the circle or box, the middle of a line's seen part, or that of the box around the points [m].
  Point2 centre = Point2::Zero();
  /// Of the centre, by the ranges' noise and the beams' spacing; the pose's own is not in it [m^2].
  Matrix<2, 2> covariance = Matrix<2, 2>::Zero();
  double radius = 0.0;         ///< of a circle [m], else 0
  double radius_sigma = 0.0;   ///< [m]
  double arc = 0.0;            ///< of a circle: how much of it was seen [rad], else 0
  double width = 0.0;          ///< the longer side [m]
  double width_sigma = 0.0;    ///< of what was seen of it [m]
  double depth = 0.0;          ///< the shorter side [m]
  double depth_sigma = 0.0;    ///< [m]
  double heading = 0.0;        ///< of the longer side, in (-pi/2, pi/2] [rad]; 0 for a circle
  double heading_sigma = 0.0;  ///< [rad]
  bool width_seen = false;     ///< both ends of the longer side were seen
  bool depth_seen = false;     ///< both ends of the shorter side were seen
  double noise = 0.0;          ///< of the points from the outline, root mean square [m]

  /// "circle, radius 0.042 m (+- 0.006 m)", "box, 0.480 m x 0.215 m", "line, 0.31 m or longer"
  std::string brief() const;
};

}  // namespace slamicp
