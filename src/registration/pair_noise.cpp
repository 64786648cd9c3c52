// SPDX-License-Identifier: Apache-2.0
#include "registration/pair_noise.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "geometry/symmetric_eigen.hpp"

namespace slamicp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double infinite_sigma = std::numeric_limits<double>::infinity();

// Such products stand here once each: Eigen makes types of their own for every expression, which take a while to
// compile.

/// Turns count by what they move at the reach.
Vector3d by_reach(double reach) noexcept { return {1.0, 1.0, 1.0 / reach}; }

/// diag(scale) square diag(scale)
Matrix3d scaled_by(const Vector3d& scale, const Matrix3d& square) noexcept {
  return square.cwiseProduct(scale * scale.transpose());
}

/// left square left^T
Matrix3d seen_by(const Matrix3d& left, const Matrix3d& square) noexcept {
  const Matrix3d half = left * square;
  return half * left.transpose();
}

Matrix3d square_of(const Vector3d& direction) noexcept { return direction * direction.transpose(); }

/// What a point-to-point match would hold: directions along the walls as well as across.
Matrix3d held_by_points(const NoiseSums& sums) noexcept {
  Matrix3d all = Matrix3d::Zero();
  all(0, 0) = all(1, 1) = sums.weights;
  all(0, 2) = all(2, 0) = -sums.moment.y();
  all(1, 2) = all(2, 1) = sums.moment.x();
  all(2, 2) = sums.squared_ranges;
  return all;
}

/// A normal n that is off by a small random angle d pretends to hold the direction along the wall: the expectation of
/// n n^T has d^2 t t^T too much. What is left when that is taken away.
Matrix3d without_pretence(const Matrix3d& information, const NoiseSums& sums, double turn_variance) noexcept {
  return information - turn_variance * (held_by_points(sums) - information);
}

/// Below this the pairs hold nothing in a direction, in units of the information: what is left of the pretence may be
/// three standard deviations of its sum over independent lines, and the map's noise is known to a third.
double pretence_left(const NoiseSums& sums, double turn_variance) noexcept {
  return turn_variance * (3.0 * std::sqrt(2.0 * sums.sharing) + 0.33 * sums.weights);
}

/// The information in the directions that are held, and how to solve with it.
struct Held {
  Matrix3d debiased;  // without pretence and blind directions
  Matrix3d plain;     // without blind directions
  Matrix3d inverse;   // of `debiased`, on the held directions
  bool blind = false;
  Vector3d direction = Vector3d::Zero();  // the blind one, if there is one, in units of the reach
};

bool all_held(const Matrix3d& scaled, double least) noexcept {
  // The determinant over the square of the trace bounds the least eigenvalue from below.
  const double trace = scaled.trace();
  return trace > 0.0 && 4.0 * scaled.determinant() > least * trace * trace;
}

Held held_part(const Matrix3d& information, const Matrix3d& debiased, double least, double reach) noexcept {
  constexpr double blind_share = 1e-5;  // of the strongest, for maps without noise
  const Vector3d scale = by_reach(reach);
  const Matrix3d scaled = scaled_by(scale, debiased);
  least = std::max(least, blind_share * scaled.trace());
  if (all_held(scaled, least)) return {debiased, information, debiased.inverse()};
  const SymmetricEigen<3> eigen(scaled);
  Held held{Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()};
  Matrix3d keep = Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = eigen.values[k];
    const Vector3d direction = eigen.vectors.col(k);
    if (!(value > least)) {
      held.direction = held.blind ? Vector3d::Zero() : direction;
      held.blind = true;
      continue;
    }
    const Matrix3d square = square_of(direction);
    held.debiased += value * square;
    held.inverse += square / value;
    keep += square;
  }
  const Vector3d unscale = scale.cwiseInverse();
  held.debiased = scaled_by(unscale, held.debiased);
  held.inverse = scaled_by(scale, held.inverse);
  held.plain = scaled_by(unscale, seen_by(keep, scaled_by(scale, information)));
  return held;
}

double range_variance(const NoiseSums& sums, const NoiseModel& model, double explained) noexcept {
  if (model.noise.range > 0.0) return model.noise.range * model.noise.range;
  const double least = model.noise.least_range * model.noise.least_range;
  if (!(sums.squared_cosines > 0.0)) return least;
  const double of_ranges = sums.squared_residuals - explained - sums.weights * model.offset_variance();
  return std::max(least, of_ranges / sums.squared_cosines);
}

