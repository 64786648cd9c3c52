// SPDX-License-Identifier: Apache-2.0
#include "map.hpp"

#include <cmath>
#include <memory>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <utility>

#include "arrays.hpp"
#include "module.hpp"

namespace slamicp::python {
namespace {

SurfaceOptions surfaces_of(int neighbours, double radius, int min_neighbours, double scatter, int threads) {
  if (neighbours < 0 || neighbours > 64)
    throw Refusal(SLAMICP_BAD_OPTIONS, "neighbours must lie between 0 (no lines) and 64; 12 is the default");
  if (neighbours > 0 && (min_neighbours < 3 || min_neighbours > neighbours))
    throw Refusal(SLAMICP_BAD_OPTIONS, "min_neighbours must lie between 3 and neighbours; 5 is the default");
  if (!(radius > 0.0) || !std::isfinite(radius))
    throw Refusal(SLAMICP_BAD_OPTIONS, "radius must be a length above 0 m; 0.5 m is the default");
  if (!(scatter > 0.0))
    throw Refusal(SLAMICP_BAD_OPTIONS, "scatter must be above 0; 1.3 is the default, infinity trusts every line");
  if (threads < 1 || threads > 256) throw Refusal(SLAMICP_BAD_OPTIONS, "threads must lie between 1 and 256");
  SurfaceOptions surfaces;
  surfaces.neighbours = neighbours;
  surfaces.radius = radius;
  surfaces.min_neighbours = min_neighbours;
  surfaces.scatter = scatter;
  surfaces.threads = threads;
  return surfaces;
}

void make_map(Map* made, nb::handle given, int neighbours, double radius, int min_neighbours, double scatter,
              double cell, double reach, int threads) {
  const PointArray points(given, "points");
  const SurfaceOptions surfaces = surfaces_of(neighbours, radius, min_neighbours, scatter, threads);
  CellOptions cells;
  cells.cell = cell;
  cells.reach = reach;
  checked(cells);
  Map map;
  {
    const nb::gil_scoped_release others_may_run;
    if (points.dimension() == 2)
      map.plane = PointMap2::create(to_cloud<2>(points.view_of_some<2>()), surfaces, cells);
    else
      map.space = PointMap3::create(to_cloud<3>(points.view_of_some<3>()), surfaces);
  }
  new (made) Map(std::move(map));
}

Map with_added(const Map& map, nb::handle given) {
  const PointArray points(given, "points");
  const nb::gil_scoped_release others_may_run;
  if (map.plane) return {map.plane->with_added(points.view<2>()), nullptr};
  return {nullptr, map.space->with_added(points.view<3>())};
}

Map with_removed(const Map& map, const std::vector<int>& which) {
  return {map.in_plane()->with_removed(which), nullptr};
}

Array2 points_of(nb::handle self) {
  const Map& map = nb::cast<const Map&>(self);
  return map.plane ? view_points<2>(map.plane->points(), self) : view_points<3>(map.space->points(), self);
}

template <int D>
void find_nearest(const IndexedPoints<D>& points, PointView<D> queries, double reach, int* indices, double* distances) {
  for (std::size_t k = 0; k < queries.size(); ++k) {
    const Neighbour found = points.nearest(queries[k], reach);
    indices[k] = found.index;
    distances[k] = std::sqrt(found.squared_distance);
  }
}

auto nearest(const Map& map, nb::handle given, double reach) {
  const PointArray queries(given, "queries");
  if (!(reach > 0.0) || !std::isfinite(reach)) throw Refusal(SLAMICP_BAD_OPTIONS, "reach must be a length above 0 m");
  const std::size_t count = queries.size();
  auto indices = std::make_unique<int[]>(count);
  auto distances = std::make_unique<double[]>(count);
  {
    const nb::gil_scoped_release others_may_run;
    if (map.plane)
      find_nearest<2>(map.plane->indexed(), queries.view<2>(), reach, indices.get(), distances.get());
    else
      find_nearest<3>(map.space->indexed(), queries.view<3>(), reach, indices.get(), distances.get());
  }
  return std::pair(owned<Indices>(std::move(indices), {count}), owned<Array1>(std::move(distances), {count}));
}

}  // namespace

const PointMap2::Pointer& Map::in_plane() const {
  if (!plane) throw Refusal(SLAMICP_BAD_POINTS, "the map must have points of two coordinates for this");
  return plane;
}

void bind_map(nb::module_& m) {
  using namespace nb::literals;
  nb::class_<Map>(m, "Map",
                  "Points, the line (in 3D plane) around each, and an index to find the nearest.\n\n"
                  "A map never changes: an update makes another one. Any number of threads may use it.")
      .def("__init__", make_map, "points"_a, nb::kw_only(), "neighbours"_a = 12, "radius"_a = 0.5,
           "min_neighbours"_a = 5, "scatter"_a = 1.3, "cell"_a = 0.05, "reach"_a = 0.3, "threads"_a = 1,
           nb::sig("def __init__(self, points: numpy.typing.NDArray[numpy.float64], *, neighbours: int = 12, radius: "
                   "float = 0.5, min_neighbours: int = 5, scatter: float = 1.3, cell: float = 0.05, reach: float = "
                   "0.3, threads: int = 1) -> None"),
           "A map of these points.\n\n"
           "points: (K, 2) or (K, 3), in the map's frame [m]. Points that are not finite keep their number and are\n"
           "  never found; at least one must be finite.\n"
           "neighbours: points that a line is fitted to, at most 64; 0: no lines, for point-to-point only.\n"
           "radius: neighbours farther away take no part [m]. min_neighbours: with fewer a point has no line.\n"
           "scatter: lines that points scatter about more than this times the map's median count less, 2D; inf: none.\n"
           "cell: side of the index's cells [m], 2D. reach: the longest distance asked for, at most 15 cells [m], 2D.\n"
           "threads: to fit lines with; the result is the same for any number. O(K log K). Raises Error.")
      .def("__len__", [](const Map& map) { return map.plane ? map.plane->size() : map.space->size(); })
      .def_prop_ro("points", points_of, "All points, (K, 2) or (K, 3) [m]: a read-only view, not a copy.")
      .def_prop_ro("dimension", &Map::dimension, "2 or 3.")
      .def_prop_ro(
          "version", [](const Map& map) { return map.plane ? map.plane->version() : map.space->version(); },
          "0 for a map just made, one more with each update.")
      .def("with_added", with_added, "points"_a,
           nb::sig("def with_added(self, points: numpy.typing.NDArray[numpy.float64]) -> Map"),
           "This map and more points behind it, (K, 2) or (K, 3) [m]; existing points keep their numbers. Give it a "
           "fix's\n`outliers_in_map` and walls stay thin (the paper, section 3.2).")
      .def("with_removed", with_removed, "indices"_a,
           "This map without some points, 2D: they keep their numbers but are no longer finite.")
      .def(
          "nearest", nearest, "queries"_a, "reach"_a,
          nb::sig("def nearest(self, queries: numpy.typing.NDArray[numpy.float64], reach: float) -> "
                  "tuple[numpy.typing.NDArray[numpy.int32], numpy.typing.NDArray[numpy.float64]]"),
          "For each query, (K, 2) or (K, 3) [m], the number of the nearest point closer than reach [m], -1 where there "
          "is\nnone, and its distance [m], inf where there is none. Exact; ties go to the lower number.")
      .def("__repr__", [](const Map& map) {
        return "<slamicp.Map of " + std::to_string(map.plane ? map.plane->size() : map.space->size()) + " points in " +
               std::to_string(map.dimension()) + "D>";
      });
}

}  // namespace slamicp::python
