// SPDX-License-Identifier: Apache-2.0
#include <mutex>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <slamicp/mapping/mapper.hpp>

#include "arrays.hpp"
#include "map.hpp"
#include "module.hpp"

namespace slamicp::python {
namespace {

/// A Mapper whose threads take turns.
struct Builder {
  explicit Builder(const MapperOptions& options) : mapper(options) {}

  template <class Work>
  auto in_turn(Work work) {
    const nb::gil_scoped_release others_may_run;
    const std::lock_guard turn(mutex);
    return work(mapper);
  }

  Mapper mapper;
  std::mutex mutex;
};

std::optional<Map> maybe(PointMap2::Pointer map) {
  if (!map) return std::nullopt;
  return Map{std::move(map), nullptr};
}

}  // namespace

void bind_mapper(nb::module_& m) {
  using namespace nb::literals;
  nb::class_<Builder>(
      m, "Mapper",
      "Builds a map while localizing in it: SLAM by scan matching alone, without loop closure. Only what "
      "the map does\nnot have yet goes into it, so walls stay thin.")
      .def(
          "__init__",
          [](Builder* made, double max_correspondence_distance, double insertion_distance, double keyframe_distance,
             double keyframe_turn, const Pose2Numbers& initial_pose, double min_range, double max_range,
             bool use_odometry) {
            MapperOptions options;
            options.max_correspondence_distance = max_correspondence_distance;
            options.insertion_distance = insertion_distance;
            options.keyframe_distance = keyframe_distance;
            options.keyframe_turn = keyframe_turn;
            options.initial_pose = pose_from(initial_pose, "initial_pose");
            options.ranges = {min_range, max_range};
            options.use_odometry = use_odometry;
            new (made) Builder(checked(options));
          },
          nb::kw_only(), "max_correspondence_distance"_a = 1.0, "insertion_distance"_a = 0.05,
          "keyframe_distance"_a = 0.3, "keyframe_turn"_a = 0.17, "initial_pose"_a = Pose2Numbers{0.0, 0.0, 0.0},
          "min_range"_a = 0.0, "max_range"_a = 1e9, "use_odometry"_a = true,
          "insertion_distance: a point at least this far from the map is new [m]. keyframe_distance, keyframe_turn: "
          "the "
          "map grows\nwhen the robot has moved or turned this far [m], [rad]. initial_pose: at the first scan.")
      .def(
          "add",
          [](Builder& builder, const LaserScan& scan) {
            return builder.in_turn([&](Mapper& mapper) -> Fix { return mapper.add(scan); });
          },
          "scan"_a, "Takes the next scan, in the order of the log, and hands out its Fix. Releases the GIL.")
      .def_prop_ro(
          "map", [](Builder& builder) { return maybe(builder.in_turn([](Mapper& mapper) { return mapper.map(); })); },
          "The map so far, or None.")
      .def(
          "refined_map",
          [](Builder& builder) { return maybe(builder.in_turn([](Mapper& mapper) { return mapper.refined_map(); })); },
          "The map to keep, once the log is done: points moved to the mean of what was seen of them, noise removed. "
          "None "
          "before\nthe first scan.")
      .def_prop_ro(
          "trajectory",
          [](Builder& builder) {
            return copy_trajectory(builder.in_turn([](Mapper& mapper) { return mapper.trajectory(); }));
          },
          "(N, 4): stamp, x, y, heading of every scan [s, m, m, rad].", nb::rv_policy::automatic);
}

}  // namespace slamicp::python
