// SPDX-License-Identifier: Apache-2.0
#include "mapping/map_refinement.hpp"

#include <algorithm>

namespace slamicp {
namespace {

// Neighbours are those within this many reaches; a point seen less than this share of the most seen one is noise.
constexpr double neighbourhood = 2.0;
constexpr double smallest_share = 0.25;

}  // namespace

void MapRefinement::count(const Fix& fix) {
  seen_.resize(std::max(seen_.size(), fix.map->size()));
  for (std::size_t i = 0; i < fix.match.matches.size(); ++i) {
    const Match& match = fix.match.matches[i];
    if (match.map_index < 0 || !(match.distance < reach_)) continue;
    Seen& seen = seen_[static_cast<std::size_t>(match.map_index)];
    seen.sum += fix.pose * fix.scan.in_robot[i];
    seen.times += 1.0;
  }
}

PointCloud2 MapRefinement::refined(const PointMap2& map) const {
  // A point counts as seen once when it was added.
  const auto times = [this](std::size_t k) { return 1.0 + (k < seen_.size() ? seen_[k].times : 0.0); };
  PointCloud2 points;
  std::vector<int> around;
  for (std::size_t k = 0; k < map.size(); ++k) {
    const Point2& point = map.points()[k];
    around.clear();
    map.indexed().within(point, neighbourhood * reach_, around);
    double most = 0.0;
    for (const int other : around) most = std::max(most, times(static_cast<std::size_t>(other)));
    if (times(k) < smallest_share * most) continue;
    const Point2 sum = k < seen_.size() ? Point2(point + seen_[k].sum) : point;
    points.push_back(sum / times(k));
  }
  return points;
}

}  // namespace slamicp
