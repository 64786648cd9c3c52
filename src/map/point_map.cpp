// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <slamicp/error.hpp>
#include <slamicp/map/point_map.hpp>

namespace slamicp {

namespace {

template <int D>
void check_some_are_finite(const PointCloud<D>& points) {
  if (std::none_of(points.begin(), points.end(), is_finite<D>))
    throw Error(points.empty() ? "a map of no points" : "a map of which no point is finite", "PointMap::create",
                "give at least one point with finite coordinates [m]");
}

}  // namespace

template <int D>
typename PointMap<D>::Pointer PointMap<D>::create(PointCloud<D> points, const SurfaceOptions& options) {
  check_some_are_finite<D>(points);
  return Pointer(new PointMap(IndexedPoints<D>(std::move(points), options), 0));
}

template <int D>
typename PointMap<D>::Pointer PointMap<D>::create(PointCloud<D> points, const SurfaceOptions& options,
                                                  const CellOptions& cells) requires(D == 2) {
  check_some_are_finite<D>(points);
  // clang 14 instantiates this in space too, where nobody can call it.
  if constexpr (D == 2) return Pointer(new PointMap(IndexedPoints<D>(std::move(points), options, cells), 0));
  return nullptr;
}

template <int D>
typename PointMap<D>::Pointer PointMap<D>::with_removed(std::span<const int> which) const requires(D == 2) {
  if constexpr (D == 2) return Pointer(new PointMap(indexed_.with_removed(which), version_ + 1));
  return nullptr;
}

template <int D>
typename PointMap<D>::Pointer PointMap<D>::with_added(PointView<D> points) const {
  return Pointer(new PointMap(indexed_.with_added(points), version_ + 1));
}

template <int D>
typename PointMap<D>::Pointer update_with_outliers(const typename PointMap<D>::Pointer& map,
                                                   const IcpResult<D>& result) {
  return result.outliers_in_map.empty() ? map : map->with_added(result.outliers_in_map);
}

template <int D>
typename PointMap<D>::Pointer update_with_all_points(const typename PointMap<D>::Pointer& map,
                                                     const IcpResult<D>& result) {
  return result.transformed_scan.empty() ? map : map->with_added(result.transformed_scan);
}

template class PointMap<2>;
template class PointMap<3>;
template PointMap<2>::Pointer update_with_outliers(const PointMap<2>::Pointer&, const IcpResult<2>&);
template PointMap<3>::Pointer update_with_outliers(const PointMap<3>::Pointer&, const IcpResult<3>&);
template PointMap<2>::Pointer update_with_all_points(const PointMap<2>::Pointer&, const IcpResult<2>&);
template PointMap<3>::Pointer update_with_all_points(const PointMap<3>::Pointer&, const IcpResult<3>&);

}  // namespace slamicp
