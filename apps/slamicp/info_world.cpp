// SPDX-License-Identifier: Apache-2.0
#include "info_world.hpp"

#include <cmath>

#include <slamicp/geometry/angle.hpp>
#include <slamicp/io/world_file.hpp>
#include <slamicp/navigation/spline_path.hpp>

#include "output.hpp"

namespace slamicp::command {
namespace {

/// "open 90 deg", "closed"
std::string opening_told(double opening) {
  return opening == 0.0 ? "closed" : format("open %.0f deg", std::abs(opening) * deg_per_rad);
}

Json tell_doors(const std::vector<Door>& doors, const Talk& talk) {
  Json told = Json::array();
  for (const Door& door : doors) {
    const bool has_moved = door.opening != door.mapped_opening;
    talk(format("  door                   %s, %.2f m wide, %s%s", door.name.c_str(), (door.latch - door.hinge).norm(),
                opening_told(door.opening).c_str(),
                has_moved ? (", in the map " + opening_told(door.mapped_opening)).c_str() : ""));
    told.push_back({{"name", door.name},
                    {"open_deg", door.opening * deg_per_rad},
                    {"mapped_open_deg", door.mapped_opening * deg_per_rad}});
  }
  return told;
}

Json tell_routes(const std::vector<Route>& routes, const Talk& talk) {
  Json told = Json::array();
  for (const Route& route : routes) {
    const double length = SplinePath(route.waypoints).length();
    talk(format("  route                  %s, %zu waypoints, %.1f m", route.name.c_str(), route.waypoints.size(),
                length));
    told.push_back({{"name", route.name}, {"waypoints", route.waypoints.size()}, {"length", length}});
  }
  return told;
}

/// Of what the map holds.
Bounds<2> bounds_of(const World& world) {
  Bounds<2> bounds;
  const auto include_line = [&](const Segment& line) {
    bounds.include(line.a);
    bounds.include(line.b);
  };
  for (const Segment& wall : world.walls) include_line(wall);
  for (const Circle& pillar : world.pillars) {
    bounds.include(pillar.centre - Point2::Constant(pillar.radius));
    bounds.include(pillar.centre + Point2::Constant(pillar.radius));
  }
  for (const Door& door : world.doors)
    for (const Segment& side : sides(leaf(door, door.mapped_opening))) include_line(side);
  return bounds;
}

}  // namespace

void tell_world(const std::string& file, const std::string& json) {
  const World world = load_world(file_named(file));
  const Talk talk(json);
  double length = 0.0;
  for (const Segment& wall : world.walls) length += (wall.b - wall.a).norm();
  std::size_t walking = 0;
  for (const Person& person : world.people) walking += person.way.size() > 1;
  talk(format("%s: the world '%s' for the simulator", file.c_str(), world.name.c_str()));
  talk(format("  walls                  %zu, together %.1f m; %zu pillars", world.walls.size(), length,
              world.pillars.size()));
  const Bounds<2> bounds = bounds_of(world);
  Json summary{{"verb", "info"},
               {"file", file},
               {"kind", "world"},
               {"world", world.name},
               {"walls", world.walls.size()},
               {"wall_length", length},
               {"pillars", world.pillars.size()}};
  if (!bounds.empty()) {
    for (int axis = 0; axis < 2; ++axis)
      talk(format("  %c                      %.3f m to %.3f m", "xy"[axis], bounds.lower[axis], bounds.upper[axis]));
    summary["lower"] = {bounds.lower.x(), bounds.lower.y()};
    summary["upper"] = {bounds.upper.x(), bounds.upper.y()};
  }
  summary["doors"] = tell_doors(world.doors, talk);
  talk(format("  not in the map         %zu obstacles; %zu people who walk, %zu who stand", world.obstacles.size(),
              walking, world.people.size() - walking));
  summary["obstacles"] = world.obstacles.size();
  summary["people"] = world.people.size();
  summary["people_walking"] = walking;
  summary["routes"] = tell_routes(world.routes, talk);
  write_json(json, summary);
}

}  // namespace slamicp::command
