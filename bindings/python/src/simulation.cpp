// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <slamicp/io/world_file.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/drive.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/map_sampler.hpp>

#include "arrays.hpp"
#include "module.hpp"

namespace slamicp::python {
namespace {

Array2 walls_of(const World& world) {
  PointCloud2 ends;
  for (const Segment& wall : world.walls) {
    ends.push_back(wall.a);
    ends.push_back(wall.b);
  }
  return copy_rows(ends.empty() ? nullptr : ends.front().data(), world.walls.size(), 4);
}

nb::dict routes_of(const World& world) {
  nb::dict routes;
  for (const Route& one : world.routes) routes[one.name.c_str()] = copy_points<2>(one.waypoints);
  return routes;
}

PointCloud2 waypoints_of(const World& world, nb::handle given) {
  std::string name;
  if (nb::try_cast(given, name)) return route(world, name).waypoints;
  return to_cloud<2>(PointArray(given, "route").view<2>());
}

LidarModel lidar_or_default(const LidarModel* lidar) { return checked(lidar == nullptr ? hokuyo_utm30lx() : *lidar); }

World corridor(const std::optional<std::string>& obstacle) {
  return obstacle ? corridor_world_with(*obstacle) : corridor_world();
}

LaserScan simulate_scan(const World& world, const Pose2Numbers& pose, const LidarModel* lidar, std::uint64_t seed,
                        double stamp) {
  const Pose2 T_map_robot = pose_from(pose, "pose");
  const LidarModel model = lidar_or_default(lidar);
  const nb::gil_scoped_release others_may_run;
  Random random(seed);
  return scan(world, T_map_robot, model, random, stamp);
}

SimulatedRun drive(const World& world, nb::handle way, double speed, std::uint64_t seed, const LidarModel* lidar,
                   bool odometry_noise) {
  const PointCloud2 waypoints = waypoints_of(world, way);
  DriveOptions options;
  options.speed = speed;
  options.seed = seed;
  options.lidar = lidar_or_default(lidar);
  if (!odometry_noise) options.odometry = no_odometry_noise();
  checked(options);
  const nb::gil_scoped_release others_may_run;
  return simulate_drive(world, waypoints, options);
}

Array2 sample(const World& world, double spacing, double noise, std::uint64_t seed) {
  PointCloud2 points;
  {
    const nb::gil_scoped_release others_may_run;
    Random random(seed);
    points = sample_map(world, spacing, noise, random);
  }
  return copy_points<2>(points);
}

void bind_world(nb::module_& m) {
  using namespace nb::literals;
  nb::class_<World>(m, "World", "A flat world for a simulated lidar, in the map's frame.")
      .def_ro("name", &World::name)
      .def_prop_ro("walls", walls_of, "(N, 4): x, y of both ends of each wall [m].", nb::rv_policy::automatic)
      .def_prop_ro("routes", routes_of, "Ways through it by name, each (K, 2) [m].", nb::rv_policy::automatic)
      .def(
          "with_box",
          [](const World& world, double x, double y, double width, double depth, double heading) {
            return with_box(world, {{x, y}, width, depth, heading});
          },
          "x"_a, "y"_a, "width"_a, "depth"_a, "heading"_a = 0.0,
          "The same world with a box in it that the map does not know [m, rad].")
      .def(
          "with_cylinder",
          [](const World& world, double x, double y, double radius) {
            return with_cylinder(world, {{x, y}, radius});
          },
          "x"_a, "y"_a, "radius"_a, "The same world with a cylinder in it that the map does not know [m].")
      .def("__repr__", [](const World& world) {
        return "<slamicp.World '" + world.name + "', " + std::to_string(world.walls.size()) + " walls>";
      });
  m.def("corridor_world", corridor, "obstacle"_a = nb::none(),
        "The paper's corridor, as far as its figures show it; obstacle: 'A1' to 'D3', which the map does not know.");
  m.def("load_world", load_world, "path"_a, "A world from a YAML file, see docs/worlds.md.",
        nb::call_guard<nb::gil_scoped_release>());
  m.def("save_world", save_world, "path"_a, "world"_a, "Writes a world as YAML.",
        nb::call_guard<nb::gil_scoped_release>());
}

void bind_lidar(nb::module_& m) {
  using namespace nb::literals;
  nb::class_<LidarModel>(m, "LidarModel", "A planar lidar, as its data sheet has it. m, rad, s, Hz.")
      .def(nb::init<>())
      .def_rw("beams", &LidarModel::beams, "A sweep.")
      .def_rw("angle_min", &LidarModel::angle_min, "Direction of beam 0 [rad].")
      .def_rw("angle_increment", &LidarModel::angle_increment, "[rad]")
      .def_rw("range_min", &LidarModel::range_min, "Nearer things give no return [m].")
      .def_rw("range_max", &LidarModel::range_max, "So do things at this range and beyond [m].")
      .def_rw("rate", &LidarModel::rate, "Sweeps a second [Hz].")
      .def_rw("sweep_time", &LidarModel::sweep_time, "From the first beam to the last [s].")
      .def_rw("range_noise", &LidarModel::range_noise, "1 sigma [m].");
  m.def("hokuyo_utm30lx", &hokuyo_utm30lx, "range_noise"_a = 0.01,
        "The paper's laser: 1,081 beams over 270 deg, 0.1 to 30 m, 40 Hz.");
  m.def("real_hokuyo_utm30lx", &real_hokuyo_utm30lx,
        "The same with bias, lost and mixed readings, and a sweep of 25 ms.");
}

}  // namespace

void bind_simulation(nb::module_& m) {
  using namespace nb::literals;
  bind_world(m);
  bind_lidar(m);
  nb::class_<SimulatedRun>(m, "SimulatedRun", "What a log of the drive would hold, and what really happened.")
      .def_prop_ro(
          "scans", [](const SimulatedRun& run) { return &run.scans; }, nb::rv_policy::reference_internal,
          "A list of LaserScan, with odometry.")
      .def_prop_ro(
          "truth", [](const SimulatedRun& run) { return copy_trajectory(run.truth); },
          "(N, 4): stamp, x, y, heading of every scan [s, m, m, rad].", nb::rv_policy::automatic);
  m.def("simulate_scan", simulate_scan, "world"_a, "pose"_a, nb::kw_only(), "lidar"_a.none() = nb::none(), "seed"_a = 1,
        "stamp"_a = 0.0,
        "One sweep of a robot that stands at pose: x, y, heading. The same arguments give the same scan.");
  m.def("simulate_drive", drive, "world"_a, "route"_a, nb::kw_only(), "speed"_a = 0.35, "seed"_a = 1,
        "lidar"_a.none() = nb::none(), "odometry_noise"_a = true,
        nb::sig("def simulate_drive(world: World, route: str | numpy.typing.NDArray[numpy.float64], *, speed: float = "
                "0.35, seed: int = 1, lidar: LidarModel | None = None, odometry_noise: bool = True) -> SimulatedRun"),
        "A drive along a route, by its name or as waypoints (K, 2) [m]. speed: [m/s]. The same arguments give the same "
        "run.");
  m.def("sample_map", sample, "world"_a, nb::kw_only(), "spacing"_a = default_map_spacing,
        "noise"_a = default_map_noise, "seed"_a = 1,
        "A map as a careful survey would make it, (K, 2) [m]: points along what the map knows of the world.");
}

}  // namespace slamicp::python
