// SPDX-License-Identifier: Apache-2.0
#include <mutex>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <slamicp/localization/localizer.hpp>

#include "arrays.hpp"
#include "map.hpp"
#include "module.hpp"
#include "words.hpp"

namespace slamicp::python {
namespace {

/// A Localizer whose threads take turns. A Fix goes out as a copy: the next scan leaves it alone.
class Follower {
 public:
  Follower(const Map* map, const LocalizerOptions& options)
      : localizer_(map == nullptr ? Localizer(options) : Localizer(map->in_plane(), options)) {}

  void set_pose(const Pose2& pose) {
    const std::lock_guard turn(mutex_);
    localizer_.set_pose(pose);
  }
  void set_map(const PointMap2::Pointer& map) {
    const std::lock_guard turn(mutex_);
    localizer_.set_map(map);
  }
  Fix fix() {
    const std::lock_guard turn(mutex_);
    return localizer_.fix();
  }
  PointMap2::Pointer map() {
    const std::lock_guard turn(mutex_);
    return localizer_.map();
  }
  Fix update(std::span<const LaserScan> scans) {
    const nb::gil_scoped_release others_may_run;
    const std::lock_guard turn(mutex_);
    return localizer_.update(scans);
  }
  bool recover(int budget) {
    if (budget < 1) throw Refusal(SLAMICP_BAD_OPTIONS, "budget must be at least 1; 1000 take about half a millisecond");
    const nb::gil_scoped_release others_may_run;
    const std::lock_guard turn(mutex_);
    return localizer_.recover(budget);
  }

