// SPDX-License-Identifier: Apache-2.0
#include "registration/step.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <cmath>

#include "geometry/symmetric_eigen.hpp"

namespace slamicp {
namespace {

// A direction with less than this share of the strongest one's information is not held by the pairs at all.
constexpr double blind_share = 1e-5;

/// Calls use(scan point in the robot's frame, its place in the map, index of its map point, their distance [m]) for
/// every pair within the gate.
template <int D, typename Use>
void for_each_pair(const StepInput<D>& input, Correspondences<D>& correspondences, const Use& use) noexcept {
  const RigidTransform<D> T_map_robot(input.pose);
  const double gate2 = input.gate * input.gate;
  for (std::size_t i = input.stride / 2; i < input.scan.size(); i += input.stride) {
    if (!correspondences.finite(i)) continue;
    const Point<D> in_map = T_map_robot * input.scan[i];
    const Neighbour neighbour = correspondences.nearest(i, in_map);
    if (neighbour.squared_distance < gate2)
      use(input.scan[i], in_map, static_cast<std::size_t>(neighbour.index), std::sqrt(neighbour.squared_distance));
  }
}

/// d(n . (R p + t)) / d(rotation), for a small turn in the robot's frame; `normal` in the robot's frame.
double turn_jacobian(const Point2& p, const Vector<2>& normal) noexcept {
  return p.x() * normal.y() - p.y() * normal.x();
}
Vector<3> turn_jacobian(const Point3& p, const Vector<3>& normal) noexcept { return p.cross(normal); }

/// Whether all unknowns are held, for sure: determinant and trace bound the least eigenvalue from below (the others'
/// product is at most their mean's power).
template <int n>
bool holds_all(double determinant, double trace) noexcept {
  constexpr double by_far = 10.0;
  return determinant * std::pow((n - 1) / trace, n - 1) > by_far * blind_share * trace;
}

/// Solves where that is so; returns false where it is not, or is not known.
bool solve_held(const Eigen::Matrix3d& scaled, const Eigen::Vector3d& right, Eigen::Vector3d& x) noexcept {
  const Eigen::Vector3d a = scaled.col(0), b = scaled.col(1), c = scaled.col(2);
  const Eigen::Vector3d bc = b.cross(c);
  const double determinant = a.dot(bc);
  if (!holds_all<3>(determinant, scaled.trace())) return false;
  x = Eigen::Vector3d(right.dot(bc), a.dot(right.cross(c)), a.dot(b.cross(right))) / determinant;  // Cramer
  return true;
}
template <int n>
bool solve_held(const Eigen::Matrix<double, n, n>& scaled, const Eigen::Matrix<double, n, 1>& right,
                Eigen::Matrix<double, n, 1>& x) noexcept {
  const Eigen::LLT<Eigen::Matrix<double, n, n>> root(scaled);
  if (root.info() != Eigen::Success) return false;
  const double of_root = root.matrixLLT().diagonal().prod();
  if (!holds_all<n>(of_root * of_root, scaled.trace())) return false;
  x = root.solve(right);
  return true;
}

/// Solves H x = g where H holds x, and leaves x at zero where it does not. `unit` [m] makes turns comparable to
/// shifts: a turn counts by what it moves at that distance.
template <int D>
typename Pose<D>::Tangent solve(const Matrix<Pose<D>::degrees_of_freedom, Pose<D>::degrees_of_freedom>& information,
                                const typename Pose<D>::Tangent& gradient, double unit, bool& degenerate) noexcept {
  constexpr int n = Pose<D>::degrees_of_freedom;
  using Square = Eigen::Matrix<double, n, n>;
  using Column = Eigen::Matrix<double, n, 1>;
  Column scale = Column::Ones();
  scale.template tail<n - D>().setConstant(1.0 / unit);
  const Square scaled = scale.asDiagonal() * information * scale.asDiagonal();
  degenerate = false;
  Column all_held;
  if (solve_held(scaled, Column(scale.asDiagonal() * gradient), all_held)) return scale.asDiagonal() * all_held;
  const SymmetricEigen<n> eigen(scaled);
  const double strongest = eigen.values.maxCoeff();
  Column along = eigen.vectors.transpose() * (scale.asDiagonal() * gradient);
  for (int k = 0; k < n; ++k) {
    const bool held = eigen.values[k] > blind_share * strongest;
    along[k] = held ? along[k] / eigen.values[k] : 0.0;
    degenerate = degenerate || !held;
  }
  return scale.asDiagonal() * (eigen.vectors * along);
}

/// The rotation that best turns the scatter's source directions into its target's (Kabsch 1976), and whether the
/// scatter holds it. @param range2  mean square distance of the sources from the robot [m^2]
Matrix<2, 2> best_rotation(const Matrix<2, 2>& scatter, const Matrix<2, 2>& otherwise, double range2,
                           bool& degenerate) noexcept {
  // scatter = sum w target source^T; the angle maximizes trace(R^T scatter).
  const double cosine = scatter(0, 0) + scatter(1, 1);
  const double sine = scatter(1, 0) - scatter(0, 1);
  const double length = std::hypot(cosine, sine);
  // Points within a thousandth of their distance from the robot hold no turn; nor do sums in float resolve them.
  degenerate = !(length > std::max(1e-12, 1e-6 * range2));
  if (degenerate) return otherwise;
  Matrix<2, 2> rotation;
  rotation << cosine, -sine, sine, cosine;
  return rotation / length;
}

Matrix<3, 3> best_rotation(const Matrix<3, 3>& scatter, const Matrix<3, 3>& otherwise, double,
                           bool& degenerate) noexcept {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(scatter, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const auto& spread = svd.singularValues();
  degenerate = !(spread[1] > blind_share * spread[0]) || !(spread[0] > 1e-12);
  if (degenerate) return otherwise;
  Eigen::Vector3d sign = Eigen::Vector3d::Ones();
  sign[2] = svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

template <int D>
void NormalEquations<D>::add(const StepInput<D>& input, const Point<D>& in_robot, const Point<D>& in_map,
                             const Surface<D>& surface, const Matrix<D, D>& into_robot) noexcept {
  if (!surface.valid()) return;
  const double residual = surface.trust * surface.normal.dot(surface.centroid - in_map);
  const double weight = kernel_weight(input.kernel, residual, input.kernel_scale);
  if (weight == 0.0) return;  // holds nothing, so it is no pair
  const Vector<D> normal = surface.trust * (into_robot * surface.normal);
  typename Pose<D>::Tangent jacobian;
  jacobian << normal, turn_jacobian(in_robot, normal);
  information += weight * jacobian * jacobian.transpose();
  gradient += weight * residual * jacobian;
  squared_ranges += in_robot.squaredNorm();
  ++pairs;
  if constexpr (D == 2)
    if (input.noise) add_noise(*input.noise, in_robot, normal, jacobian, residual, weight, noise);
}

template <int D>
void PairSums<D>::add(const Point<D>& in_robot, const Point<D>& from_origin, double weight) noexcept {
  if (weight == 0.0) return;
  weights += weight;
  squared_ranges += in_robot.squaredNorm();
  source += weight * in_robot;
  target += weight * from_origin;
  products += weight * from_origin * in_robot.transpose();
  ++pairs;
}

template <int D>
Step<D> point_to_point_step(const StepInput<D>& input, Correspondences<D>& correspondences) noexcept {
  const Point<D> origin = input.pose.translation();
  PairSums<D> sums;
  for_each_pair<D>(input, correspondences, [&](const Point<D>& p, const Point<D>&, std::size_t k, double distance) {
    sums.add(p, input.map.points()[k] - origin, kernel_weight(input.kernel, distance, input.kernel_scale));
  });
  return point_to_point_step(input, sums, origin);
}

template <int D>
Step<D> point_to_point_step(const StepInput<D>& input, const PairSums<D>& sums, const Point<D>& origin) noexcept {
  Step<D> step;
  step.pose = input.pose;
  step.pairs = sums.pairs;
  if (!(sums.weights > 0.0)) return step;

  const Point<D> source = sums.source / sums.weights;
  const Point<D> target = sums.target / sums.weights;
  const Matrix<D, D> scatter = sums.products / sums.weights - target * source.transpose();
  const double range2 = sums.squared_ranges / static_cast<double>(sums.pairs);
  const Matrix<D, D> rotation = best_rotation(scatter, input.pose.rotation(), range2, step.degenerate);
  step.reach = std::sqrt(range2);
  step.pose = Pose<D>::from(rotation, origin + target - rotation * source);
  return step;
}

template <int D>
Step<D> point_to_surface_step(const StepInput<D>& input, Correspondences<D>& correspondences) noexcept {
  const Matrix<D, D> into_robot = input.pose.rotation().transpose();
  NormalEquations<D> equations;
  for_each_pair<D>(input, correspondences, [&](const Point<D>& p, const Point<D>& in_map, std::size_t k, double) {
    equations.add(input, p, in_map, input.map.surface(k), into_robot);
  });
  return point_to_surface_step(input, equations);
}

namespace {

/// How well the pairs hold the pose; the motion too where a prior takes part. Returns whether it does.
bool judge(const StepInput<2>& input, NormalEquations<2>& equations, Step<2>& step) noexcept {
  equations.noise.close_group();
  const Eigen::Vector3d gradient = equations.gradient;
  const double reach = std::max(step.reach, 1e-6);
  Assessment pairs = assess(equations.information, gradient, equations.noise, *input.noise, reach);
  if (input.prior != nullptr) align_blind_direction(input.prior->information, reach, pairs);
  step.uncertainty = pairs.uncertainty;
  if (input.prior == nullptr) return false;
  step.degenerate = pairs.uncertainty.blind;
  const Pose2::Tangent from_prior = (input.pose.inverse() * input.prior->mean).log();
  step.pose = input.pose * Pose2::exp(fused_motion(pairs, gradient, input.prior->information, from_prior));
  return true;
}

}  // namespace

template <int D>
Step<D> point_to_surface_step(const StepInput<D>& input, NormalEquations<D> equations) noexcept {
  constexpr int n = Pose<D>::degrees_of_freedom;
  Step<D> step;
  step.pose = input.pose;
  step.pairs = equations.pairs;
  if (step.pairs == 0) return step;

  step.reach = std::sqrt(equations.squared_ranges / static_cast<double>(step.pairs));
  if (!(equations.information.trace() > 0.0)) {
    step.degenerate = true;
    return step;
  }
  if (input.guess_share > 0.0) {
    // The guess as pairs: a pull back to it, in every direction alike; a turn counts by what it moves at the reach.
    typename Pose<D>::Tangent weight = Pose<D>::Tangent::Constant(input.guess_share * static_cast<double>(step.pairs));
    weight.template tail<n - D>() *= step.reach * step.reach;
    equations.information += Matrix<n, n>(weight.asDiagonal());
    equations.gradient += weight.cwiseProduct((input.pose.inverse() * input.guess).log());
  }
  if constexpr (D == 2)
    if (input.noise && judge(input, equations, step)) return step;
  const auto motion = solve<D>(equations.information, equations.gradient, std::max(step.reach, 1e-6), step.degenerate);
  step.pose = input.pose * Pose<D>::exp(motion);
  return step;
}

template struct NormalEquations<2>;
template struct PairSums<2>;
template Step<2> point_to_point_step(const StepInput<2>&, Correspondences<2>&) noexcept;
template Step<3> point_to_point_step(const StepInput<3>&, Correspondences<3>&) noexcept;
template Step<2> point_to_point_step(const StepInput<2>&, const PairSums<2>&, const Point<2>&) noexcept;
template Step<2> point_to_surface_step(const StepInput<2>&, Correspondences<2>&) noexcept;
template Step<3> point_to_surface_step(const StepInput<3>&, Correspondences<3>&) noexcept;
template Step<2> point_to_surface_step(const StepInput<2>&, NormalEquations<2>) noexcept;

}  // namespace slamicp
