// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <slamicp/simulation/lidar.hpp>

#include "fuzz.hpp"
#include "io/world_yaml.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return slamicp::fuzz::run(data, size, [](std::string_view bytes) {
    slamicp::World world = slamicp::parse_world_yaml(bytes, "fuzz").world;
    // What was read can be written and read again, but for one that was nothing but its floor plan.
    const bool has_things = !world.walls.empty() || !world.pillars.empty();
    if (has_things &&
        slamicp::parse_world_yaml(slamicp::world_yaml(world), "again").world.walls.size() != world.walls.size())
      std::abort();
    for (const slamicp::Person& person : world.people)
      if (!person.problem().empty() || !slamicp::pose_at(person, 12.3).is_finite()) std::abort();
    const std::vector<slamicp::Door> doors = std::exchange(world.doors, {});
    for (const slamicp::Door& door : doors) world = slamicp::with_door(std::move(world), door);
    slamicp::LidarModel lidar = slamicp::real_hokuyo_utm30lx();
    lidar.beams = 60;
    lidar.angle_increment *= 18.0;
    std::vector<double> ranges;
    slamicp::true_ranges(world, {0.1, 0.2, 0.3}, {0.01, 0.0, 0.02}, lidar, ranges, 1.5);
    for (const double range : ranges)
      if (!(range >= 0.0)) std::abort();
  });
}
