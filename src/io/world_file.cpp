// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/io/occupancy_map_file.hpp>
#include <slamicp/io/output_file.hpp>
#include <slamicp/io/world_file.hpp>
#include <slamicp/simulation/floor_plan.hpp>

#include "io/text.hpp"
#include "io/world_yaml.hpp"

namespace slamicp {
namespace {

World with_plan_of(World world, const WorldYaml& yaml, const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / yaml.floor_plan;  // or itself alone, where it is absolute
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw Error("its floor plan " + text::name_of(yaml.floor_plan) + " is not there", yaml.floor_plan_where,
                "name the yaml of a map_server map; its path counts from the world's folder");
  const OccupancyGrid grid = load_occupancy_map(path).grid;
  if (count_cells(grid).occupied == 0)
    throw Error("its floor plan " + text::name_of(yaml.floor_plan) + " has no walls", yaml.floor_plan_where,
                "no cell of it is occupied: see its thresholds");
  return with_floor_plan(std::move(world), grid);
}

}  // namespace

World load_world(const std::filesystem::path& path) {
  WorldYaml yaml = parse_world_yaml(text::read_file(path), text::name_of(path));
  World& read = yaml.world;
  World world;
  if (!yaml.floor_plan.empty()) world = with_plan_of(std::move(world), yaml, path.parent_path());
  world.name = read.name;
  world.walls.insert(world.walls.end(), read.walls.begin(), read.walls.end());
  world.pillars.insert(world.pillars.end(), read.pillars.begin(), read.pillars.end());
  world.obstacles = std::move(read.obstacles);
  world.routes = std::move(read.routes);
  world.people = std::move(read.people);
  for (Door& door : read.doors) world = with_door(std::move(world), std::move(door));
  return world;
}

void save_world(const std::filesystem::path& path, const World& world) {
  const std::string yaml = world_yaml(world);
#ifdef SLAMICP_WITH_YAML
  parse_world_yaml(yaml, text::name_of(path));
#endif
  write_file(path, yaml);
}

}  // namespace slamicp
