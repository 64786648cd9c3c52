// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "io/recording.hpp"

namespace slamicp {

/// A rosbag2 `.db3` file: its messages by their stamps. Throws Error where nothing can be had of it, and in a build
/// without SQLite.
void read_rosbag2_database(const std::filesystem::path& path, RecordingVisitor& visitor);
/// The same of its content.
void read_rosbag2_database(std::string bytes, const std::string& name, RecordingVisitor& visitor);

}  // namespace slamicp
