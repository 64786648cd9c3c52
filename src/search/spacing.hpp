// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/search/neighbour.hpp>

namespace slamicp {

/// Median distance from a point to its nearest neighbour [m], over a sample of the points; 0 where none has one.
/// @param nearest_k  as an index has it; a point that cannot be found has no neighbours
template <int D, typename NearestK>
double sample_spacing(PointView<D> points, const NearestK& nearest_k) noexcept {
  constexpr std::size_t samples = 256;
  constexpr double reach = 1e6;
  std::array<double, samples> distances{};
  std::size_t count = 0;
  const std::size_t step = std::max<std::size_t>(1, points.size() / samples);
  for (std::size_t k = 0; k < points.size() && count < samples; k += step) {
    std::array<Neighbour, 2> two;
    if (nearest_k(points[k], reach, two) == 2) distances[count++] = std::sqrt(two[1].squared_distance);
  }
  if (count == 0) return 0.0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(distances.begin(), middle, distances.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

}  // namespace slamicp
