// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <slamicp/simulation/drive.hpp>

namespace slamicp::command {

/// A world as it stands, the robot's way through it, and people where they are half way.
void save_simulated_picture(const std::string& file, const World& world, const SimulatedRun& run);

}  // namespace slamicp::command
