// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <slamicp/search/indexed_points.hpp>

#include "search/parallel.hpp"
#include "search/spacing.hpp"
#include "search/surface_fit.hpp"

namespace slamicp {
namespace {

double spacing_of(const IndexedPoints<3>& points) noexcept {
  return sample_spacing<3>(points.points(), [&](const Point3& point, double reach, std::span<Neighbour> found) {
    return points.nearest_k(point, reach, found);
  });
}

}  // namespace

IndexedPoints<3>::IndexedPoints(PointCloud3 points, const SurfaceOptions& surfaces)
    : points_(std::move(points)), options_(surfaces) {
  check(surfaces);
  index_from(0);
  spacing_ = spacing_of(*this);
  if (options_.neighbours == 0) return;
  surfaces_.resize(points_.size());
  window_.resize(points_.size(), std::numeric_limits<float>::infinity());
  std::vector<int> all(points_.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
  estimate_surfaces(all);
}

IndexedPoints<3> IndexedPoints<3>::with_added(PointView<3> added) const {
  IndexedPoints grown = *this;
  const std::size_t first = points_.size();
  grown.points_.insert(grown.points_.end(), added.begin(), added.end());
  grown.index_from(first);
  grown.spacing_ = spacing_of(grown);
  if (!has_surfaces() && (first > 0 || options_.neighbours == 0)) return grown;

  grown.surfaces_.resize(grown.points_.size());
  grown.window_.resize(grown.points_.size(), std::numeric_limits<float>::infinity());
  grown.estimate_surfaces(grown.touched_by(first));
  return grown;
}

std::vector<int> IndexedPoints<3>::touched_by(std::size_t first_new) const {
  // A surface changes where a new point is nearer than the farthest neighbour that made it.
  std::vector<int> touched;
  std::vector<int> around;
  for (std::size_t added = first_new; added < points_.size(); ++added) {
    around.clear();
    within(points_[added], options_.radius, around);
    for (const int k : around) {
      const auto other = static_cast<std::size_t>(k);
      if ((points_[other] - points_[added]).norm() <= static_cast<double>(window_[other])) touched.push_back(k);
    }
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

void IndexedPoints<3>::index_from(std::size_t first) {
  // Swallow the small trees at the end, so that each tree stays at least twice as large as the next.
  while (!trees_.empty() && trees_.back().tree->size() <= 2 * (points_.size() - first)) {
    first = trees_.back().first;
    trees_.pop_back();
  }
  if (first == points_.size()) return;
  const PointView<3> tail = PointView<3>(points_).subspan(first);
  trees_.push_back({std::make_shared<const KdTree<3>>(tail, static_cast<int>(first)), first});
}

Neighbour IndexedPoints<3>::nearest(const Point3& query, double reach) const noexcept {
  Neighbour best;
  for (const Tree& tree : trees_) {
    const Neighbour other = tree.tree->nearest(query, reach);
    // Trees hold rising numbers, so a tie goes to the earlier tree.
    if (other.squared_distance < best.squared_distance) best = other;
    reach = std::min(reach, std::sqrt(best.squared_distance) * (1.0 + 1e-15));
  }
  return best;
}

NearestTwo IndexedPoints<3>::nearest_two(const Point3& query, double reach) const noexcept {
  NearestTwo best{{}, reach * reach};
  for (const Tree& tree : trees_) {
    const NearestTwo other = tree.tree->nearest_two(query, reach);
    double others = std::min(best.others_squared_distance, other.others_squared_distance);
    if (other.nearest.squared_distance < best.nearest.squared_distance) {
      others = std::min(others, best.nearest.squared_distance);
      best.nearest = other.nearest;
    } else {
      others = std::min(others, other.nearest.squared_distance);
    }
    best.others_squared_distance = others;
  }
  return best;
}

std::size_t IndexedPoints<3>::nearest_k(const Point3& query, double reach, std::span<Neighbour> found) const noexcept {
  std::size_t count = 0;
  for (const Tree& tree : trees_) count = tree.tree->nearest_k(query, reach, found, count);
  return count;
}

void IndexedPoints<3>::within(const Point3& query, double radius, std::vector<int>& indices) const {
  for (const Tree& tree : trees_) tree.tree->within(query, radius, indices);
}

void IndexedPoints<3>::estimate_surface(std::size_t k) noexcept {
  std::array<Neighbour, max_surface_neighbours> room;
  const std::size_t count =
      nearest_k(points_[k], options_.radius, std::span(room.data(), static_cast<std::size_t>(options_.neighbours)));
  const std::span<const Neighbour> found(room.data(), count);
  const auto place = [&](int number) -> const Point3& { return points_[static_cast<std::size_t>(number)]; };
  surfaces_[k] = fit_surface<3>(points_[k], found, options_, place).surface;
  window_[k] = surface_window(found, options_);
}

void IndexedPoints<3>::estimate_surfaces(std::span<const int> which) {
  parallel_chunks(which.size(), options_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const auto k = static_cast<std::size_t>(which[j]);
      if (is_finite<3>(points_[k])) estimate_surface(k);
    }
  });
}

}  // namespace slamicp
