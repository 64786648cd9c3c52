// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/geometry/pose.hpp>
#include <slamicp/registration/icp_options.hpp>

#include "registration/correspondences.hpp"

namespace slamicp {

/// What one iteration works on.
template <int D>
struct StepInput {
  const IndexedPoints<D>& map;
  PointView<D> scan;
  const Pose<D>& pose;
  double gate;  // pairs at least this far apart take no part [m]
  RobustKernel kernel;
  double kernel_scale;
  const Pose<D>& guess;
  double guess_share;  // of the pairs, that hold the guess
};

template <int D>
struct Step {
  Pose<D> pose;             // after the step
  std::size_t pairs = 0;    // that took part
  bool degenerate = false;  // some direction was not held; nothing moved there
  double reach = 0.0;       // root mean square distance of the pairs from the robot [m]
};

/// The pose that makes eq. (3) least for the current pairs, in closed form (Horn 1987; Umeyama 1991).
template <int D>
Step<D> point_to_point_step(const StepInput<D>& input, Correspondences<D>& correspondences) noexcept;

/// A Gauss-Newton step on SE(D) for the distances to the map's lines or planes (Chen, Medioni 1992; Censi 2008).
template <int D>
Step<D> point_to_surface_step(const StepInput<D>& input, Correspondences<D>& correspondences) noexcept;

}  // namespace slamicp
