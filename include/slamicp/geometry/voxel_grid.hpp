// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// One point for each cube (square in 2D) of `size` [m] that holds any: their mean. Points come in the order of the
/// first of each cube; points that are not finite are dropped. O(n) on average. Throws Error unless size is above 0.
template <int D>
PointCloud<D> voxel_downsampled(PointView<D> cloud, double size);

extern template PointCloud<2> voxel_downsampled<2>(PointView<2>, double);
extern template PointCloud<3> voxel_downsampled<3>(PointView<3>, double);

}  // namespace slamicp
