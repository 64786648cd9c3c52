// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <slamicp/error.hpp>
#include <slamicp/obstacles/reconstruction.hpp>
#include <slamicp/search/kd_tree.hpp>

namespace slamicp {
namespace {

std::vector<char> well_supported(const PointCloud2& cloud, const KdTree<2>& tree,
                                 const ReconstructionOptions& options) {
  std::vector<char> keep(cloud.size());
  std::vector<int> around;
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    around.clear();
    tree.within(cloud[k], options.filter_radius, around);
    keep[k] = is_finite<2>(cloud[k]) && around.size() > static_cast<std::size_t>(options.filter_neighbours);
  }
  return keep;
}

/// Everything that hangs together with `seed`, step by step no farther than the gap; taken out of `free`.
std::vector<int> take_group(int seed, const PointCloud2& cloud, const KdTree<2>& tree, double gap,
                            std::vector<char>& free) {
  std::vector<int> group{seed};
  std::vector<int> around;
  free[static_cast<std::size_t>(seed)] = 0;
  for (std::size_t next = 0; next < group.size(); ++next) {
    around.clear();
    tree.within(cloud[static_cast<std::size_t>(group[next])], gap, around);
    for (const int k : around) {
      if (!free[static_cast<std::size_t>(k)]) continue;
      free[static_cast<std::size_t>(k)] = 0;
      group.push_back(k);
    }
  }
  std::sort(group.begin(), group.end());
  return group;
}

}  // namespace

std::string ReconstructionOptions::problem() const {
  if (!(gap > 0.0)) return "gap must be a length above 0 m; 0.15 m is the default";
  if (min_points < 1) return "min_points must be at least 1";
  if (!(filter_radius > 0.0)) return "filter_radius must be a length above 0 m; 0.03 m is the default";
  if (filter_neighbours < 0) return "filter_neighbours must be at least 0 (no filter)";
  if (!(trim >= 0.0 && trim <= 0.2)) return "trim must lie between 0 and 0.2; 0.01 is the default";
  return {};
}

std::vector<Obstacle> reconstruct_obstacles(const PointCloud2& outliers, const ReconstructionOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "ReconstructionOptions");
  const KdTree<2> tree(outliers);
  std::vector<char> free = well_supported(outliers, tree, options);
  std::vector<Obstacle> obstacles;
  for (std::size_t k = 0; k < outliers.size(); ++k) {
    if (!free[k]) continue;
    Obstacle obstacle;
    obstacle.points = take_group(static_cast<int>(k), outliers, tree, options.gap, free);
    if (obstacle.points.size() < static_cast<std::size_t>(options.min_points)) continue;
    PointCloud2 members;
    members.reserve(obstacle.points.size());
    for (const int i : obstacle.points) members.push_back(outliers[static_cast<std::size_t>(i)]);
    obstacle.box = trimmed_box(smallest_box(members), members, options.trim);
    obstacles.push_back(std::move(obstacle));
  }
  std::sort(obstacles.begin(), obstacles.end(),
            [](const Obstacle& a, const Obstacle& b) { return a.points.size() > b.points.size(); });
  return obstacles;
}

}  // namespace slamicp
