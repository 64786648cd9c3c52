// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/geometry/pose.hpp>
#include <slamicp/registration/icp_options.hpp>

#include "registration/correspondences.hpp"
#include "registration/pair_noise.hpp"

namespace slamicp {

/// What one iteration works on.
template <int D>
struct StepInput {
  const IndexedPoints<D>& map;
  PointView<D> scan;
  std::size_t stride;  // every so many-th point takes part, beginning in the middle of the first stride
  const Pose<D>& pose;
  double gate;  // pairs at least this far apart take no part [m]
  RobustKernel kernel;
  double kernel_scale;
  const Pose<D>& guess;
  double guess_share;       // of the pairs, that hold the guess
  const NoiseModel* noise;  // null: how well the pairs hold the pose is not wanted
  const PosePrior* prior;   // with noise: fused with the pairs, each by its noise; null: the pairs alone
};

template <int D>
struct Step {
  Pose<D> pose;             // after the step
  std::size_t pairs = 0;    // that took part
  bool degenerate = false;  // some direction was not held; nothing moved there
  double reach = 0.0;       // root mean square distance of the pairs from the robot [m]
  Uncertainty uncertainty;  // at the pose before the step
};

/// The Gauss-Newton equations of the distances to the map's lines or planes, in the robot's frame.
template <int D>
struct NormalEquations {
  static constexpr int unknowns = Pose<D>::degrees_of_freedom;
  Matrix<unknowns, unknowns> information = Matrix<unknowns, unknowns>::Zero();
  typename Pose<D>::Tangent gradient = Pose<D>::Tangent::Zero();
  double squared_ranges = 0.0;  // of the pairs [m^2]
  std::size_t pairs = 0;
  NoiseSums noise;  // in the plane, where wanted

  /// A pair: the scan point in the robot's frame and in the map.
  void add(const StepInput<D>& input, const Point<D>& in_robot, const Point<D>& in_map, const Surface<D>& surface,
           const Matrix<D, D>& into_robot) noexcept;
};

/// Sums over weighted pairs that eq. (3)'s closed form needs: p in the robot's frame, m in the map, from an origin.
template <int D>
struct PairSums {
  double weights = 0.0;
  Point<D> source = Point<D>::Zero();
  Point<D> target = Point<D>::Zero();
  Matrix<D, D> products = Matrix<D, D>::Zero();  // m p^T
  double squared_ranges = 0.0;
  std::size_t pairs = 0;

  void add(const Point<D>& in_robot, const Point<D>& from_origin, double weight) noexcept;
};

/// The pose that makes eq. (3) least for the current pairs, in closed form (Horn 1987; Umeyama 1991).
template <int D>
Step<D> point_to_point_step(const StepInput<D>& input, Correspondences<D>& correspondences) noexcept;
/// @param origin  of the sums [m], near the robot: so they keep their digits far from the map's origin
template <int D>
Step<D> point_to_point_step(const StepInput<D>& input, const PairSums<D>& sums, const Point<D>& origin) noexcept;

/// A Gauss-Newton step on SE(D) for the distances to the map's lines or planes (Chen, Medioni 1992; Censi 2008).
template <int D>
Step<D> point_to_surface_step(const StepInput<D>& input, Correspondences<D>& correspondences) noexcept;
template <int D>
Step<D> point_to_surface_step(const StepInput<D>& input, NormalEquations<D> equations) noexcept;

}  // namespace slamicp
