// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <slamicp/geometry/trajectory.hpp>

namespace slamicp {

/// Reads a trajectory in TUM format, `stamp x y z qx qy qz qw` a line (s, m, unit quaternion), blank or comma between,
/// '#' for comments. Poses are taken as they stand in the plane: x, y and the heading.
/// Throws Error with file and line.
Trajectory load_trajectory(const std::filesystem::path& path);

/// The same from memory. @param name  the file's name, for messages
Trajectory parse_trajectory(std::string_view text, const std::string& name);

/// Writes TUM format: stamps to the microsecond, positions to 1e-6 m, headings to 1e-8 rad. Read by evo.
/// Throws Error for a pose that is not finite.
void save_trajectory(const std::filesystem::path& path, std::span<const StampedPose> trajectory);

std::string trajectory_text(std::span<const StampedPose> trajectory);

}  // namespace slamicp
