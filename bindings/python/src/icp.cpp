// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <mutex>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>
#include <variant>

#include <slamicp/registration/icp.hpp>

#include "arrays.hpp"
#include "map.hpp"
#include "module.hpp"
#include "words.hpp"

namespace slamicp::python {
namespace {

using AnyResult = std::variant<IcpResult2, IcpResult3>;

IcpOptions options_of(double max_correspondence_distance, std::optional<double> outlier_distance,
                      const std::string& method, int max_iterations, const std::string& kernel, double kernel_scale,
                      double final_gate, double guess_share, double translation_tolerance, double rotation_tolerance,
                      bool coarse_to_fine) {
  IcpOptions options;
  options.method = method_named(method);
  options.max_correspondence_distance = max_correspondence_distance;
  options.outlier_distance = outlier_distance;
  options.max_iterations = max_iterations;
  options.kernel = kernel_named(kernel);
  options.kernel_scale = kernel_scale;
  options.final_gate = final_gate;
  options.guess_share = guess_share;
  options.translation_tolerance = translation_tolerance;
  options.rotation_tolerance = rotation_tolerance;
  options.coarse_to_fine = coarse_to_fine;
  return checked(options);
}

template <int D>
Pose<D> guess_from(const std::optional<nb::object>& guess) {
  if (!guess || guess->is_none()) return {};
  std::array<double, Pose<D>::degrees_of_freedom> numbers;
  if (!nb::try_cast(*guess, numbers))
    throw Refusal(SLAMICP_BAD_POSE, D == 2 ? "guess must be three numbers: x, y, heading"
                                           : "guess must be six numbers: x, y, z, roll, pitch, yaw");
  return c::pose_from<D>(numbers.data(), "guess");
}

/// Matches scans to maps and keeps its memory; threads of Python take turns.
class Matcher {
 public:
  explicit Matcher(const IcpOptions& options) : options_(options), plane_(options), space_(options) {}

  AnyResult align(const Map& map, nb::handle given, const std::optional<nb::object>& guess, const Outputs& wanted) {
    const PointArray scan(given, "scan");
    scan.need_dimension(map.dimension());
    if (map.plane) return align_in<2>(plane_, map.plane->indexed(), scan, guess_from<2>(guess), wanted);
    return align_in<3>(space_, map.space->indexed(), scan, guess_from<3>(guess), wanted);
  }

 private:
  template <int D>
  IcpResult<D> align_in(Icp<D>& icp, const IndexedPoints<D>& map, const PointArray& scan, const Pose<D>& guess,
                        const Outputs& wanted) {
    if (options_.method != Method::point_to_point && !map.has_surfaces())
      throw Refusal(SLAMICP_BAD_STATE,
                    "the map was made without lines, with neighbours=0: good for point_to_point only");
    const nb::gil_scoped_release others_may_run;
    const std::lock_guard turn(mutex_);
    return icp.align(map, scan.view<D>(), guess, wanted);
  }

