// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <slamicp/obstacles/map_changes.hpp>

#include "report.hpp"

namespace slamicp::command {

/// The proposals as a list with their evidence, FILE, and drawn over the map beside it, .svg.
void write_proposals(const std::string& file, const RunRecord& record, std::span<const ProposedChange> proposals);

}  // namespace slamicp::command
