// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/io/trajectory_file.hpp>

#include "arrays.hpp"
#include "map.hpp"
#include "module.hpp"

namespace slamicp::python {
namespace {

using Path = std::filesystem::path;

Array2 load_points(const Path& path) {
  Cloud cloud;
  {
    const nb::gil_scoped_release others_may_run;
    cloud = load_cloud(path);
  }
  if (const auto* plane = std::get_if<PointCloud2>(&cloud.points)) return copy_points<2>(*plane);
  return copy_points<3>(std::get<PointCloud3>(cloud.points));
}

void save_points(const Path& path, nb::handle given, bool binary) {
  const PointArray points(given, "points");
  const CloudEncoding encoding = binary ? CloudEncoding::binary : CloudEncoding::ascii;
  const nb::gil_scoped_release others_may_run;
  if (points.dimension() == 2)
    save_cloud(path, to_cloud<2>(points.view<2>()), encoding);
  else
    save_cloud(path, to_cloud<3>(points.view<3>()), encoding);
}

ScanLog open_log(const Path& path, double fov_deg, double scan_rate_hz, const std::optional<Pose2Numbers>& laser_pose,
                 const std::vector<std::string>& scan_topics, const std::string& odometry_topic,
                 const std::string& base_frame) {
  ScanLogOptions options;
  options.fov_deg = fov_deg;
  options.scan_rate_hz = scan_rate_hz;
  options.laser_offset = pose_from(laser_pose, "laser_pose");
  options.scan_topics = scan_topics;
  options.odometry_topic = odometry_topic;
  options.base_frame = base_frame;
  checked(options);
  const nb::gil_scoped_release others_may_run;
  return open_scan_log(path, options);
}

const LaserScan& scan_at(const ScanLog& log, std::ptrdiff_t index) {
  const auto size = static_cast<std::ptrdiff_t>(log.size());
  if (index < -size || index >= size) throw nb::index_error("there is no such scan in the log");
  return log[static_cast<std::size_t>(index < 0 ? index + size : index)];
}

void bind_scan_log(nb::module_& m) {
  using namespace nb::literals;
  nb::class_<ScanLog>(m, "ScanLog", "A log of lidar scans, all in memory, in the order of the file: a sequence.")
      .def("__len__", &ScanLog::size)
      .def("__getitem__", scan_at, "index"_a, nb::rv_policy::reference_internal)
      .def_ro("name", &ScanLog::name, "The file.")
      .def_ro("format", &ScanLog::format, "'CARMEN', 'ranges CSV', 'ROS 1 bag', ...")
      .def_ro("lasers", &ScanLog::lasers, "The name of each laser, where it has one.")
      .def_ro("warnings", &ScanLog::warnings, "Problems found that do not stop us.");
  m.def(
      "open_scan_log", open_log, "path"_a, nb::kw_only(), "fov_deg"_a = 270.0, "scan_rate_hz"_a = 40.0,
      "laser_pose"_a = nb::none(), "scan_topics"_a = std::vector<std::string>(), "odometry_topic"_a = "",
      "base_frame"_a = "",
      "Reads a log by its file name's ending: .clf, .log CARMEN; .csv ranges, a scan a line; .bag (ROS 1), .db3 or a "
      "folder\n(rosbag2), .mcap. CARMEN and CSV also packed (.gz, .xz, .zst, .bz2).\n\n"
      "fov_deg, scan_rate_hz: of ranges CSV, which do not say. laser_pose: where the laser sits, over what the log "
      "says.\nscan_topics, odometry_topic, base_frame: which, in recordings of ROS. Raises Error with file and line.");
  m.def(
      "save_scan_log", [](const Path& path, const std::vector<LaserScan>& scans) { save_scan_log(path, scans); },
      "path"_a, "scans"_a, "Writes scans as CARMEN (.clf, .log) or ranges CSV (.csv), by the file name's ending.");
}

}  // namespace

void bind_files(nb::module_& m) {
  using namespace nb::literals;
  bind_scan_log(m);
  m.def("load_cloud", load_points, "path"_a,
        "The points of a .csv, .xyz, .txt, .pcd, .ply or map_server .yaml file: (K, 2) where there is no z or z is the "
        "same\neverywhere, else (K, 3) [m].");
  m.def(
      "save_cloud", save_points, "path"_a, "points"_a, nb::kw_only(), "binary"_a = false,
      nb::sig("def save_cloud(path: str | os.PathLike, points: numpy.typing.NDArray[numpy.float64], *, binary: bool = "
              "False) -> None"),
      "Writes points, (K, 2) or (K, 3) [m], by the file name's ending. binary: of .pcd and .ply.");
  m.def(
      "load_map",
      [](const Path& path) {
        const nb::gil_scoped_release others_may_run;
        return Map{load_map(path), nullptr};
      },
      "path"_a,
      "A 2D map, ready to localize in: the points of a cloud file, or the walls of a map_server map (.yaml).");
  m.def(
      "save_map",
      [](const Path& path, const Map& map) {
        const nb::gil_scoped_release others_may_run;
        save_map(path, *map.in_plane());
      },
      "path"_a, "map"_a, "Writes a 2D map's points, by the file name's ending.");
  m.def(
      "load_trajectory", [](const Path& path) { return copy_trajectory(load_trajectory(path)); }, "path"_a,
      "Poses of a file in TUM format, (N, 4): stamp, x, y, heading [s, m, m, rad].");
  m.def(
      "save_trajectory",
      [](const Path& path, nb::handle trajectory) { save_trajectory(path, trajectory_from(trajectory)); }, "path"_a,
      "trajectory"_a,
      nb::sig("def save_trajectory(path: str | os.PathLike, trajectory: numpy.typing.NDArray[numpy.float64]) -> None"),
      "Writes (N, 4), stamp, x, y, heading a row, in TUM format, which evo reads.");
}

}  // namespace slamicp::python
