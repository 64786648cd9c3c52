// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <slamicp/localization/fix.hpp>
#include <slamicp/map/ray_checker.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// What a ray that fits nothing in the map says about the map. It does not say what a robot may drive through: whatever
/// a ray ends on stands there.
enum class RayClass : unsigned char {
  obstacle,  ///< ends in front of a mapped surface: something stands there that the map does not know
  gone,      ///< went through a mapped surface: it was taken away, a door stands open, or it is glass
  unmapped,  ///< ends where the map has nothing, neither before nor behind: beyond the edge of what was mapped
  unknown,   ///< cannot be told: the ray grazes a mapped surface, or meets one without a direction
};

/// "obstacle", "gone", "unmapped", "unknown"
const char* to_string(RayClass ray_class) noexcept;

/// Tells what rays of one fix say about its map. Keeps a reference to the map.
///
/// It follows the ray from the laser. A mapped wall that the ray has gone through, its end behind the wall's line:
/// gone. None before its end, but one beyond: obstacle. None at all: unmapped, but for an end with mapped walls to both
/// its sides, across the ray, which is in a mapped place and so an obstacle. Where the ray ran into a wall that it
/// grazes (less than 6 deg), or that has no direction, and nothing else is sure: unknown.
class RayClassifier {
 public:
  /// @param tolerance  an end this near to a wall's line is neither before nor behind it [m], > 0
  RayClassifier(const IndexedPoints<2>& map, double tolerance) noexcept;

  /// @param from, to  in the map [m]. O(length of the way to the next wall); about a microsecond.
  RayClass operator()(const Point2& from, const Point2& to) const noexcept;

 private:
  bool has_walls_beside(const Point2& place, const Vector<2>& direction) const noexcept;

  RayChecker checker_;
  double tolerance_;
};

/// The class of each of the fix's outliers, in their order.
/// @param scan  the one that the fix is of; of several that were joined any
std::vector<RayClass> classify_outliers(const Fix& fix, const LaserScan& scan);

/// Where the ray of a point of the fix starts, in the robot's frame [m].
Point2 ray_origin(const Fix& fix, const LaserScan& scan, std::size_t point) noexcept;

}  // namespace slamicp