  IcpOptions options_;
  Icp<2> plane_;
  Icp<3> space_;
  std::mutex mutex_;
};

template <int D>
IcpResult<D> align_once(const PointArray& source, const PointArray& target, const Pose<D>& guess,
                        const IcpOptions& options, const Outputs& wanted) {
  const nb::gil_scoped_release others_may_run;
  return align<D>(to_cloud<D>(source.view<D>()), to_cloud<D>(target.view_of_some<D>()), guess, options, wanted);
}

AnyResult align_points(nb::handle source, nb::handle target, const std::optional<nb::object>& guess,
                       double max_correspondence_distance, std::optional<double> outlier_distance,
                       const std::string& method, int max_iterations, const std::string& kernel, double kernel_scale,
                       double final_gate, double guess_share) {
  const IcpOptions defaults;
  const IcpOptions options = options_of(max_correspondence_distance, outlier_distance, method, max_iterations, kernel,
                                        kernel_scale, final_gate, guess_share, defaults.translation_tolerance,
                                        defaults.rotation_tolerance, defaults.coarse_to_fine);
  const PointArray from(source, "source"), to(target, "target");
  from.need_dimension(to.dimension());
  if (to.dimension() == 2) return align_once<2>(from, to, guess_from<2>(guess), options, Outputs::all());
  return align_once<3>(from, to, guess_from<3>(guess), options, Outputs::all());
}

template <int D>
Array2 transform_of(const IcpResult<D>& result) {
  double numbers[16];
  c::write_transform<D>(result.pose, numbers);
  return copy_rows(numbers, D + 1, D + 1);
}

template <int D>
Indices match_indices(const IcpResult<D>& result) {
  auto indices = std::make_unique<int[]>(result.matches.size());
  std::transform(result.matches.begin(), result.matches.end(), indices.get(),
                 [](const Match& match) { return match.map_index; });
  return owned<Indices>(std::move(indices), {result.matches.size()});
}

template <int D>
Array1 match_distances(const IcpResult<D>& result) {
  auto distances = std::make_unique<double[]>(result.matches.size());
  std::transform(result.matches.begin(), result.matches.end(), distances.get(),
                 [](const Match& match) { return match.distance; });
  return owned<Array1>(std::move(distances), {result.matches.size()});
}

template <int D>
void bind_result(nb::module_& m, const char* name, const char* text) {
  using Result = IcpResult<D>;
  nb::class_<Result>(m, name, text)
      .def_prop_ro(
          "pose", [](const Result& result) { return copy_pose(result.pose); },
          D == 2 ? "T_map_robot: x, y, heading [m, m, rad]. The paper's P."
                 : "T_map_robot: x, y, z, roll, pitch, yaw [m, rad], R = Rz(yaw) Ry(pitch) Rx(roll). The paper's P.",
          nb::rv_policy::automatic)
      .def_prop_ro("transform", transform_of<D>, "T_map_robot as a homogeneous matrix.", nb::rv_policy::automatic)
      .def_prop_ro(
          "stop", [](const Result& result) { return std::string(to_string(result.stop)); },
          "'converged', 'max_iterations', 'degenerate', 'too_few_points' or 'no_overlap'.")
      .def_prop_ro("usable", &Result::usable, "True if the pose can be used.")
      .def_ro("iterations", &Result::iterations, "Steps made: the paper's n.")
      .def_ro("inliers", &Result::inliers, "How many points are closer to the map than max_correspondence_distance.")
      .def_ro("mean_inlier_distance", &Result::mean_inlier_distance, "[m]: the paper's m_d.")
      .def_prop_ro(
          "outliers", [](nb::handle self) { return view_indices(nb::cast<const Result&>(self).outlier_indices, self); },
          "Rows of the scan at least outlier_distance from every map point, rising: the paper's O_indx. A read-only "
          "view.")
      .def_prop_ro(
          "outliers_in_map",
          [](nb::handle self) { return view_points<D>(nb::cast<const Result&>(self).outliers_in_map, self); },
          "The same as points in the map's frame [m]: the paper's O_coords. A read-only view.")
      .def_prop_ro(
          "transformed_scan",
          [](nb::handle self) { return view_points<D>(nb::cast<const Result&>(self).transformed_scan, self); },
          "The scan in the map's frame [m]: the paper's tT. A read-only view; empty unless asked for.")
      .def_prop_ro(
          "updated_map",
          [](nb::handle self) { return view_points<D>(nb::cast<const Result&>(self).updated_map, self); },
          "The map's points, then the outliers [m]: the paper's uM. A read-only view; empty unless asked for.")
      .def_prop_ro("match_indices", match_indices<D>,
                   "For each point of the scan the number of its nearest map point, -1 where there is none.",
                   nb::rv_policy::automatic)
      .def_prop_ro("match_distances", match_distances<D>, "And how far that is [m]; inf where there is none.",
                   nb::rv_policy::automatic)
      .def_prop_ro(
          "covariance", [](const Result& result) { return copy_covariance(result.uncertainty.covariance); },
          "Of the error as seen from the robot (ahead, left, heading) [m, m, rad], (3, 3). In 2D, point to line; else "
          "0.",
          nb::rv_policy::automatic)
      .def("brief", &Result::brief, "One line: stop reason, iterations, pose, inliers and outliers.")
      .def("__repr__", [](const Result& result) { return "<slamicp: " + result.brief() + ">"; });
}

}  // namespace

void bind_icp(nb::module_& m) {
  using namespace nb::literals;
  bind_result<2>(m, "IcpResult2", "What a match in the plane found: the outputs of the paper's call, eq. (10).");
  bind_result<3>(m, "IcpResult3", "What a match in space found: the outputs of the paper's call, eq. (10).");

  m.def(
      "align", align_points, "source"_a, "target"_a, "guess"_a = nb::none(), nb::kw_only(),
      "max_correspondence_distance"_a = 0.3, "outlier_distance"_a = nb::none(), "method"_a = "point_to_line",
      "max_iterations"_a = 50, "kernel"_a = "none", "kernel_scale"_a = 0.05, "final_gate"_a = 0.0,
      "guess_share"_a = 0.0,
      nb::sig("def align(source: numpy.typing.NDArray[numpy.float64], target: numpy.typing.NDArray[numpy.float64], "
              "guess: collections.abc.Sequence[float] | None = None, *, max_correspondence_distance: float = 0.3, "
              "outlier_distance: float | None = None, method: str = 'point_to_line', max_iterations: int = 50, kernel: "
              "str = 'none', kernel_scale: float = 0.05, final_gate: float = 0.0, guess_share: float = 0.0) -> "
              "IcpResult2 | IcpResult3"),
      "Registers one cloud to another by ICP: the paper's call, eq. (10), everything computed.\n\n"
      "source, target: (K, 2) or (K, 3) [m]; points that are not finite take no part.\n"
      "guess: where the source should be in the target's frame: x, y, heading; in 3D x, y, z, roll, pitch, yaw.\n"
      "max_correspondence_distance: the paper's indist [m]: a point closer to the target than this is an inlier.\n"
      "outlier_distance: the paper's O_t [m]: a point at least this far from every point of the target is an outlier;\n"
      "  default: the distance above.\n"
      "method: 'point_to_line' (in 3D the same as 'point_to_plane') or 'point_to_point'.\n"
      "kernel: 'none', 'huber', 'cauchy', 'geman_mcclure', 'tukey'; kernel_scale: where it begins to doubt [m].\n"
      "final_gate: what the solver's gate shrinks to [m]; 0: from the target's spacing.\n"
      "guess_share: how much the guess itself counts, as a share of the pairs.\n\n"
      "Makes the target's index at each call: for many scans make a Map and an Icp, or a Localizer. Releases the GIL.\n"
      "Raises Error, or TypeError for what is no array of floats.");

  nb::class_<Matcher>(m, "Icp", "Matches many scans to a Map, or several. Keeps its memory; threads take turns.")
      .def(
          "__init__",
          [](Matcher* made, double max_correspondence_distance, std::optional<double> outlier_distance,
             const std::string& method, int max_iterations, const std::string& kernel, double kernel_scale,
             double final_gate, double guess_share, double translation_tolerance, double rotation_tolerance,
             bool coarse_to_fine) {
            new (made) Matcher(options_of(max_correspondence_distance, outlier_distance, method, max_iterations, kernel,
                                          kernel_scale, final_gate, guess_share, translation_tolerance,
                                          rotation_tolerance, coarse_to_fine));
          },
          nb::kw_only(), "max_correspondence_distance"_a = 0.3, "outlier_distance"_a = nb::none(),
          "method"_a = "point_to_line", "max_iterations"_a = 50, "kernel"_a = "none", "kernel_scale"_a = 0.05,
          "final_gate"_a = 0.0, "guess_share"_a = 0.0, "translation_tolerance"_a = 1e-4, "rotation_tolerance"_a = 1e-4,
          "coarse_to_fine"_a = true, "Options as align() has them; tolerances: converged when less is left [m], [rad].")
      .def(
          "align",
          [](Matcher& matcher, const Map& map, nb::handle scan, const std::optional<nb::object>& guess, bool outliers,
             bool transformed_scan, bool updated_map, bool matches, bool covariance) {
            return matcher.align(map, scan, guess,
                                 {.mean_inlier_distance = outliers,
                                  .outlier_indices = outliers,
                                  .outliers_in_map = outliers,
                                  .transformed_scan = transformed_scan,
                                  .updated_map = updated_map,
                                  .matches = matches,
                                  .covariance = covariance});
          },
          "map"_a, "scan"_a, "guess"_a = nb::none(), nb::kw_only(), "outliers"_a = true, "transformed_scan"_a = false,
          "updated_map"_a = false, "matches"_a = false, "covariance"_a = false,
          nb::sig("def align(self, map: Map, scan: numpy.typing.NDArray[numpy.float64], guess: "
                  "collections.abc.Sequence[float] | None = None, *, outliers: bool = True, transformed_scan: bool = "
                  "False, updated_map: bool = False, matches: bool = False, covariance: bool = False) -> IcpResult2 | "
                  "IcpResult3"),
          "Matches a scan, (K, 2) or (K, 3) in the robot's frame [m], to the map. What is not asked for is not "
          "computed:\n"
          "outliers (with the mean inlier distance), transformed_scan, updated_map, matches, covariance (2D, point to\n"
          "line). Releases the GIL; takes float64 arrays in C order without a copy.");
}

}  // namespace slamicp::python
