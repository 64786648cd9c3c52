// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/search/indexed_points.hpp>

#include "search/parallel.hpp"

namespace slamicp {
namespace {

constexpr std::size_t max_neighbours = 64;

void check(const SurfaceOptions& options) {
  const auto refuse = [](const char* what, const char* mend) { throw Error(what, "SurfaceOptions", mend); };
  if (options.neighbours < 0 || options.neighbours > static_cast<int>(max_neighbours))
    refuse("neighbours is out of range", "give 0 (no surfaces) to 64; 12 is the default");
  if (!(options.radius > 0.0)) refuse("radius is not above zero", "give metres; 0.5 is the default");
  if (options.min_neighbours < 3) refuse("min_neighbours is below 3", "two points make no surface; 5 is the default");
  if (options.neighbours > 0 && options.min_neighbours > options.neighbours)
    refuse("min_neighbours is above neighbours", "no point could have a surface: lower it, or give 0 neighbours");
  if (options.threads < 1) refuse("threads is below 1", "give the number of threads to use");
}

}  // namespace

template <int D>
IndexedPoints<D>::IndexedPoints(PointCloud<D> points, const SurfaceOptions& options)
    : points_(std::move(points)), options_(options) {
  check(options);
  index_from(0);
  spacing_ = sample_spacing();
  if (options_.neighbours == 0) return;
  surfaces_.resize(points_.size());
  window_.resize(points_.size(), std::numeric_limits<float>::infinity());
  std::vector<int> all(points_.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
  estimate_surfaces(all);
}

template <int D>
IndexedPoints<D> IndexedPoints<D>::with_added(PointView<D> added) const {
  IndexedPoints grown = *this;
  const std::size_t first = points_.size();
  grown.points_.insert(grown.points_.end(), added.begin(), added.end());
  grown.index_from(first);
  grown.spacing_ = grown.sample_spacing();
  if (!has_surfaces() && (first > 0 || options_.neighbours == 0)) return grown;

  grown.surfaces_.resize(grown.points_.size());
  grown.window_.resize(grown.points_.size(), std::numeric_limits<float>::infinity());
  grown.estimate_surfaces(grown.touched_by(first));
  return grown;
}

template <int D>
std::vector<int> IndexedPoints<D>::touched_by(std::size_t first_new) const {
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

template <int D>
void IndexedPoints<D>::index_from(std::size_t first) {
  // Swallow the small trees at the end, so that each tree stays at least twice as large as the next.
  while (!trees_.empty() && trees_.back().tree->size() <= 2 * (points_.size() - first)) {
    first = trees_.back().first;
    trees_.pop_back();
  }
  if (first == points_.size()) return;
  const PointView<D> tail = PointView<D>(points_).subspan(first);
  trees_.push_back({std::make_shared<const KdTree<D>>(tail, static_cast<int>(first)), first});
}

template <int D>
Neighbour IndexedPoints<D>::nearest(const Point<D>& query, double reach) const noexcept {
  Neighbour best;
  for (const Tree& tree : trees_) {
    const Neighbour other = tree.tree->nearest(query, reach);
    // Trees hold rising numbers, so a tie goes to the earlier tree.
    if (other.squared_distance < best.squared_distance) best = other;
    reach = std::min(reach, std::sqrt(best.squared_distance) * (1.0 + 1e-15));
  }
  return best;
}

template <int D>
NearestTwo IndexedPoints<D>::nearest_two(const Point<D>& query, double reach) const noexcept {
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

template <int D>
std::size_t IndexedPoints<D>::nearest_k(const Point<D>& query, double reach,
                                        std::span<Neighbour> found) const noexcept {
  std::size_t count = 0;
  for (const Tree& tree : trees_) count = tree.tree->nearest_k(query, reach, found, count);
  return count;
}

template <int D>
void IndexedPoints<D>::within(const Point<D>& query, double radius, std::vector<int>& indices) const {
  for (const Tree& tree : trees_) tree.tree->within(query, radius, indices);
}

template <int D>
void IndexedPoints<D>::estimate_surface(std::size_t k) noexcept {
  std::array<Neighbour, max_neighbours> storage;
  const std::span<Neighbour> found(storage.data(), static_cast<std::size_t>(options_.neighbours));
  const std::size_t count = nearest_k(points_[k], options_.radius, found);
  surfaces_[k] = {};
  constexpr float infinity = std::numeric_limits<float>::infinity();  // rounding up: a window too wide costs little
  window_[k] = count < found.size()
                   ? infinity
                   : std::nextafter(static_cast<float>(std::sqrt(found.back().squared_distance)), infinity);
  if (count < static_cast<std::size_t>(std::max(options_.min_neighbours, D + 1))) return;

  // Sums relative to the point: no digits are lost far from the map's origin.
  Vector<D> mean = Vector<D>::Zero();
  Matrix<D, D> scatter = Matrix<D, D>::Zero();
  for (std::size_t j = 0; j < count; ++j) {
    const Vector<D> offset = points_[static_cast<std::size_t>(found[j].index)] - points_[k];
    mean += offset;
    scatter += offset * offset.transpose();
  }
  mean /= static_cast<double>(count);
  scatter = scatter / static_cast<double>(count) - mean * mean.transpose();

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> eigen(scatter);
  // The normal is the direction of least spread. Where the two least spreads are alike (duplicates, points on a
  // line in space) there is no surface.
  const double least = std::max(eigen.eigenvalues()[0], 0.0);
  const double next = eigen.eigenvalues()[1];
  if (!(next > 1e-12) || !(least < 0.9 * next)) return;
  surfaces_[k] = {points_[k] + mean, eigen.eigenvectors().col(0)};
}

template <int D>
void IndexedPoints<D>::estimate_surfaces(std::span<const int> which) {
  parallel_chunks(which.size(), options_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const auto k = static_cast<std::size_t>(which[j]);
      if (is_finite<D>(points_[k])) estimate_surface(k);
    }
  });
}

template <int D>
double IndexedPoints<D>::sample_spacing() const noexcept {
  constexpr std::size_t samples = 256;
  std::array<double, samples> distances{};
  std::size_t count = 0;
  const std::size_t step = std::max<std::size_t>(1, points_.size() / samples);
  for (std::size_t k = 0; k < points_.size() && count < samples; k += step) {
    std::array<Neighbour, 2> two;
    if (nearest_k(points_[k], 1e6, two) == 2) distances[count++] = std::sqrt(two[1].squared_distance);
  }
  if (count == 0) return 0.0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(distances.begin(), middle, distances.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

template class IndexedPoints<2>;
template class IndexedPoints<3>;

}  // namespace slamicp
