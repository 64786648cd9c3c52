// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/simulation/person.hpp>

namespace slamicp {

/// A straight piece of wall, seen from both sides.
struct Segment {
  Point2 a = Point2::Zero();  ///< [m]
  Point2 b = Point2::Zero();  ///< [m]
};

/// A round pillar.
struct Circle {
  Point2 centre = Point2::Zero();  ///< [m]
  double radius = 0.0;             ///< [m]
};

/// A rectangular thing.
struct Box {
  Point2 centre = Point2::Zero();  ///< [m]
  double width = 0.0;              ///< along the heading [m]
  double depth = 0.0;              ///< across the heading [m]
  double heading = 0.0;            ///< of the width [rad]
};

/// A round thing.
struct Cylinder {
  Point2 centre = Point2::Zero();  ///< [m]
  double radius = 0.0;             ///< [m]
};

/// Something that stands in the world and that the map does not know: boxes and cylinders set down together.
struct PlacedObstacle {
  std::string name;
  std::vector<Box> boxes;
  std::vector<Cylinder> cylinders;
};

/// A door in a gap of the walls: a leaf that turns about its hinge. It may stand otherwise than the map has it.
/// An opening is what the leaf has turned counter-clockwise, from 0, closed; [-pi, pi] [rad].
struct Door {
  std::string name;
  Point2 hinge = Point2::Zero();  ///< [m]
  Point2 latch = Point2::Zero();  ///< the leaf's free end while it is closed [m]
  double opening = 0.0;           ///< now
  double mapped_opening = 0.0;    ///< when the map was made
  double thickness = 0.04;        ///< of the leaf [m], > 0
};

/// A way through a world, for a scripted drive.
struct Route {
  std::string name;
  std::vector<Point2> waypoints;  ///< passed in this order [m]
};

/// A flat world for a simulated lidar, in the map's frame. Walls, pillars and doors are what a map of it holds;
/// obstacles came later, people come and go.
struct World {
  std::string name;
  std::vector<Segment> walls;
  std::vector<Circle> pillars;
  std::vector<PlacedObstacle> obstacles;
  std::vector<Route> routes;
  std::vector<Door> doors;
  std::vector<Person> people;
};

/// The same world with one more thing that the map does not know.
World with_obstacle(World world, PlacedObstacle obstacle);
World with_box(World world, const Box& box);
World with_cylinder(World world, const Cylinder& cylinder);

/// What of the walls lies so near to the line from hinge to latch makes way for a door, to both sides [m].
inline constexpr double door_gap_depth = 0.15;

/// The same world with one more door, and a gap in the walls for it: both faces of a wall with two, which are joined
/// beside the gap.
World with_door(World world, Door door);

/// The route of that name; throws Error where the world has none.
const Route& route(const World& world, std::string_view name);

/// A door's leaf as it stands with that opening [rad].
Box leaf(const Door& door, double opening) noexcept;

/// The four sides of a box, counter-clockwise.
std::array<Segment, 4> sides(const Box& box) noexcept;

/// How far a point is from a thing's surface [m]; 0 inside a box, a cylinder, a pillar.
double distance(const Segment& segment, const Point2& point) noexcept;
double distance(const Box& box, const Point2& point) noexcept;
double distance(const Cylinder& cylinder, const Point2& point) noexcept;
double distance(const PlacedObstacle& obstacle, const Point2& point) noexcept;

/// How far a point is from the nearest wall, pillar or door as the map has them [m], obstacles and people left out.
/// O(walls).
double distance_to_walls(const World& world, const Point2& point) noexcept;

}  // namespace slamicp
