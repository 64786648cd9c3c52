// SPDX-License-Identifier: Apache-2.0
#include "simulated_picture.hpp"

#include <slamicp/io/picture.hpp>

#include "output.hpp"

namespace slamicp::command {
namespace {

using Lines = std::vector<Picture::Segment>;

void add_box(Lines& lines, const Box& box) {
  for (const Segment& side : sides(box)) lines.push_back({side.a, side.b});
}

void draw_doors(Picture& picture, const std::vector<Door>& doors) {
  Lines standing, mapped;
  for (const Door& door : doors) {
    add_box(standing, leaf(door, door.opening));
    if (door.opening != door.mapped_opening) add_box(mapped, leaf(door, door.mapped_opening));
  }
  if (!mapped.empty()) picture.segments(mapped, colours::truth, 1.5, "doors as the map has them");
  if (!standing.empty()) picture.segments(standing, colours::robot, 1.8, "doors");
}

void draw_obstacles(Picture& picture, const std::vector<PlacedObstacle>& obstacles) {
  std::string legend = "what the map does not know";
  Lines lines;
  for (const PlacedObstacle& obstacle : obstacles) {
    for (const Box& box : obstacle.boxes) add_box(lines, box);
    for (const Cylinder& round : obstacle.cylinders) {
      picture.circle(round.centre, round.radius, colours::outlier, 1.8, legend);
      legend.clear();
    }
  }
  if (!lines.empty()) picture.segments(lines, colours::outlier, 1.8, legend);
}

void draw_people(Picture& picture, const std::vector<Person>& people, double stamp) {
  std::string legend = "people, and where they walk";
  for (const Person& person : people) {
    PointCloud2 way = person.way;
    if (person.is_loop) way.push_back(way.front());
    if (way.size() > 1) picture.polyline(way, {148, 62, 165, 0.45}, 1.2);
    const PersonOutline outline = outline_at(person, stamp);
    for (std::size_t k = 0; k < outline.count; ++k) {
      picture.circle(outline.centres[k], outline.radius, colours::obstacle, 1.8, legend);
      legend.clear();
    }
  }
}

}  // namespace

void save_simulated_picture(const std::string& file, const World& world, const SimulatedRun& run) {
  const StampedPose& half_way = run.truth[run.truth.size() / 2];
  Picture picture({.title = format("%s, %.1f s after the start", world.name.c_str(), half_way.stamp)});
  Lines walls;
  for (const Segment& wall : world.walls) walls.push_back({wall.a, wall.b});
  if (!walls.empty()) picture.segments(walls, colours::map, 1.5, "walls");
  for (const Circle& pillar : world.pillars) picture.circle(pillar.centre, pillar.radius, colours::map);
  draw_doors(picture, world.doors);
  picture.path(run.truth, colours::path, 1.5, "the robot's way");
  draw_obstacles(picture, world.obstacles);
  draw_people(picture, world.people, half_way.stamp);
  picture.robot(half_way.pose, 0.2);
  picture.save(file_named(file));
}

}  // namespace slamicp::command
