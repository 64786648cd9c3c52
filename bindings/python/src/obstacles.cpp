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

}  // namespace

void bind_obstacles(nb::module_& m) {
  using namespace nb::literals;
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
      .def("brief", &Obstacle::brief, "One line: size, place, number of points.")
      .def("__repr__", [](const Obstacle& obstacle) { return "<slamicp.Obstacle: " + obstacle.brief() + ">"; });

  m.def(
      "find_obstacles",
      [](const Fix& fix, const LaserScan& scan, int min_points, double range_noise, double min_incidence_deg) {
        return find_obstacles(fix, scan, checked(ObstacleOptions{min_points, range_noise, min_incidence_deg}));
      },
      "fix"_a, "scan"_a, nb::kw_only(), "min_points"_a = 3, "range_noise"_a = 0.01, "min_incidence_deg"_a = 10.0,
      nb::call_guard<nb::gil_scoped_release>(),
      "Groups a fix's outliers into obstacles, nearest first. scan: the one that the fix is of.\n"
      "min_points: fewer make no obstacle. range_noise: 1 sigma [m]. min_incidence_deg: the flattest incidence at "
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
