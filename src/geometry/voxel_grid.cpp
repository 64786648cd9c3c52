// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <slamicp/error.hpp>
#include <slamicp/geometry/voxel_grid.hpp>

namespace slamicp {
namespace {

template <int D>
using Cell = std::array<std::int64_t, D>;

struct CellHash {
  template <std::size_t N>
  std::size_t operator()(const std::array<std::int64_t, N>& cell) const noexcept {
    std::uint64_t hash = 0;
    for (const std::int64_t part : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

}  // namespace

template <int D>
PointCloud<D> voxel_downsampled(PointView<D> cloud, double size) {
  if (!(size > 0.0) || !std::isfinite(size))
    throw Error("the voxel size is not a length above 0 m", "voxel_downsampled", "give metres, such as 0.25");
  struct Sum {
    Point<D> points = Point<D>::Zero();
    double count = 0.0;
  };
  std::unordered_map<Cell<D>, std::size_t, CellHash> places;
  std::vector<Sum> sums;
  for (const Point<D>& point : cloud) {
    if (!is_finite<D>(point)) continue;
    Cell<D> cell;
    for (int axis = 0; axis < D; ++axis) {
      const double index = std::floor(point[axis] / size);
      if (!(std::abs(index) < 9e18))
        throw Error("the voxel size is too small for the cloud's extent", "voxel_downsampled", "give a larger one");
      cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(index);
    }
    const auto [entry, is_new] = places.try_emplace(cell, sums.size());
    if (is_new) sums.emplace_back();
    Sum& sum = sums[entry->second];
    sum.points += point;
    sum.count += 1.0;
  }
  PointCloud<D> thinned;
  thinned.reserve(sums.size());
  for (const Sum& sum : sums) thinned.push_back(sum.points / sum.count);
  return thinned;
}

template PointCloud<2> voxel_downsampled<2>(PointView<2>, double);
template PointCloud<3> voxel_downsampled<3>(PointView<3>, double);

}  // namespace slamicp
