// SPDX-License-Identifier: Apache-2.0
#include "layout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace slamicp::bench {
namespace {

double length_of_walls(const World& world) {
  double length = 0.0;
  for (const Segment& wall : world.walls) length += (wall.b - wall.a).norm();
  for (const Circle& pillar : world.pillars) length += 2.0 * std::numbers::pi * pillar.radius;
  return length;
}

void scale(Layout& layout, double factor) {
  for (Segment& wall : layout.world.walls) wall = {factor * wall.a, factor * wall.b};
  for (Circle& pillar : layout.world.pillars) pillar = {factor * pillar.centre, factor * pillar.radius};
  layout.interior = {factor * layout.interior.lower, factor * layout.interior.upper};
}

void add_box(World& world, const Box& box) {
  for (const Segment& side : sides(box)) world.walls.push_back(side);
}

void add_outline(World& world, const Point2& lower, const Point2& upper) {
  const Point2 size = upper - lower;
  add_box(world, {lower + 0.5 * size, size.x(), size.y(), 0.0});
}

/// A wall along x at height y; what steps out of it does so towards `outward` (+1 or -1).
void add_corridor_side(World& world, double length, double y, double outward, Random& random) {
  struct Step {
    double width, depth;
  };
  constexpr Step door{0.9, 0.08}, pilaster{0.4, -0.2}, alcove{1.6, 0.8};
  PointCloud2 corners = {{0.0, y}};
  double x = random.uniform(0.5, 2.5);
  while (x + alcove.width < length) {
    const double draw = random.uniform();
    const Step step = draw < 0.5 ? door : draw < 0.8 ? pilaster : alcove;
    for (const auto& [at, depth] :
         {std::pair{x, 0.0}, {x, step.depth}, {x + step.width, step.depth}, {x + step.width, 0.0}})
      corners.emplace_back(at, y + outward * depth);
    x += step.width + random.uniform(0.5, 4.0);
  }
  corners.emplace_back(length, y);
  for (std::size_t k = 1; k < corners.size(); ++k) world.walls.push_back({corners[k - 1], corners[k]});
}

Layout corridor(double wall_length, Random& random) {
  constexpr double width = 2.5, wall_per_metre = 2.3;
  const double length = std::max(3.0, (wall_length - 2.0 * width) / wall_per_metre);
  Layout layout{{}, {{0.0, 0.0}, {length, width}}};
  add_corridor_side(layout.world, length, 0.0, -1.0, random);
  add_corridor_side(layout.world, length, width, 1.0, random);
  layout.world.walls.push_back({{0.0, 0.0}, {0.0, width}});
  layout.world.walls.push_back({{length, 0.0}, {length, width}});
  return layout;
}

/// A wall with an open door somewhere in it.
void add_wall_with_door(World& world, const Point2& a, const Point2& b, Random& random) {
  constexpr double door = 0.9, margin = 0.3;
  const double length = (b - a).norm();
  const Point2 along = (b - a) / length;
  const double from = random.uniform(margin, length - door - margin);
  world.walls.push_back({a, a + from * along});
  world.walls.push_back({a + (from + door) * along, b});
}

/// Cupboards, tables, at times a pillar.
void furnish(World& world, const Point2& lower, const Point2& upper, Random& random) {
  const auto place = [&](double margin) {
    return Point2(random.uniform(lower.x() + margin, upper.x() - margin),
                  random.uniform(lower.y() + margin, upper.y() - margin));
  };
  for (int k = 0; k < 2; ++k)
    add_box(world, {place(0.8), random.uniform(0.5, 1.3), random.uniform(0.3, 0.6), random.uniform(0.0, 3.0)});
  if (random.uniform() < 0.25) world.pillars.push_back({place(0.6), random.uniform(0.1, 0.25)});
}

Layout office(double wall_length, Random& random) {
  constexpr double width = 5.0, depth = 4.0, walls_of_room = 12.0;
  const double rooms = std::max(1.0, wall_length / walls_of_room);
  const auto columns = static_cast<int>(std::ceil(std::sqrt(rooms)));
  const auto rows = std::max(1, static_cast<int>(std::round(rooms / columns)));
  const Point2 size(columns * width, rows * depth);
  Layout layout{{}, {Point2::Zero(), size}};
  add_outline(layout.world, Point2::Zero(), size);
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row) {
      const Point2 corner(column * width, row * depth);
      const Point2 right = corner + Point2(width, 0.0), upper = corner + Point2(0.0, depth);
      if (row > 0) add_wall_with_door(layout.world, corner, right, random);
      if (column > 0) add_wall_with_door(layout.world, corner, upper, random);
      if (columns * rows > 1) furnish(layout.world, corner, corner + Point2(width, depth), random);
    }
  return layout;
}

Layout hall(double wall_length, Random& random) {
  // Length of wall = 5 s + 0.25 s^2 for a hall of 1.5 s x s: the outline, and what stands in a raster of 5 m.
  constexpr double raster = 5.0;
  const double side = std::max(6.0, 2.0 * (std::sqrt(25.0 + wall_length) - 5.0));
  const Point2 size(1.5 * side, side);
  Layout layout{{}, {Point2::Zero(), size}};
  add_outline(layout.world, Point2::Zero(), size);
  for (double x = 0.5 * raster; x < size.x() - 2.0; x += raster)
    for (double y = 0.5 * raster; y < size.y() - 2.0; y += raster) {
      const Point2 at(x + random.uniform(-1.0, 1.0), y + random.uniform(-1.0, 1.0));
      if (random.uniform() < 0.6)
        layout.world.pillars.push_back({at, random.uniform(0.2, 0.4)});
      else
        add_box(layout.world, {at, random.uniform(1.5, 3.5), 0.6, random.uniform(0.0, 3.0)});
    }
  return layout;
}

}  // namespace

const char* to_string(LayoutKind kind) {
  switch (kind) {
    case LayoutKind::corridor:
      return "corridor";
    case LayoutKind::office:
      return "office";
    case LayoutKind::hall:
      return "hall";
  }
  return "unknown";
}

Layout make_layout(LayoutKind kind, double wall_length, Random& random) {
  if (!(wall_length >= 1.0)) throw std::invalid_argument("a building needs at least 1 m of wall");
  Layout layout = kind == LayoutKind::corridor ? corridor(wall_length, random)
                  : kind == LayoutKind::office ? office(wall_length, random)
                                               : hall(wall_length, random);
  scale(layout, wall_length / length_of_walls(layout.world));
  return layout;
}

}  // namespace slamicp::bench
