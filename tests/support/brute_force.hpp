// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include <slamicp/search/neighbour.hpp>

namespace slamicp::test {

/// The oracle of every index: look at all points, in double. Nearest first, ties to the lower index; what is not finite
/// or not closer than `reach` is not found.
template <int D>
std::vector<Neighbour> all_within(const PointCloud<D>& points, const Point<D>& query, double reach) {
  std::vector<Neighbour> found;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double squared_distance = (points[k] - query).squaredNorm();
    if (squared_distance < reach * reach) found.push_back({static_cast<int>(k), squared_distance});
  }
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance : a.index < b.index;
  });
  return found;
}

template <int D>
Neighbour nearest_of_all(const PointCloud<D>& points, const Point<D>& query, double reach) {
  Neighbour best;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double squared_distance = (points[k] - query).squaredNorm();
    if (squared_distance < reach * reach && squared_distance < best.squared_distance)
      best = {static_cast<int>(k), squared_distance};
  }
  return best;
}

inline bool operator==(const Neighbour& a, const Neighbour& b) {
  return a.index == b.index && a.squared_distance == b.squared_distance;
}

}  // namespace slamicp::test
