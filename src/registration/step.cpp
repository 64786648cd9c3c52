// SPDX-License-Identifier: Apache-2.0
#include "registration/step.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace slamicp {
namespace {

// A direction with less than this share of the strongest one's information is not held by the pairs at all.
constexpr double blind_share = 1e-5;

/// Calls use(scan point in the robot's frame, its place in the map, index of its map point, their distance [m]) for
/// every pair within the gate.
template <int D, typename Use>
void for_each_pair(const StepInput<D>& input, Correspondences<D>& correspondences, const Use& use) noexcept {
  const Matrix<D, D> rotation = input.pose.rotation();
  const Point<D> translation = input.pose.translation();
  const double gate2 = input.gate * input.gate;
  for (std::size_t i = 0; i < input.scan.size(); ++i) {
    if (!correspondences.finite(i)) continue;
    const Point<D> in_map = rotation * input.scan[i] + translation;
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
  const Eigen::SelfAdjointEigenSolver<Square> eigen(scaled);
  const double strongest = eigen.eigenvalues()[n - 1];
  Column along = eigen.eigenvectors().transpose() * (scale.asDiagonal() * gradient);
  degenerate = false;
  for (int k = 0; k < n; ++k) {
    const bool held = eigen.eigenvalues()[k] > blind_share * strongest;
    along[k] = held ? along[k] / eigen.eigenvalues()[k] : 0.0;
    degenerate = degenerate || !held;
  }
  return scale.asDiagonal() * (eigen.eigenvectors() * along);
}

/// The rotation that best turns the scatter's source directions into its target's (Kabsch 1976), and whether the
/// scatter holds it.
Matrix<2, 2> best_rotation(const Matrix<2, 2>& scatter, const Matrix<2, 2>& otherwise, bool& degenerate) noexcept {
  // scatter = sum w target source^T; the angle maximizes trace(R^T scatter).
  const double cosine = scatter(0, 0) + scatter(1, 1);
  const double sine = scatter(1, 0) - scatter(0, 1);
  const double length = std::hypot(cosine, sine);
  degenerate = !(length > 1e-12);
  if (degenerate) return otherwise;
  Matrix<2, 2> rotation;
  rotation << cosine, -sine, sine, cosine;
  return rotation / length;
}

Matrix<3, 3> best_rotation(const Matrix<3, 3>& scatter, const Matrix<3, 3>& otherwise, bool& degenerate) noexcept {
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
Step<D> point_to_point_step(const StepInput<D>& input, Correspondences<D>& correspondences) noexcept {
  Step<D> step;
  step.pose = input.pose;
  const Point<D> origin = input.pose.translation();  // sums near the robot keep their digits far from the map's origin
  double weights = 0.0;
  double reach2 = 0.0;
  Point<D> source = Point<D>::Zero();
  Point<D> target = Point<D>::Zero();
  Matrix<D, D> products = Matrix<D, D>::Zero();
  for_each_pair<D>(input, correspondences, [&](const Point<D>& p, const Point<D>&, std::size_t k, double distance) {
    const double weight = kernel_weight(input.kernel, distance, input.kernel_scale);
    if (weight == 0.0) return;  // holds nothing, so it is no pair
    const Point<D> m = input.map.points()[k] - origin;
    weights += weight;
    reach2 += p.squaredNorm();
    source += weight * p;
    target += weight * m;
    products += weight * m * p.transpose();
    ++step.pairs;
  });
  if (!(weights > 0.0)) return step;

  source /= weights;
  target /= weights;
  const Matrix<D, D> scatter = products / weights - target * source.transpose();
  const Matrix<D, D> rotation = best_rotation(scatter, input.pose.rotation(), step.degenerate);
  step.reach = std::sqrt(reach2 / static_cast<double>(step.pairs));
  step.pose = Pose<D>::from(rotation, origin + target - rotation * source);
  return step;
}

template <int D>
Step<D> point_to_surface_step(const StepInput<D>& input, Correspondences<D>& correspondences) noexcept {
  constexpr int n = Pose<D>::degrees_of_freedom;
  const Matrix<D, D> into_robot = input.pose.rotation().transpose();
  Step<D> step;
  step.pose = input.pose;
  double reach2 = 0.0;
  Matrix<n, n> information = Matrix<n, n>::Zero();
  typename Pose<D>::Tangent gradient = Pose<D>::Tangent::Zero();
  for_each_pair<D>(input, correspondences, [&](const Point<D>& p, const Point<D>& in_map, std::size_t k, double) {
    const Surface<D> surface = input.map.surface(k);
    if (!surface.valid()) return;
    const double residual = surface.normal.dot(surface.centroid - in_map);
    const double weight = kernel_weight(input.kernel, residual, input.kernel_scale);
    if (weight == 0.0) return;
    const Vector<D> normal = into_robot * surface.normal;
    typename Pose<D>::Tangent jacobian;
    jacobian << normal, turn_jacobian(p, normal);
    information += weight * jacobian * jacobian.transpose();
    gradient += weight * residual * jacobian;
    reach2 += p.squaredNorm();
    ++step.pairs;
  });
  if (step.pairs == 0) return step;

  step.reach = std::sqrt(reach2 / static_cast<double>(step.pairs));
  if (!(information.trace() > 0.0)) {
    step.degenerate = true;
    return step;
  }
  if (input.guess_share > 0.0) {
    // The guess as pairs: a pull back to it, in every direction alike; a turn counts by what it moves at the reach.
    typename Pose<D>::Tangent weight = Pose<D>::Tangent::Constant(input.guess_share * static_cast<double>(step.pairs));
    weight.template tail<n - D>() *= step.reach * step.reach;
    information += Matrix<n, n>(weight.asDiagonal());
    gradient += weight.cwiseProduct((input.pose.inverse() * input.guess).log());
  }
  const auto motion = solve<D>(information, gradient, std::max(step.reach, 1e-6), step.degenerate);
  step.pose = input.pose * Pose<D>::exp(motion);
  return step;
}

template Step<2> point_to_point_step(const StepInput<2>&, Correspondences<2>&) noexcept;
template Step<3> point_to_point_step(const StepInput<3>&, Correspondences<3>&) noexcept;
template Step<2> point_to_surface_step(const StepInput<2>&, Correspondences<2>&) noexcept;
template Step<3> point_to_surface_step(const StepInput<3>&, Correspondences<3>&) noexcept;

}  // namespace slamicp
