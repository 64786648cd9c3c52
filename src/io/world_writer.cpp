// SPDX-License-Identifier: Apache-2.0
#include <slamicp/geometry/angle.hpp>

#include "io/text.hpp"
#include "io/world_yaml.hpp"

namespace slamicp {
namespace {

std::string exact_number(double number) {
  std::string text;
  text::append_exact(text, number);
  return text;
}

std::string in_degrees(double angle) { return exact_number(angle * deg_per_rad); }

std::string in_quotes(const std::string& name) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = "\"";
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || byte == 0x7F)
      text.append("\\x").append(1, digits[byte >> 4U]).append(1, digits[byte & 15U]);
    else if (c == '"' || c == '\\')
      text.append(1, '\\').append(1, c);
    else
      text += c;
  }
  return text + '"';
}

std::string point_yaml(const Point2& point) {
  return '[' + exact_number(point.x()) + ", " + exact_number(point.y()) + ']';
}

std::string points_yaml(const PointCloud2& points) {
  std::string text;
  for (const Point2& point : points) text.append(text.empty() ? "[" : ", ").append(point_yaml(point));
  return text.empty() ? "[]" : text + ']';
}

std::string box_yaml(const Box& box) {
  return "{centre: " + point_yaml(box.centre) + ", width: " + exact_number(box.width) +
         ", depth: " + exact_number(box.depth) +
         (box.heading == 0.0 ? "" : ", heading_deg: " + in_degrees(box.heading)) + '}';
}

std::string round_yaml(const Point2& centre, double radius) {
  return "{centre: " + point_yaml(centre) + ", radius: " + exact_number(radius) + '}';
}

/// Walls that follow upon each other are one polyline.
std::string walls_yaml(const std::vector<Segment>& walls) {
  std::string text;
  for (std::size_t k = 0; k < walls.size();) {
    PointCloud2 corners = {walls[k].a, walls[k].b};
    for (++k; k < walls.size() && walls[k].a == corners.back(); ++k) corners.push_back(walls[k].b);
    text += "  - polyline: " + points_yaml(corners) + '\n';
  }
  return text;
}

std::string door_yaml(const Door& door) {
  return "  - name: " + in_quotes(door.name) + "\n    hinge: " + point_yaml(door.hinge) +
         "\n    latch: " + point_yaml(door.latch) + "\n    open_deg: " + in_degrees(door.opening) +
         "\n    mapped_open_deg: " + in_degrees(door.mapped_opening) +
         "\n    thickness: " + exact_number(door.thickness) + '\n';
}

std::string obstacle_yaml(const PlacedObstacle& obstacle) {
  std::string text = "  - name: " + in_quotes(obstacle.name) + '\n';
  if (!obstacle.boxes.empty()) text += "    boxes:\n";
  for (const Box& box : obstacle.boxes) text += "      - " + box_yaml(box) + '\n';
  if (!obstacle.cylinders.empty()) text += "    cylinders:\n";
  for (const Cylinder& cylinder : obstacle.cylinders)
    text += "      - " + round_yaml(cylinder.centre, cylinder.radius) + '\n';
  return text;
}

std::string person_yaml(const Person& person) {
  const Person usual;
  std::string text = "  - name: " + in_quotes(person.name) + "\n    way: " + points_yaml(person.way) + '\n';
  const auto add = [&](const char* key, double number, double otherwise) {
    if (number != otherwise) text += std::string("    ") + key + ": " + exact_number(number) + '\n';
  };
  if (person.is_loop) text += "    loop: true\n";
  add("speed", person.speed, usual.speed);
  add("start", person.start, usual.start);
  add("pause", person.pause, usual.pause);
  add("heading_deg", person.heading * deg_per_rad, usual.heading);
  if (person.shape == PersonShape::body) text += "    seen_as: body\n";
  add("leg_radius", person.leg_radius, usual.leg_radius);
  add("leg_distance", person.leg_distance, usual.leg_distance);
  add("step_length", person.step_length, usual.step_length);
  add("body_radius", person.body_radius, usual.body_radius);
  return text;
}

std::string route_yaml(const Route& route) {
  return "  - name: " + in_quotes(route.name) + "\n    waypoints: " + points_yaml(route.waypoints) + '\n';
}

template <class Things, class Write>
void add_list(std::string& text, const char* key, const Things& things, Write write) {
  if (things.empty()) return;
  text += std::string(key) + ":\n";
  for (const auto& thing : things) text += write(thing);
}

}  // namespace

std::string world_yaml(const World& world) {
  std::string text = "world: " + in_quotes(world.name) + '\n';
  if (!world.walls.empty()) text += "walls:\n" + walls_yaml(world.walls);
  add_list(text, "pillars", world.pillars,
           [](const Circle& pillar) { return "  - " + round_yaml(pillar.centre, pillar.radius) + '\n'; });
  add_list(text, "doors", world.doors, door_yaml);
  add_list(text, "obstacles", world.obstacles, obstacle_yaml);
  add_list(text, "people", world.people, person_yaml);
  add_list(text, "routes", world.routes, route_yaml);
  return text;
}

bool is_world_yaml(std::string_view text) noexcept {
  while (!text.empty()) {
    if (text.starts_with("world:")) return true;
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return false;
    text.remove_prefix(end + 1);
  }
  return false;
}

}  // namespace slamicp
