// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <slamicp/scan/scan_points.hpp>

#include "arrays.hpp"
#include "module.hpp"

namespace slamicp::python {
namespace {

void need_finite(double value, const char* name) {
  if (!std::isfinite(value)) throw Refusal(SLAMICP_BAD_SCAN, std::string(name) + " must be finite");
}

void make_scan(LaserScan* made, nb::handle ranges, double angle_min, double angle_increment, double stamp,
               double time_increment, double range_min, double range_max, const Pose2Numbers& laser_pose,
               const std::optional<Pose2Numbers>& odometry, const std::optional<Pose2Numbers>& sweep_motion,
               int laser) {
  need_finite(angle_min, "angle_min");
  need_finite(angle_increment, "angle_increment");
  need_finite(stamp, "stamp");
  need_finite(time_increment, "time_increment");
  if (std::isnan(range_min) || std::isnan(range_max))
    throw Refusal(SLAMICP_BAD_SCAN, "range_min and range_max must be numbers");
  const auto array = range_array(ranges, "ranges");
  if (array.size() > 10'000'000) throw Refusal(SLAMICP_BAD_SCAN, "ranges has more than 10^7 beams");
  LaserScan scan;
  scan.stamp = stamp;
  scan.time_increment = time_increment;
  scan.angle_min = angle_min;
  scan.angle_increment = angle_increment;
  scan.range_min = range_min;
  scan.range_max = range_max;
  scan.T_robot_laser = pose_from(laser_pose, "laser_pose");
  scan.T_odom_robot = pose_from(odometry, "odometry");
  scan.sweep_motion = pose_from(sweep_motion, "sweep_motion");
  scan.laser = laser;
  scan.ranges.assign(array.data(), array.data() + array.size());
  new (made) LaserScan(std::move(scan));
}

Floats ranges_of(nb::handle self) {
  static constexpr float no_range[1] = {0.0F};
  const std::vector<float>& ranges = nb::cast<const LaserScan&>(self).ranges;
  return Floats(ranges.empty() ? no_range : ranges.data(), {ranges.size()}, self);
}

std::optional<Array1> maybe_pose(const std::optional<Pose2>& pose) {
  if (!pose) return std::nullopt;
  return copy_pose(*pose);
}

}  // namespace

void bind_scan(nb::module_& m) {
  using namespace nb::literals;
  nb::class_<LaserScan>(
      m, "LaserScan",
      "One sweep of a planar lidar.\n\n"
      "Beam i points to angle_min + i * angle_increment [rad] in the laser's frame (x ahead, y to the "
      "left) and was\nmeasured at stamp + i * time_increment [s]. NaN, inf, 0, below range_min, at or "
      "above range_max: no return.")
      .def(
          "__init__", make_scan, "ranges"_a, "angle_min"_a, "angle_increment"_a, nb::kw_only(), "stamp"_a = 0.0,
          "time_increment"_a = 0.0, "range_min"_a = 0.0, "range_max"_a = 1e9,
          "laser_pose"_a = Pose2Numbers{0.0, 0.0, 0.0}, "odometry"_a = nb::none(), "sweep_motion"_a = nb::none(),
          "laser"_a = 0,
          nb::sig("def __init__(self, ranges: numpy.typing.NDArray[numpy.float32], angle_min: float, angle_increment: "
                  "float, *, stamp: float = 0.0, time_increment: float = 0.0, range_min: float = 0.0, range_max: float "
                  "= 1e9, laser_pose: collections.abc.Sequence[float] = (0.0, 0.0, 0.0), odometry: "
                  "collections.abc.Sequence[float] | None = None, sweep_motion: collections.abc.Sequence[float] | None "
                  "= None, laser: int = 0) -> None"),
          "ranges: (N,) [m]. angle_min, angle_increment: [rad]. stamp, time_increment: [s]; 0: all beams at once.\n"
          "laser_pose: where the laser sits on the robot, x, y, heading [m, m, rad].\n"
          "odometry: the robot's pose by its wheels at the stamp. sweep_motion: how far it moved, by its wheels, from "
          "the\nfirst beam to the last. laser: which of the robot's lasers.")
      .def_prop_ro("ranges", ranges_of, "(N,) float32 [m]: a read-only view.")
      .def_ro("stamp", &LaserScan::stamp, "When beam 0 was measured [s].")
      .def_ro("time_increment", &LaserScan::time_increment, "From one beam to the next [s].")
      .def_ro("angle_min", &LaserScan::angle_min, "Direction of beam 0 [rad].")
      .def_ro("angle_increment", &LaserScan::angle_increment, "From one beam to the next [rad].")
      .def_ro("range_min", &LaserScan::range_min, "Readings below are no returns [m].")
      .def_ro("range_max", &LaserScan::range_max, "Readings at or above are no returns [m].")
      .def_ro("laser", &LaserScan::laser, "Which of the robot's lasers, counted from 0.")
      .def_prop_ro(
          "laser_pose", [](const LaserScan& scan) { return copy_pose(scan.T_robot_laser); },
          "Where the laser sits on the robot: x, y, heading [m, m, rad].", nb::rv_policy::automatic)
      .def_prop_ro(
          "odometry", [](const LaserScan& scan) { return maybe_pose(scan.T_odom_robot); },
          "The robot's pose by its wheels at the stamp, or None.", nb::rv_policy::automatic)
      .def_prop_ro(
          "sweep_motion", [](const LaserScan& scan) { return maybe_pose(scan.sweep_motion); },
          "How far the robot moved, by its wheels, from the first beam to the last, or None.", nb::rv_policy::automatic)
      .def(
          "points",
          [](const LaserScan& scan, double min_range, double max_range) {
            return copy_points<2>(to_points(scan, {min_range, max_range}).in_robot);
          },
          nb::kw_only(), "min_range"_a = 0.0, "max_range"_a = 1e9,
          "The returns in the robot's frame, (K, 2) [m], as if measured all at once: the paper's T.")
      .def("__len__", [](const LaserScan& scan) { return scan.ranges.size(); })
      .def("__repr__", [](const LaserScan& scan) {
        return "<slamicp.LaserScan of " + std::to_string(scan.ranges.size()) + " beams>";
      });
}

}  // namespace slamicp::python