 private:
  Localizer localizer_;
  std::mutex mutex_;
};

void make_follower(Follower* made, const Map* map, double max_correspondence_distance,
                   std::optional<double> outlier_distance, std::optional<double> obstacle_distance,
                   const std::string& method, int max_iterations, const std::string& kernel, double kernel_scale,
                   double final_gate, double guess_share, double min_range, double max_range, bool use_odometry,
                   bool deskew, bool covariance, bool transformed_scan, bool matches) {
  if (!(min_range >= 0.0) || !(max_range > min_range))
    throw Refusal(SLAMICP_BAD_OPTIONS, "min_range must be at least 0 m and below max_range");
  LocalizerOptions options;
  options.max_correspondence_distance = max_correspondence_distance;
  options.outlier_distance = outlier_distance;
  options.obstacle_distance = obstacle_distance;
  options.method = method_named(method);
  options.max_iterations = max_iterations;
  options.kernel = kernel_named(kernel);
  options.kernel_scale = kernel_scale;
  options.final_gate = final_gate;
  options.guess_share = guess_share;
  options.ranges = {min_range, max_range};
  options.use_odometry = use_odometry;
  options.deskew = deskew;
  options.outputs.covariance = covariance;
  options.outputs.transformed_scan = transformed_scan;
  options.outputs.matches = matches;
  checked(options);
  new (made) Follower(map, options);
}

std::optional<Map> maybe_map(const PointMap2::Pointer& map) {
  if (!map) return std::nullopt;
  return Map{map, nullptr};
}

const Fix& fix_of(nb::handle self) { return nb::cast<const Fix&>(self); }

void bind_fix(nb::module_& m) {
  nb::class_<Fix>(
      m, "Fix",
      "What one scan told: where the robot is, how sure that is, and what stands there that the map does not "
      "know.\n\nArrays are read-only views into it.")
      .def_ro("stamp", &Fix::stamp, "Of the scan [s].")
      .def_prop_ro(
          "pose", [](const Fix& fix) { return copy_pose(fix.pose); }, "T_map_robot: x, y, heading [m, m, rad].",
          nb::rv_policy::automatic)
      .def_prop_ro(
          "predicted", [](const Fix& fix) { return copy_pose(fix.predicted); },
          "The pose before the match, by odometry or constant velocity.", nb::rv_policy::automatic)
      .def_prop_ro(
          "covariance", [](const Fix& fix) { return copy_covariance(fix.covariance); },
          "Of the error as seen from the robot (ahead, left, heading) [m, m, rad], (3, 3).", nb::rv_policy::automatic)
      .def_prop_ro(
          "covariance_in_map", [](const Fix& fix) { return copy_covariance(fix.covariance_in_map()); },
          "The same along the map's axes: x, y, heading.", nb::rv_policy::automatic)
      .def_prop_ro(
          "stop", [](const Fix& fix) { return std::string(to_string(fix.stop())); },
          "'converged', 'max_iterations', 'degenerate', 'too_few_points' or 'no_overlap'.")
      .def_prop_ro("usable", &Fix::usable, "True if the pose can be used.")
      .def_prop_ro(
          "state", [](const Fix& fix) { return std::string(to_string(fix.quality.state)); },
          "'tracking', 'degenerate', 'suspect' or 'lost'.")
      .def_prop_ro(
          "probability", [](const Fix& fix) { return fix.quality.probability; },
          "That the pose is right to within half a metre and 15 deg, calibrated.")
      .def_prop_ro(
          "awareness", [](const Fix& fix) { return fix.quality.awareness; },
          "Share of the surroundings that the map explains, over the last seconds.")
      .def_prop_ro(
          "carried_by", [](const Fix& fix) { return std::string(to_string(fix.carried_by)); },
          "What a direction follows that the scan does not hold: 'scan' (there is none), 'odometry', 'velocity'.")
      .def_prop_ro(
          "blind_direction", [](const Fix& fix) { return copy_numbers(fix.blind_direction.data(), 2); },
          "Unit vector in the map that the scan does not hold; 0, 0 where there is none.", nb::rv_policy::automatic)
      .def_prop_ro(
          "iterations", [](const Fix& fix) { return fix.match.iterations; }, "Steps of the match.")
      .def_prop_ro(
          "inliers", [](const Fix& fix) { return fix.match.inliers; }, "Points that the map explains.")
      .def_prop_ro(
          "mean_inlier_distance", [](const Fix& fix) { return fix.match.mean_inlier_distance; }, "[m]")
      .def_prop_ro(
          "points", [](nb::handle self) { return view_points<2>(fix_of(self).scan.in_robot, self); },
          "The returns that were used, (K, 2) in the robot's frame [m].")
      .def_prop_ro(
          "beams", [](nb::handle self) { return view_indices(fix_of(self).scan.beams, self); },
          "The beam of each of the points, (K,).")
      .def_prop_ro(
          "outliers", [](nb::handle self) { return view_indices(fix_of(self).outliers(), self); },
          "Rows of `points` that nothing in the map explains, rising.")
      .def_prop_ro(
          "outliers_in_map", [](nb::handle self) { return view_points<2>(fix_of(self).outliers_in_map(), self); },
          "The same as points in the map's frame [m].")
      .def_prop_ro(
          "transformed_scan", [](nb::handle self) { return view_points<2>(fix_of(self).match.transformed_scan, self); },
          "`points` in the map's frame [m]; empty unless the localizer was made with transformed_scan=True.")
      .def_prop_ro(
          "match_distances",
          [](const Fix& fix) {
            auto distances = std::make_unique<double[]>(fix.match.matches.size());
            for (std::size_t k = 0; k < fix.match.matches.size(); ++k) distances[k] = fix.match.matches[k].distance;
            return owned<Array1>(std::move(distances), {fix.match.matches.size()});
          },
          "From each of `points` to the map [m], inf beyond reach; empty unless made with matches=True.",
          nb::rv_policy::automatic)
      .def_prop_ro(
          "map", [](const Fix& fix) { return maybe_map(fix.map); }, "The snapshot that was matched against, or None.")
      .def("brief", &Fix::brief, "One line: stop reason, pose, inliers and outliers.")
      .def("__repr__", [](const Fix& fix) { return "<slamicp.Fix: " + fix.brief() + ">"; });
}

}  // namespace

void bind_localizer(nb::module_& m) {
  using namespace nb::literals;
  bind_fix(m);
  nb::class_<Follower>(
      m, "Localizer",
      "Follows a robot through its map, scan by scan: predict by odometry (or constant velocity), match, "
      "hand out a Fix.\n\nWithout a map each scan is matched to the one before. Threads take turns.")
      .def("__init__", make_follower, "map"_a.none() = nb::none(), nb::kw_only(), "max_correspondence_distance"_a = 0.3,
           "outlier_distance"_a = nb::none(), "obstacle_distance"_a = nb::none(), "method"_a = "point_to_line",
           "max_iterations"_a = 50, "kernel"_a = "none", "kernel_scale"_a = 0.05, "final_gate"_a = 0.0,
           "guess_share"_a = 0.0, "min_range"_a = 0.0, "max_range"_a = 1e9, "use_odometry"_a = true, "deskew"_a = true,
           "covariance"_a = true, "transformed_scan"_a = false, "matches"_a = false,
           "map: of 2 dimensions. obstacle_distance: what find_obstacles() begins at [m], by default from the noise.\n"
           "max_correspondence_distance (the paper's indist), outlier_distance (O_t), method, "
           "kernel,\nfinal_gate, guess_share: as align() has them. min_range, max_range: other readings are left out "
           "[m].\n"
           "use_odometry: predict by the scans' odometry, where they have it. deskew: undo the motion within a scan "
           "that\n"
           "has a time_increment. covariance, transformed_scan, matches: computed for each Fix if True.")
      .def(
          "set_pose",
          [](Follower& localizer, const Pose2Numbers& pose) { localizer.set_pose(pose_from(pose, "pose")); }, "pose"_a,
          "Where the robot is now: x, y, heading [m, m, rad]. Motion is forgotten.")
      .def(
          "set_map", [](Follower& localizer, const Map& map) { localizer.set_map(map.in_plane()); }, "map"_a,
          "Another map, from the next scan on.")
      .def_prop_ro(
          "map", [](Follower& localizer) { return maybe_map(localizer.map()); },
          "The map, or None before the first scan.")
      .def_prop_ro("fix", &Follower::fix,
                   "The last Fix; before the first scan one at the pose that was set, not usable.")
      .def(
          "update",
          [](Follower& localizer, const LaserScan& scan) {
            return localizer.update({&scan, 1});
          },
          "scan"_a, "Localizes one scan. Releases the GIL.")
      .def(
          "update", [](Follower& localizer, const std::vector<LaserScan>& scans) { return localizer.update(scans); },
          "scans"_a, "One fix from the scans of several lasers, at the stamp of the first.")
      .def("recover", &Follower::recover, "budget"_a = 1000,
           "Looks for the robot near where it was last trusted, where the state is 'suspect' or 'lost': up to `budget` "
           "places\na call, one call a scan. True where it found it and set the pose anew. Releases the GIL.");
}

}  // namespace slamicp::python
