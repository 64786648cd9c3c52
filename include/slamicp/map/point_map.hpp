// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include <slamicp/registration/icp_result.hpp>
#include <slamicp/search/indexed_points.hpp>

namespace slamicp {

/// A snapshot of a map: points, the surface around each, the index. It never changes; an update makes another one, and
/// whoever holds the old one (a Fix, another thread) keeps it alive. Made and held through std::shared_ptr.
template <int D>
class PointMap {
 public:
  using Pointer = std::shared_ptr<const PointMap>;

  /// A map of these points, in the map's frame [m]. Throws Error if none of them is finite.
  static Pointer create(PointCloud<D> points, const SurfaceOptions& options = {});
  /// In the plane also how it is cut into cells.
  static Pointer create(PointCloud<D> points, const SurfaceOptions& options, const CellOptions& cells) requires(D == 2);

  /// The map with its cells built, if they were not (CellOptions::eager = false), up to so many tiles of them, those
  /// near a place first; readers go on meanwhile. @returns how many were built, 0 when it is done. See
  /// CellIndex::build.
  std::size_t build(std::size_t tiles, const Point2& near) const requires(D == 2) {
    if constexpr (D == 2) return indexed_.cells().build(tiles, near);
    return 0;
  }

  /// This map without some points, in the plane: they keep their numbers but are no longer finite. Throws Error where a
  /// number is out of range.
  Pointer with_removed(std::span<const int> which) const requires(D == 2);

  /// This map and `points` behind it, in the map's frame [m]; existing points keep their numbers.
  Pointer with_added(PointView<D> points) const;

  const IndexedPoints<D>& indexed() const noexcept { return indexed_; }
  PointView<D> points() const noexcept { return indexed_.points(); }
  std::size_t size() const noexcept { return indexed_.size(); }

  /// 0 for a map just created, one more with each update.
  std::uint64_t version() const noexcept { return version_; }

 private:
  PointMap(IndexedPoints<D> indexed, std::uint64_t version) : indexed_(std::move(indexed)), version_(version) {}

  IndexedPoints<D> indexed_;
  std::uint64_t version_ = 0;
};

using PointMap2 = PointMap<2>;
using PointMap3 = PointMap<3>;

/// The map with what the scan shows and the map does not: only the outliers are added (the paper's uM, section 3.2), so
/// walls stay thin. Needs a result with `outliers_in_map`. Without outliers it is the same map.
template <int D>
typename PointMap<D>::Pointer update_with_outliers(const typename PointMap<D>::Pointer& map,
                                                   const IcpResult<D>& result);

/// The map with every point of the scan, as the original library's users had it (section 3.1, Figure 7b): walls grow
/// thicker with each scan. Needs a result with `transformed_scan`. For comparison.
template <int D>
typename PointMap<D>::Pointer update_with_all_points(const typename PointMap<D>::Pointer& map,
                                                     const IcpResult<D>& result);

extern template class PointMap<2>;
extern template class PointMap<3>;

}  // namespace slamicp
