// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/geometry/pose.hpp>

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

/// A way through a world, for a scripted drive.
struct Route {
  std::string name;
  std::vector<Point2> waypoints;  ///< passed in this order [m]
};

/// A flat world for a simulated lidar, in the map's frame. Walls and pillars are what a map of it holds; obstacles came
/// later.
struct World {
  std::string name;
  std::vector<Segment> walls;
  std::vector<Circle> pillars;
  std::vector<PlacedObstacle> obstacles;
  std::vector<Route> routes;
};

/// The same world with one more thing that the map does not know.
World with_obstacle(World world, PlacedObstacle obstacle);
World with_box(World world, const Box& box);
World with_cylinder(World world, const Cylinder& cylinder);

/// The route of that name; throws Error where the world has none.
const Route& route(const World& world, std::string_view name);

/// The four sides of a box, counter-clockwise.
std::array<Segment, 4> sides(const Box& box) noexcept;

/// How far a point is from a thing's surface [m]; 0 inside a box, a cylinder, a pillar.
double distance(const Segment& segment, const Point2& point) noexcept;
double distance(const Box& box, const Point2& point) noexcept;
double distance(const Cylinder& cylinder, const Point2& point) noexcept;
double distance(const PlacedObstacle& obstacle, const Point2& point) noexcept;

/// How far a point is from the nearest wall or pillar [m], obstacles left out. O(walls).
double distance_to_walls(const World& world, const Point2& point) noexcept;

}  // namespace slamicp
