// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// A rectangle in the plane.
struct OrientedBox {
  Point2 centre = Point2::Zero();  ///< [m]
  double width = 0.0;              ///< the longer side [m]
  double depth = 0.0;              ///< the shorter side [m]
  double heading = 0.0;            ///< of the longer side, in (-pi/2, pi/2] [rad]
};

/// The rectangle of least area around the points: one of its sides lies on a side of their convex hull (Freeman,
/// Shapira 1975). Zero sides where the points do not span them; all zero without points. Points that are not finite
/// are left out. O(n log n + hull^2).
OrientedBox smallest_box(PointView<2> points);

/// The same for many sets of points, one after the other: it keeps its memory.
class BoxFinder {
 public:
  /// Room for so many points: sets up to these allocate nothing.
  void reserve(std::size_t points);
  OrientedBox smallest(PointView<2> points);

 private:
  PointCloud2 points_;
  PointCloud2 hull_;
};

/// The box with the heading of `box` that leaves the share `trim` of the points outside each of its sides.
OrientedBox trimmed_box(const OrientedBox& box, PointView<2> points, double trim);

}  // namespace slamicp
