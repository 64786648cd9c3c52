// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/registration/icp_options.hpp>
#include <slamicp/registration/uncertainty.hpp>

namespace slamicp {

/// Where the solver's gate starts [m]: as far off as the guess may well be.
double first_gate(const IcpOptions& options, const PosePrior& prior) noexcept;

/// Squared distance between a pose that its pairs have found and what the prior says, in their common noise.
double surprise(const Uncertainty& match, const PosePrior& prior, const Pose2& pose) noexcept;

/// Pairs that contradict the prior and each other as well, or are but a part of the scan: they are the ones to doubt,
/// the more they contradict: their influence falls off with the cube of how far off they are.
/// @param share  of the scan's points that have a pair
/// @returns      true if the pairs were doubted
bool doubt_contradiction(double share, Uncertainty& match) noexcept;

/// How the prior moves a pose that its pairs have found.
Pose2::Tangent motion_by_prior(const Uncertainty& match, const PosePrior& prior, const Pose2& pose) noexcept;

}  // namespace slamicp