/// A sum of squares, where it is singular almost as it is.
Matrix3d regular(const Matrix3d& square) noexcept {
  return square + (1e-9 * square.trace() + 1e-30) * Matrix3d::Identity();
}

/// The inverse of a sum of squares, also where it is singular: there nothing else is asked for.
Matrix3d safe_inverse(const Matrix3d& square, double reach) noexcept {
  const Vector3d scale = by_reach(reach);
  return scaled_by(scale, regular(scaled_by(scale, square)).inverse());
}

/// What noise explains of the pairs' pulls, and what it does not: in a direction in which neighbouring pairs pull
/// together more than they should, as much as they do.
Matrix3d with_misfit(const Matrix3d& noise, const Matrix3d& together, double reach, double& misfit) noexcept {
  misfit = 1.0;
  const Vector3d scale = by_reach(reach);
  const Eigen::LLT<Matrix3d> root(regular(scaled_by(scale, noise)));
  const Matrix3d lower = root.matrixL();
  Eigen::SelfAdjointEigenSolver<Matrix3d> eigen;
  eigen.computeDirect(seen_by(lower.inverse(), scaled_by(scale, together)));
  const Vector3d more = (eigen.eigenvalues().array() - 1.0).max(0.0);
  misfit = 1.0 + more.sum() / 3.0;
  if (!(misfit > 1.0)) return noise;
  const Matrix3d back = lower * eigen.eigenvectors();
  return noise + scaled_by(scale.cwiseInverse(), seen_by(back, more.asDiagonal()));
}

/// The Schur complements of the rotation and of the translation.
void tell_weakest(Uncertainty& result) noexcept {
  const auto sigma = [](double information) {
    return information * Uncertainty::unheld_variance > 1.0 ? 1.0 / std::sqrt(information) : infinite_sigma;
  };
  const Matrix<3, 3>& all = result.information;
  const double turn = std::max(all(2, 2), 1e-12);
  const double xx = all(0, 0) - all(0, 2) * all(0, 2) / turn;
  const double xy = all(0, 1) - all(0, 2) * all(1, 2) / turn;
  const double yy = all(1, 1) - all(1, 2) * all(1, 2) / turn;
  const double middle = 0.5 * (xx + yy);
  const double half = std::hypot(0.5 * (xx - yy), xy);
  // The axis of the larger eigenvalue is at half the angle of (xx - yy, 2 xy); the weakest is square to it.
  const double strongest = 0.5 * std::atan2(2.0 * xy, xx - yy);
  result.weakest = {-std::sin(strongest), std::cos(strongest)};
  // What is left of a sum after cancellation is no information.
  const double least = middle - half;
  result.weakest_sigma = least > 1e-9 * middle ? sigma(least) : infinite_sigma;
  const double held = all(0, 0) * all(1, 1) - all(0, 1) * all(0, 1);
  const double by_shift =
      held > 1e-9 * all(0, 0) * all(1, 1)
          ? (all(0, 2) * (all(1, 1) * all(0, 2) - all(0, 1) * all(1, 2)) +
             all(1, 2) * (all(0, 0) * all(1, 2) - all(0, 1) * all(0, 2))) /
                held
          : all(0, 2) * all(0, 2) / std::max(all(0, 0), 1e-12) + all(1, 2) * all(1, 2) / std::max(all(1, 1), 1e-12);
  result.rotation_sigma = sigma(all(2, 2) - by_shift);
}

}  // namespace

void NoiseSums::pull(const Vector3d& pull) noexcept {
  constexpr int most = 16;
  group_ += pull;
  if (++in_group_ == most) close_group();
}

void NoiseSums::close_group() noexcept {
  const Matrix3d common = group_ * last_group_.transpose();
  together += square_of(group_) + 0.5 * (common + common.transpose());
  last_group_ = group_;
  group_.setZero();
  in_group_ = 0;
}

