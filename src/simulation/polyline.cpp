// SPDX-License-Identifier: Apache-2.0
#include "simulation/polyline.hpp"

#include <utility>
#include <vector>

#include <slamicp/simulation/world.hpp>

namespace slamicp {

PointCloud2 simplified(const PointCloud2& corners, double tolerance) {
  if (corners.size() < 3) return corners;
  const bool is_closed = corners.front() == corners.back();
  std::vector<char> stays(corners.size(), 0);
  stays.front() = stays.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, corners.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = is_closed && first == 0 && last + 1 == corners.size() ? 0.0 : tolerance;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double away = distance(Segment{corners[first], corners[last]}, corners[k]);
      if (away <= most) continue;
      most = away;
      farthest = k;
    }
    if (farthest == first) continue;
    stays[farthest] = 1;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  PointCloud2 kept;
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (stays[k] != 0) kept.push_back(corners[k]);
  return kept;
}

}  // namespace slamicp
