// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/recording.hpp"

namespace slamicp {

/// The files of a rosbag2 folder in the order of its metadata.yaml; where there is none to be read, in that of their
/// numbers, and a warning. Throws Error if there are none.
std::vector<std::filesystem::path> rosbag2_files(const std::filesystem::path& folder, RecordingVisitor& visitor);

/// What a file holds by its name, ".db3" or ".mcap", be it packed (.zstd) or not; empty where it is neither.
std::string rosbag2_ending(const std::filesystem::path& file);
bool is_packed_rosbag2(const std::filesystem::path& file);

/// True for a folder with metadata.yaml or with such files, and for what ros2 bag has packed, by its name.
bool is_rosbag2(const std::filesystem::path& path);

}  // namespace slamicp