void add_noise(const NoiseModel& model, const Point2& in_robot, const Vector<2>& normal, const Vector<3>& jacobian,
               double residual, double weight, NoiseSums& sums) noexcept {
  const Vector<2> ray = in_robot - model.rays.origin;
  const double range2 = std::max(ray.squaredNorm(), 1e-6);
  const double off_wall = std::abs(normal.dot(ray));
  const double cosine2 = off_wall * off_wall / range2;
  const double shared = std::max(1.0, model.sharing() * off_wall / range2);
  const Matrix3d square = square_of(weight * jacobian);
  sums.by_range += cosine2 * square;
  sums.by_map += shared * square;
  sums.pull(weight * residual * jacobian);
  const double counted = weight * normal.squaredNorm();
  sums.weights += counted;
  sums.moment += counted * in_robot;
  sums.squared_ranges += counted * in_robot.squaredNorm();
  sums.squared_residuals += weight * residual * residual;
  sums.squared_cosines += weight * cosine2;
  sums.sharing += counted * counted * shared;
}

Assessment assess(const Matrix3d& information, const Vector3d& gradient, const NoiseSums& sums, const NoiseModel& model,
                  double reach) noexcept {
  const double turn_variance = model.line.turn_variance;
  const Held held = held_part(information, without_pretence(information, sums, turn_variance),
                              pretence_left(sums, turn_variance), reach);
  Assessment result;
  Uncertainty& told = result.uncertainty;
  told.known = true;
  told.blind = held.blind;
  result.blind = held.direction;
  // What a step can still take away is no noise.
  const double explained = gradient.dot(held.inverse * gradient);
  const double range2 = range_variance(sums, model, explained);
  told.range_noise = std::sqrt(range2);
  told.tilt_sigma = sums.weights > 0.0 ? std::sqrt(turn_variance * sums.sharing) / sums.weights : 0.0;
  told.twist_sigma = told.tilt_sigma / reach;
  const Matrix3d by_range = range2 * sums.by_range;
  const Matrix3d noise =
      with_misfit(by_range + model.offset_variance() * sums.by_map, sums.together, reach, told.misfit);
  const Matrix3d inverse_noise = safe_inverse(noise, reach);

  result.weighting = held.debiased * inverse_noise;
  result.weighted = seen_by(held.plain, inverse_noise);
  told.information = seen_by(held.debiased, inverse_noise);
  told.covariance = seen_by(held.inverse, noise);
  told.systematic = seen_by(held.inverse, noise - by_range);
  if (held.blind) {
    const Matrix3d nothing = Matrix3d::Identity() - held.inverse * held.debiased;
    told.unheld = seen_by(nothing, Uncertainty::unheld_variance * Matrix3d::Identity());
    told.covariance += told.unheld;
  }
  tell_weakest(told);
  return result;
}

void align_blind_direction(const Matrix3d& prior_information, double reach, Assessment& pairs) noexcept {
  if (!(pairs.blind.squaredNorm() > 0.5)) return;
  const Vector3d scale = by_reach(reach), unscale = scale.cwiseInverse();
  Eigen::SelfAdjointEigenSolver<Matrix3d> eigen;
  eigen.computeDirect(scaled_by(unscale, prior_information.inverse()));
  constexpr double by_far = 25.0;  // in variance
  constexpr double alike = 0.99;   // cosine
  const Vector3d direction = eigen.eigenvectors().col(2);
  if (!(eigen.eigenvalues()[2] > by_far * eigen.eigenvalues()[1])) return;
  if (!(std::abs(direction.dot(pairs.blind)) > alike)) return;
  const Matrix3d along = square_of(direction);
  const Matrix3d keep = (Matrix3d::Identity() - along).cwiseProduct(scale * unscale.transpose());
  const Matrix3d kept_by = keep.transpose();
  Uncertainty& told = pairs.uncertainty;
  pairs.weighting = kept_by * pairs.weighting;
  pairs.weighted = seen_by(kept_by, pairs.weighted);
  const Matrix3d held = told.covariance - told.unheld;
  told.information = seen_by(kept_by, told.information);
  told.systematic = seen_by(keep, told.systematic);
  told.unheld = Uncertainty::unheld_variance * scaled_by(scale, along);
  told.covariance = seen_by(keep, held) + told.unheld;
  tell_weakest(told);
}

Vector3d fused_motion(const Assessment& pairs, const Vector3d& gradient, const Matrix3d& prior_information,
                      const Vector3d& from_prior) noexcept {
  const Matrix3d all = pairs.weighted + prior_information;
  const Vector3d pull = pairs.weighting * gradient + prior_information * from_prior;
  return all.inverse() * pull;
}

}  // namespace slamicp
