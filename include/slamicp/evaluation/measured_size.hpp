// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <slamicp/geometry/point_cloud.hpp>
#include <slamicp/obstacles/reconstruction.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// The circle with the least squared distances to the points, by Gauss-Newton from their mean. Nothing for fewer than
/// three points, or where they do not bend. O(n) a step.
std::optional<Circle> fit_circle(PointView<2> points);

/// A thing that a drive's outliers add up to, beside the truth (the paper's Figure 16).
struct MeasuredThing {
  PointCloud2 points;           ///< its points after the filter, in the map
  OrientedBox box;              ///< around them
  std::optional<Circle> round;  ///< through them
};

/// The reconstructed obstacle that stands nearest to the placed one; nothing where none stands within 0.3 m.
std::optional<MeasuredThing> measured_thing(const PointCloud2& outliers, const PlacedObstacle& placed,
                                            const ReconstructionOptions& options = {});

}  // namespace slamicp
