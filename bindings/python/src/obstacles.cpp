// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/obstacles/reconstruction.hpp>

#include "arrays.hpp"
#include "module.hpp"

namespace slamicp::python {
namespace {

Array2 corners(const Obstacle& obstacle) {
  const OrientedBox& box = obstacle.box;
  const Pose2 T_map_box{box.centre.x(), box.centre.y(), box.heading};
  PointCloud2 points;
  for (const auto& [along, across] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}})
    points.push_back(T_map_box * Point2(0.5 * along * box.width, 0.5 * across * box.depth));
  return copy_points<2>(points);
}

void bind_shape(nb::module_& m) {
  nb::class_<Shape>(m, "Shape",
                    "What an obstacle looks like. Sizes are of what was seen: where an end was not, it may be larger.")
      .def_prop_ro(
          "kind", [](const Shape& shape) { return std::string(to_string(shape.kind)); },
          "'line', 'circle', 'box' or 'unknown'.")
      .def_prop_ro(
          "centre", [](const Shape& shape) { return copy_numbers(shape.centre.data(), 2); },
          "Of the circle or box, or the middle of the line's seen part, (2,) in the map [m].", nb::rv_policy::automatic)
      .def_ro("width", &Shape::width, "The longer side, a circle's diameter [m].")
      .def_ro("width_sigma", &Shape::width_sigma, "Its standard deviation [m].")
      .def_ro("depth", &Shape::depth, "The shorter side, 0 for a line [m].")
      .def_ro("depth_sigma", &Shape::depth_sigma, "Its standard deviation [m].")
      .def_ro("radius", &Shape::radius, "Of a circle, else 0 [m].")
      .def_ro("radius_sigma", &Shape::radius_sigma, "Its standard deviation [m].")
      .def_ro("heading", &Shape::heading, "Of the longer side, in (-pi/2, pi/2] [rad].")
      .def_ro("width_seen", &Shape::width_seen, "True where both ends of the longer side were seen.")
      .def_ro("depth_seen", &Shape::depth_seen, "True where both ends of the shorter side were seen.")
      .def("brief", &Shape::brief, "One line: kind and size.")
      .def("__repr__", [](const Shape& shape) { return "<slamicp.Shape: " + shape.brief() + ">"; });
}

}  // namespace

void bind_obstacles(nb::module_& m) {
  using namespace nb::literals;
  bind_shape(m);
  nb::class_<Obstacle>(m, "Obstacle", "Something that stands where the map has nothing.")
      .def_prop_ro(
          "centre", [](const Obstacle& obstacle) { return copy_numbers(obstacle.box.centre.data(), 2); },
          "Of the smallest box around what was seen of it, (2,) in the map [m].", nb::rv_policy::automatic)
      .def_prop_ro(
          "width", [](const Obstacle& obstacle) { return obstacle.box.width; }, "The box's longer side [m].")
      .def_prop_ro(
          "depth", [](const Obstacle& obstacle) { return obstacle.box.depth; }, "The box's shorter side [m].")
      .def_prop_ro(
          "heading", [](const Obstacle& obstacle) { return obstacle.box.heading; },
          "Of the longer side, in (-pi/2, pi/2] [rad].")
      .def_prop_ro("corners", corners, "Of the box, (4, 2) in the map [m], counter-clockwise.",
                   nb::rv_policy::automatic)
      .def_ro("distance", &Obstacle::distance, "From the laser to its nearest seen point [m].")
      .def_prop_ro(
          "points", [](nb::handle self) { return view_indices(nb::cast<const Obstacle&>(self).points, self); },
          "Its points, as rows of the fix's `points` (or of the cloud it was found in). A read-only view.")
      .def_prop_ro(
          "nearest", [](const Obstacle& obstacle) { return copy_numbers(obstacle.nearest.data(), 2); },
          "Its nearest seen point, (2,) in the map [m].", nb::rv_policy::automatic)
      .def_prop_ro(
          "ray_class", [](const Obstacle& obstacle) { return std::string(to_string(obstacle.ray_class)); },
          "What most of its rays say: 'obstacle', 'gone', 'unmapped' or 'unknown'.")
      .def_ro("shape", &Obstacle::shape, "What it looks like, by its points.")
      .def("brief", &Obstacle::brief, "One line: size, place, number of points.")
      .def("__repr__", [](const Obstacle& obstacle) { return "<slamicp.Obstacle: " + obstacle.brief() + ">"; });

  m.def(
      "find_obstacles",
      [](const Fix& fix, const LaserScan& scan, int min_points, int min_far_points, double range_noise,
         double min_incidence_deg) {
        ObstacleOptions options;
        options.min_points = min_points;
        options.min_far_points = min_far_points;
        options.range_noise = range_noise;
        options.min_incidence_deg = min_incidence_deg;
        return find_obstacles(fix, scan, checked(options));
      },
      "fix"_a, "scan"_a, nb::kw_only(), "min_points"_a = 3, "min_far_points"_a = 2, "range_noise"_a = 0.01,
      "min_incidence_deg"_a = 10.0, nb::call_guard<nb::gil_scoped_release>(),
      "Groups what of a fix the map does not have into obstacles, nearest first. scan: the one that the fix is of.\n"
      "min_points: fewer make no obstacle. min_far_points: of which so many are at least the localizer's\n"
      "obstacle_distance off the map. range_noise: 1 sigma [m]. min_incidence_deg: the flattest incidence at "
      "which\n"
      "a surface still holds together [deg].");
  m.def(
      "reconstruct_obstacles",
      [](nb::handle outliers, double gap, int min_points, double filter_radius, int filter_neighbours, double trim) {
        const PointArray points(outliers, "outliers");
        ReconstructionOptions options;
        options.gap = gap;
        options.min_points = min_points;
        options.filter_radius = filter_radius;
        options.filter_neighbours = filter_neighbours;
        options.trim = trim;
        checked(options);
        const nb::gil_scoped_release others_may_run;
        return reconstruct_obstacles(to_cloud<2>(points.view<2>()), options);
      },
      "outliers"_a, nb::kw_only(), "gap"_a = 0.15, "min_points"_a = 20, "filter_radius"_a = 0.03,
      "filter_neighbours"_a = 3, "trim"_a = 0.01,
      nb::sig(
          "def reconstruct_obstacles(outliers: numpy.typing.NDArray[numpy.float64], *, gap: float = 0.15, min_points: "
          "int = 20, filter_radius: float = 0.03, filter_neighbours: int = 3, trim: float = 0.01) -> list[Obstacle]"),
      "The obstacles that a run's outliers add up to (the paper, Figure 16), largest first. outliers: of many scans, "
      "(K, 2)\nin the map's frame [m].");
}

}  // namespace slamicp::python
