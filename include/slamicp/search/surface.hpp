// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// The line (2D) or plane (3D) that the map follows around one of its points.
///
/// It goes through the centroid of the point's neighbours, not through the point: a wall of a real map is a few
/// centimetres thick, and a match to lines through single points follows that noise.
template <int D>
struct Surface {
  Point<D> centroid = Point<D>::Zero();  ///< in the map's frame [m]
  Vector<D> normal = Vector<D>::Zero();  ///< unit length; zero where there is no surface to speak of

  bool valid() const noexcept { return normal.squaredNorm() > 0.5; }
};

using Surface2 = Surface<2>;
using Surface3 = Surface<3>;

/// How a map's surfaces are estimated.
struct SurfaceOptions {
  /// Neighbours that take part, the point itself included. Fewer follow the noise, more round off corners. 0: no
  /// surfaces, for point-to-point only. Range 0 to 64.
  int neighbours = 12;
  /// Neighbours farther than this do not take part [m]. Too large rounds off door jambs in a thin map, too small
  /// leaves points without a surface.
  double radius = 0.5;
  /// With fewer neighbours than this within `radius` (in 3D fewer than 4) a point has no surface. At least 3, at most
  /// `neighbours`.
  int min_neighbours = 5;
  /// Threads to use; the result is the same for any number. At least 1.
  int threads = 1;
};

}  // namespace slamicp
