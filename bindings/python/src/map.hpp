// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/map/point_map.hpp>

namespace slamicp::python {

/// Python's Map: one of the two.
struct Map {
  PointMap2::Pointer plane;
  PointMap3::Pointer space;

  int dimension() const noexcept { return plane ? 2 : 3; }
  /// Throws Refusal in space.
  const PointMap2::Pointer& in_plane() const;
};

}  // namespace slamicp::python
