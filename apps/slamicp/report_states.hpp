// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <slamicp/io/picture.hpp>

#include "report.hpp"

namespace slamicp::command {

/// The path, coloured by state; 95 % ellipses, magnified so that they are seen and thinned so that they do not overlap;
/// strokes along what the scans do not hold.
void draw_states(Picture& picture, const RunRecord& record);

/// What to show again, larger, where the path is small in its map.
std::optional<Bounds<2>> worth_a_closer_look(const RunRecord& record);

/// How many scans each state had, and how long it lasted.
std::string table_of_states(const RunRecord& record);

/// Probability and standard deviations over time, states as bands.
std::string charts_of_states(const RunRecord& record);

}  // namespace slamicp::command
