// SPDX-License-Identifier: Apache-2.0
// Outliers by comparing points with points, no index. Plain arrays only: these files have compiler options of their
// own, which must not leak into inline functions that others share.
#pragma once

#include <cstddef>

namespace slamicp::bench {

/// Coordinates side by side, x in one array and y in another [m].
template <class Real>
struct Coordinates {
  const Real* x;
  const Real* y;
  std::size_t size;
};

/// The squared distance from a point to the nearest of the map's, every one of them looked at, in double, one at a
/// time: what the paper's original agent does for every scan point.
double squared_distance_scalar(const Coordinates<double>& map, double x, double y);

/// The same with every lane that the processor has, in float: as good as a compiler makes brute force.
float squared_distance_vectorized(const Coordinates<float>& map, float x, float y);

/// Whether some map point is closer than the limit: the scan through the map stops at the first. In double.
bool any_closer(const Coordinates<double>& map, double x, double y, double squared_limit);

}  // namespace slamicp::bench
