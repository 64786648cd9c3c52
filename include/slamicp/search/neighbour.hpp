// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <limits>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// The answer to "which point is nearest, within reach?".
struct Neighbour {
  int index = -1;                                                     ///< which point; -1: none within reach
  double squared_distance = std::numeric_limits<double>::infinity();  ///< [m^2]

  bool found() const noexcept { return index >= 0; }
};

/// The nearest point, and how far everything else is at least.
struct NearestTwo {
  Neighbour nearest;
  /// No other point is closer than the square root of this [m^2]; never above the reach asked for.
  double others_squared_distance = 0.0;
};

/// What a match asks of a set of points. Every index of the library satisfies it, exactly: the answer is that of
/// a brute-force search in double precision, ties going to the lower index.
///
/// A point at `reach` or beyond is not found. Points and queries that are not finite are never found.
template <typename Index, int D>
concept NearestNeighbourIndex = requires(const Index& index, const Point<D>& query, double reach) {
  { index.nearest(query, reach) }
  noexcept->std::same_as<Neighbour>;
  { index.nearest_two(query, reach) }
  noexcept->std::same_as<NearestTwo>;
};

}  // namespace slamicp
