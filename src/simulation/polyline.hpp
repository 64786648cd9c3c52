// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// The polyline with as few of its corners as keep all others within `tolerance` [m] of it (Douglas and Peucker 1973).
/// Its ends stay; where they are the same, so does the corner farthest from them. O(n^2) at worst.
PointCloud2 simplified(const PointCloud2& corners, double tolerance);

}  // namespace slamicp
