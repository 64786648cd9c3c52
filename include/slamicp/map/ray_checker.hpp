// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/search/indexed_points.hpp>

namespace slamicp {

/// What the map has where a ray ends: a surface, one near by, nothing.
enum class RayEnd { explained, beside, open };

/// Where a ray meets a mapped wall.
struct WallMet {
  bool met = false;
  double distance = 0.0;  ///< from the ray's start, along the ray [m]
  /// How steeply: the sine of the angle between ray and wall; 0 where the map has no direction for the wall there.
  double steepness = 0.0;

  /// False where the ray grazes the wall, so that a small error decides whether it meets it at all.
  bool sure() const noexcept { return steepness > 0.1; }
};

/// Holds rays against a map, one at a time. Keeps a reference to the map.
class RayChecker {
 public:
  /// A match distance for walks along rays, where no match has one [m].
  static constexpr double usual_distance = 0.3;

  /// @param match_distance  a ray that ends closer to a map point than this ends near a surface [m]
  /// @param noise           of a point from its line, of range and map together, 1 sigma [m]
  RayChecker(const IndexedPoints<2>& map, double match_distance, double noise) noexcept;

  /// @param to  in the map [m]
  RayEnd end_of(const Point2& to) const noexcept;

  /// True if there is a wall on the way. O(length of the ray / match_distance) where no walls are near.
  /// @param from, to  in the map [m]
  bool passes_wall(const Point2& from, const Point2& to) const noexcept;

  /// The first wall that a ray meets, between `start` and `reach` from where it begins. O(length of the way) where no
  /// walls are near; near one a search each step.
  /// @param from       in the map [m]
  /// @param direction  unit length
  WallMet first_wall(const Point2& from, const Vector<2>& direction, double start, double reach) const noexcept;

 private:
  WallMet wall_at(int wall, const Point2& from, const Vector<2>& direction, double at) const noexcept;
  bool parts(int wall, const Point2& from, const Point2& to) const noexcept;

  const IndexedPoints<2>& points_;
  double match_distance_;
  double on_surface_;  // farther from a line than this a point is beside it [m]
  double step_;        // how far a search looks [m]: as far as the map answers at once
  double touch_;       // a ray that passes a map point closer than this meets what it is a point of [m]
};

}  // namespace slamicp
