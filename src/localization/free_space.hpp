// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/search/indexed_points.hpp>

namespace slamicp {

/// What the map has where a ray ends: a surface, one near by, nothing.
enum class RayEnd { explained, beside, open };

/// Holds rays against a map, one at a time.
class RayChecker {
 public:
  /// @param match_distance  a ray that ends closer to a map point than this ends near a surface [m]
  /// @param noise           of a point from its line, of range and map together, 1 sigma [m]
  RayChecker(const IndexedPoints<2>& map, double match_distance, double noise) noexcept;

  /// @param to  in the map [m]
  RayEnd end_of(const Point2& to) const noexcept;

  /// True if there is a wall on the way. O(length of the ray / match_distance) where no walls are near.
  /// @param from, to  in the map [m]
  bool passes_wall(const Point2& from, const Point2& to) const noexcept;

 private:
  bool parts(int wall, const Point2& from, const Point2& to) const noexcept;

  const IndexedPoints<2>& points_;
  double match_distance_;
  double on_surface_;  // farther from a line than this a point is beside it [m]
  double touch_;       // a ray that passes a map point closer than this meets what it is a point of [m]
};

}  // namespace slamicp
