// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/geometry/trajectory.hpp>

namespace slamicp {

/// Reads a `.relations` file of the SLAM benchmark of Kuemmerle et al. 2009: `t1 t2 x y z roll pitch yaw` a line
/// (s, m, rad), the pose at t2 as seen from that at t1. z, roll and pitch are left out. Throws Error with file and
/// line.
std::vector<Relation> load_relations(const std::filesystem::path& path);

/// The same from memory. @param name  the file's name, for messages
std::vector<Relation> parse_relations(std::string_view text, const std::string& name);

}  // namespace slamicp
