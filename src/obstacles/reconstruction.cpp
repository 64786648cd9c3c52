// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/obstacles/reconstruction.hpp>
#include <slamicp/search/kd_tree.hpp>

namespace slamicp {
namespace {

using Cell = std::pair<std::int64_t, std::int64_t>;
using Cells = std::map<Cell, std::vector<int>>;

bool well_supported(const PointCloud2& cloud, std::size_t k, const KdTree<2>& tree,
                    const ReconstructionOptions& options, std::vector<Neighbour>& around) {
  return is_finite<2>(cloud[k]) && tree.nearest_k(cloud[k], options.filter_radius, around) == around.size();
}

/// The points that pass the filter, in cells so small that the points of one surely belong together.
Cells supported_cells(const PointCloud2& cloud, const ReconstructionOptions& options) {
  const KdTree<2> tree(cloud);
  const double side = options.gap / 1.4143;  // its diagonal is just below the gap
  std::vector<Neighbour> around(static_cast<std::size_t>(options.filter_neighbours) + 1);  // itself, too
  Cells cells;
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    if (!well_supported(cloud, k, tree, options, around)) continue;
    const Cell cell(std::llround(cloud[k].x() / side), std::llround(cloud[k].y() / side));
    cells[cell].push_back(static_cast<int>(k));
  }
  return cells;
}

bool any_pair_within(const PointCloud2& cloud, const std::vector<int>& a, const std::vector<int>& b, double gap) {
  for (const int i : a)
    for (const int j : b)
      if ((cloud[static_cast<std::size_t>(i)] - cloud[static_cast<std::size_t>(j)]).norm() < gap) return true;
  return false;
}

/// Everything that hangs together with the first cell, step by step no farther than the gap; taken out of `cells`.
std::vector<int> take_group(const PointCloud2& cloud, double gap, Cells& cells) {
  constexpr std::int64_t reach = 2;  // cells that a gap can bridge
  std::vector<Cells::node_type> taken;
  taken.push_back(cells.extract(cells.begin()));
  std::vector<int> group;
  for (std::size_t next = 0; next < taken.size(); ++next) {
    const Cell here = taken[next].key();
    const std::vector<int> members = taken[next].mapped();
    group.insert(group.end(), members.begin(), members.end());
    for (std::int64_t dx = -reach; dx <= reach; ++dx) {
      for (std::int64_t dy = -reach; dy <= reach; ++dy) {
        const auto other = cells.find({here.first + dx, here.second + dy});
        if (other != cells.end() && any_pair_within(cloud, members, other->second, gap))
          taken.push_back(cells.extract(other));
      }
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
  if (!(noise > 0.0)) return "noise must be a length above 0 m; 0.012 m is the default";
  return {};
}

void SeenThings::add(const Fix& fix, const LaserScan& scan, std::span<const Obstacle> obstacles) {
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.ray_class != RayClass::obstacle) continue;
    for (const int point : obstacle.points) {
      const auto i = static_cast<std::size_t>(point);
      points.push_back(fix.pose * fix.scan.in_robot[i]);
      lasers.push_back(fix.pose * ray_origin(fix, scan, i));
    }
  }
}

std::vector<Obstacle> reconstruct_obstacles(const PointCloud2& outliers, const ReconstructionOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "ReconstructionOptions");
  Cells cells = supported_cells(outliers, options);
  std::vector<Obstacle> obstacles;
  while (!cells.empty()) {
    Obstacle obstacle;
    obstacle.points = take_group(outliers, options.gap, cells);
    if (obstacle.points.size() < static_cast<std::size_t>(options.min_points)) continue;
    PointCloud2 members;
    members.reserve(obstacle.points.size());
    for (const int i : obstacle.points) members.push_back(outliers[static_cast<std::size_t>(i)]);
    obstacle.box = trimmed_box(smallest_box(members), members, options.trim);
    obstacles.push_back(std::move(obstacle));
  }
  std::stable_sort(obstacles.begin(), obstacles.end(),
                   [](const Obstacle& a, const Obstacle& b) { return a.points.size() > b.points.size(); });
  return obstacles;
}

std::vector<Obstacle> reconstruct_shapes(const SeenThings& seen, const ReconstructionOptions& options) {
  std::vector<Obstacle> obstacles = reconstruct_obstacles(seen.points, options);
  PointCloud2 points, lasers;
  for (Obstacle& obstacle : obstacles) {
    points.clear();
    lasers.clear();
    for (const int point : obstacle.points) {
      points.push_back(seen.points[static_cast<std::size_t>(point)]);
      lasers.push_back(seen.lasers[static_cast<std::size_t>(point)]);
    }
    obstacle.shape = shape_of_run(points, lasers, options.noise);
    obstacle.ray_class = RayClass::obstacle;
  }
  return obstacles;
}

}  // namespace slamicp
