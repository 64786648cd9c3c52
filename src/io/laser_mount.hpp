// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <slamicp/scan/laser_mount.hpp>

#include "io/frame_tree.hpp"

namespace slamicp {

/// By tf; the identity, with a warning, where tf does not say. Warns where the laser moves on the robot, or is tilted.
LaserMount laser_mount(const FrameTree& frames, const std::string& base, const std::string& laser,
                       std::vector<std::string>& warnings);

}  // namespace slamicp
