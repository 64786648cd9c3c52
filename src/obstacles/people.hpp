// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "obstacles/followed.hpp"

namespace slamicp {

/// Two legs that stay together while they move are somebody: one track of both. Joins two at most; the others come the
/// next time.
/// @param stamp  of the scan that the tracks were seen in [s]
void find_people(std::vector<Followed>& followed, double stamp) noexcept;

}  // namespace slamicp
