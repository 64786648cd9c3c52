// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// What the yaml of a world says, before its floor plan is read and its doors have cut their gaps.
struct WorldYaml {
  World world;
  std::filesystem::path floor_plan;  ///< as it stands there; empty: none
  std::string floor_plan_where;      ///< file and line
};

/// Reads it from memory. Throws Error with file and line.
/// @param name  of the file, for messages
WorldYaml parse_world_yaml(std::string_view text, const std::string& name);

/// The world as load_world reads it back.
std::string world_yaml(const World& world);

/// True for the text of a world, right or wrong: a line begins with the key `world`.
bool is_world_yaml(std::string_view text) noexcept;

}  // namespace slamicp
