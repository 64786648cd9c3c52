// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
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
  /// What a residual to it counts in a match, in (0, 1]: see SurfaceOptions::scatter.
  double trust = 1.0;

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
  /// In the plane: a line around which its points scatter more than this times as much as they do on the map's median
  /// line (in variance, and a centimetre at least) counts the less for it: one through a corner, or through both faces
  /// of a door leaf, is not where a wall is. Too small doubts good walls. Infinite: all lines are trusted alike, see
  /// sparse(); so are those that change as an index gains and loses points. Above 0.
  double scatter = 1.3;
  /// Threads to use; the result is the same for any number. At least 1.
  int threads = 1;

  /// For points that lie far apart, as those of a single scan or of a map in the making: every line is trusted.
  static SurfaceOptions sparse() noexcept {
    SurfaceOptions options;
    options.scatter = std::numeric_limits<double>::infinity();
    return options;
  }
};

}  // namespace slamicp
