// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// Reads a world for the simulator from a YAML file: walls, pillars, doors, obstacles, people and routes, and maybe a
/// `floor_plan`, the yaml of a map_server map, whose walls come before the file's own. Its path counts from the world's
/// folder. Doors cut their gaps into all walls, see with_door. docs/worlds.md tells every key.
///
/// Throws Error with file and line, what is wrong and how to mend it: for an unknown key, with the one that may have
/// been meant; for what is missing, absurd or twice there. A build without yaml-cpp reads none.
World load_world(const std::filesystem::path& path);

/// Writes a world so that load_world gives the same again: to the bit, but for angles, which stand there in degrees. A
/// floor plan is written as the walls that it has become. Throws Error, and writes nothing, for a world that would not
/// be read.
void save_world(const std::filesystem::path& path, const World& world);

}  // namespace slamicp
