// SPDX-License-Identifier: Apache-2.0
#include "registration/prior_fusion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace slamicp {
namespace {

/// How far off the position may well be by what is known of it [m]; 0 where nothing is.
double three_sigma(const PosePrior& prior) noexcept {
  if (!prior.given()) return 0.0;
  const Eigen::Matrix3d covariance = Eigen::Matrix3d(prior.information).inverse();
  const double most = covariance.topLeftCorner<2, 2>().trace();
  return std::isfinite(most) ? 3.0 * std::sqrt(std::max(most, 0.0)) : 0.0;
}

}  // namespace

double first_gate(const IcpOptions& options, const PosePrior& prior) noexcept {
  constexpr double widest = 1.0;  // [m]; nearest points farther off say nothing
  if (prior.first_gate > 0.0) return prior.first_gate;
  return std::max(options.max_correspondence_distance, std::min(three_sigma(prior), widest));
}

double surprise(const Uncertainty& match, const PosePrior& prior, const Pose2& pose) noexcept {
  const Eigen::Matrix3d common =
      Eigen::Matrix3d(match.covariance) + Eigen::Matrix3d(Eigen::Matrix3d(prior.information).inverse());
  const Eigen::Vector3d off = (pose.inverse() * prior.mean).log();
  const double squared = off.dot(common.inverse() * off);
  return std::isfinite(squared) ? std::max(squared, 0.0) : 0.0;
}

bool doubt_contradiction(double share, Uncertainty& match) noexcept {
  constexpr double most = 0.5;
  if (!(match.surprise > Uncertainty::credible) || (!match.contradicts_itself() && share > most)) return false;
  // Squared: else each scan would pull the pose a little further, whole metres in the end.
  const double excess = match.surprise / Uncertainty::credible;
  const double trust = 1.0 / (excess * excess);
  match.information *= trust;
  match.covariance /= trust;
  match.systematic /= trust;
  match.surprise = Uncertainty::credible;
  return true;
}

Pose2::Tangent motion_by_prior(const Uncertainty& match, const PosePrior& prior, const Pose2& pose) noexcept {
  const Eigen::Matrix3d by_prior = match.trust_in_prior() * prior.information;
  const Eigen::Matrix3d all = Eigen::Matrix3d(match.information) + by_prior;
  return all.inverse() * (by_prior * (pose.inverse() * prior.mean).log());
}

}  // namespace slamicp
