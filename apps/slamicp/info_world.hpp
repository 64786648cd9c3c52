// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace slamicp::command {

/// slamicp info of a world for the simulator.
void tell_world(const std::string& file, const std::string& json);

}  // namespace slamicp::command
