// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

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

/// What points of one thing that stands still say about it, seen in many scans from many places: the box or the circle
/// that they fit along their rays, the circle where it fits as well. A side lies in the middle of its points, so that
/// noise makes nothing larger; one that was not seen ends where its neighbours do. O(points), 3000 at most.
/// @param lasers  where each point was seen from, in the map [m]
/// @param noise   of the points, by ranges and poses, 1 sigma [m]
Shape shape_of_run(PointView<2> points, PointView<2> lasers, double noise);

/// Points of one thing as one scan shows it, in beam order, all in the map's frame [m].
struct ViewOfThing {
  PointView<2> points;
  Point2 laser = Point2::Zero();  ///< where the rays come from
  double beam_spacing = 0.0;      ///< from one ray to the next [rad], above 0
  double range_noise = 0.01;      ///< of a range, 1 sigma [m], above 0
  bool first_end_seen = false;    ///< nothing hid the thing's end before the first point
  bool last_end_seen = false;     ///< nor after the last
};

/// Tells what shape points of one scan have, by evidence: line, circle and two sides at a right angle are fitted with
/// their errors along the rays, as these have them, and the Bayesian information criterion (Schwarz 1978) chooses. A
/// circle bends away from the laser, a corner points to it. An end lies on the last ray that met the thing, and where
/// it was seen half a beam beyond, as the next ray missed it.
///
/// Sides are fitted by least squares with the right angle between them, for each corner in turn (after Zhang, Xu, Dong,
/// Dolan 2017, "Efficient L-shape fitting"); circles by Gauss-Newton from the algebraic circle, as the algebraic one
/// alone is too small where little of it is seen. O(points). Keeps its memory.
class ShapeFinder {
 public:
  /// Room for so many points: up to these, find() allocates nothing.
  void reserve(std::size_t points);
  Shape find(const ViewOfThing& view);

 private:
  struct Moments {  // of points: count, sums, sums of products
    double count = 0.0;
    Vector<2> sum = Vector<2>::Zero();
    double xx = 0.0, xy = 0.0, yy = 0.0;
  };

  struct Spread {  // of points about their mean, squares and products summed
    double xx, xy, yy;
    Point2 mean;
  };

  void sum_up(PointView<2> points);
  Spread spread(std::size_t from, std::size_t to) const noexcept;

  Point2 about_ = Point2::Zero();
  std::vector<Moments> until_;  // of the points before each
};

}  // namespace slamicp
