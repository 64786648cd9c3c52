// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/registration/icp.hpp>

#include "registration/correspondences.hpp"
#include "registration/step.hpp"

namespace slamicp {
namespace {

// A robot that is lost should not make its guess worse: fewer pairs than a pose has degrees of freedom hold nothing.
template <int D>
constexpr std::size_t fewest_points = D + 1;

/// The solver's gate: wide while the pose is far off, then down to where only the wall itself is left.
class Gate {
 public:
  Gate(const IcpOptions& options, double map_spacing) noexcept
      : gate_(options.max_correspondence_distance),
        final_(options.final_gate > 0.0
                   ? options.final_gate
                   : std::min(options.max_correspondence_distance, std::max(smallest, spacings * map_spacing))) {}

  double value() const noexcept { return gate_; }
  bool is_final() const noexcept { return gate_ <= final_; }

  /// @param left  how far the scan's points may still have to move [m]
  void shrink(double left) noexcept {
    gate_ = std::max(final_, std::min(gate_, std::max(shrinkage * gate_, 3.0 * left)));
  }

 private:
  static constexpr double smallest = 0.05;  // [m], the noise of a lidar and a wall as thick as maps have them
  static constexpr double spacings = 2.5;   // of the map's points, so that a thin map is not torn from the scan
  static constexpr double shrinkage = 0.5;

  double gate_;
  double final_;
};

/// Watches the steps: how much motion is left, and whether it is little enough to stop.
template <int D>
class Convergence {
 public:
  Convergence(const IcpOptions& options, const Pose<D>& guess) noexcept
      : translation_(options.translation_tolerance),
        rotation_(options.rotation_tolerance),
        before_(guess),
        now_(guess) {}

  /// @param pose  after another step
  void step_to(const Pose<D>& pose) noexcept {
    const double step = size_of(distance(now_, pose));
    if (last_ > 0.0) ratio_ = std::min(step / last_, 0.999);
    // Back where it was two steps ago: it flips for ever between two sets of pairs, and more steps bring nothing.
    came_back_ = last_ > 0.0 && size_of(distance(before_, pose)) < 0.1;
    before_ = now_;
    now_ = pose;
    last_ = step;
  }

  /// Steps that shrink by a ratio q leave q / (1 - q) of the last one to go.
  double left_of_last_step() const noexcept { return ratio_ / (1.0 - ratio_); }
  bool reached() const noexcept { return came_back_ || last_ * left_of_last_step() < 1.0; }

 private:
  double size_of(const PoseDistance& moved) const noexcept {
    return std::max(moved.translation / translation_, moved.rotation / rotation_);
  }

  double translation_;
  double rotation_;
  double ratio_ = 0.5;  // what steps shrink by; a guess until two of them tell
  Pose<D> before_;      // two steps ago
  Pose<D> now_;
  double last_ = 0.0;  // the last step, in tolerances
  bool came_back_ = false;
};

}  // namespace

template <int D>
struct Icp<D>::State {
  IcpOptions options;
  IcpResult<D> result;
  Correspondences<D> correspondences;
  std::size_t room = 0;  // scan points to be ready for

  void forget() noexcept;
  void make_room(std::size_t map_points, const Outputs& wanted);
  void find_pose(const IndexedPoints<D>& map, PointView<D> scan, const Pose<D>& guess);
  void hand_out(const IndexedPoints<D>& map, PointView<D> scan, const Outputs& wanted);
  Match match(std::size_t i, const Point<D>& in_map) noexcept;
};

template <int D>
void Icp<D>::State::forget() noexcept {
  result.iterations = 0;
  result.pairs = result.inliers = 0;
  result.mean_inlier_distance = 0.0;
  result.outlier_indices.clear();
  result.outliers_in_map.clear();
  result.transformed_scan.clear();
  result.updated_map.clear();
  result.matches.clear();
  result.searches = result.searches_for_outputs = 0;
}

template <int D>
void Icp<D>::State::make_room(std::size_t map_points, const Outputs& wanted) {
  if (wanted.outlier_indices) result.outlier_indices.reserve(room);
  if (wanted.outliers_in_map || wanted.updated_map) result.outliers_in_map.reserve(room);
  if (wanted.transformed_scan) result.transformed_scan.reserve(room);
  if (wanted.updated_map) result.updated_map.reserve(map_points + room);
  if (wanted.matches) result.matches.reserve(room);
}

template <int D>
void Icp<D>::State::find_pose(const IndexedPoints<D>& map, PointView<D> scan, const Pose<D>& guess) {
  result.pose = guess;
  correspondences.reset(map, scan, std::max(options.max_correspondence_distance, options.outlier_threshold()));
  if (correspondences.usable_points() < fewest_points<D>) {
    result.stop = Stop::too_few_points;
    return;
  }
  Gate gate(options, map.spacing());
  Convergence<D> convergence(options, guess);
  const auto step_of = options.method == Method::point_to_point ? point_to_point_step<D> : point_to_surface_step<D>;
  while (true) {
    const Step<D> step = step_of(
        {map, scan, result.pose, gate.value(), options.kernel, options.kernel_scale, guess, options.guess_share},
        correspondences);
    result.pairs = step.pairs;
    ++result.iterations;
    if (step.pairs < fewest_points<D> || !step.pose.is_finite()) {
      result.stop = Stop::no_overlap;
      result.pose = guess;
      return;
    }
    const PoseDistance moved = distance(result.pose, step.pose);
    result.pose = step.pose;
    convergence.step_to(result.pose);
    if (convergence.reached() && gate.is_final()) {
      result.stop = step.degenerate ? Stop::degenerate : Stop::converged;
      return;
    }
    if (result.iterations == options.max_iterations) {
      result.stop = step.degenerate ? Stop::degenerate : Stop::max_iterations;
      return;
    }
    // Point to point creeps along walls, in steps that say little of what is left: its gate waits until it stands
    // still.
    if (options.method == Method::point_to_point && !convergence.reached()) continue;
    gate.shrink((moved.translation + step.reach * moved.rotation) * std::max(1.0, convergence.left_of_last_step()));
  }
}

template <int D>
Match Icp<D>::State::match(std::size_t i, const Point<D>& in_map) noexcept {
  if (!correspondences.finite(i)) return {};
  const Neighbour neighbour = correspondences.nearest(i, in_map);
  Match match{neighbour.index, std::sqrt(neighbour.squared_distance), PointClass::neither};
  // Squares, as closer_than() compares them: a point's class does not depend on which outputs were asked for.
  const auto closer_than = [&](double limit) { return neighbour.squared_distance < limit * limit; };
  const bool inlier = closer_than(options.max_correspondence_distance);
  const bool outlier = !closer_than(options.outlier_threshold());
  match.point_class = inlier && outlier ? PointClass::both
                      : inlier          ? PointClass::inlier
                      : outlier         ? PointClass::outlier
                                        : PointClass::neither;
  return match;
}

template <int D>
void Icp<D>::State::hand_out(const IndexedPoints<D>& map, PointView<D> scan, const Outputs& wanted) {
  const bool want_outliers = wanted.outlier_indices || wanted.outliers_in_map || wanted.updated_map;
  const bool want_distances = wanted.mean_inlier_distance || wanted.matches;
  if (!want_outliers && !want_distances && !wanted.transformed_scan) return;

  const Matrix<D, D> rotation = result.pose.rotation();
  const Point<D> translation = result.pose.translation();
  const bool want_points = wanted.outliers_in_map || wanted.updated_map;
  double sum = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Point<D> in_map = rotation * scan[i] + translation;
    if (wanted.transformed_scan) result.transformed_scan.push_back(in_map);
    bool outlier = false;
    if (want_distances) {
      const Match found = match(i, in_map);
      if (wanted.matches) result.matches.push_back(found);
      if (is_inlier(found.point_class)) {
        ++result.inliers;
        sum += found.distance;
      }
      outlier = is_outlier(found.point_class);
    } else if (want_outliers) {
      outlier = correspondences.finite(i) && !correspondences.closer_than(i, in_map, options.outlier_threshold());
    }
    if (!outlier) continue;
    if (wanted.outlier_indices) result.outlier_indices.push_back(static_cast<int>(i));
    if (want_points) result.outliers_in_map.push_back(in_map);
  }
  if (result.inliers > 0) result.mean_inlier_distance = sum / static_cast<double>(result.inliers);
  if (wanted.updated_map) {
    result.updated_map.assign(map.points().begin(), map.points().end());
    result.updated_map.insert(result.updated_map.end(), result.outliers_in_map.begin(), result.outliers_in_map.end());
    if (!wanted.outliers_in_map) result.outliers_in_map.clear();
  }
}

template <int D>
Icp<D>::Icp(const IcpOptions& options) : state_(std::make_unique<State>()) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "IcpOptions");
  state_->options = options;
}

template <int D>
Icp<D>::~Icp() = default;
template <int D>
Icp<D>::Icp(Icp&&) noexcept = default;
template <int D>
Icp<D>& Icp<D>::operator=(Icp&&) noexcept = default;

template <int D>
const IcpResult<D>& Icp<D>::align(const IndexedPoints<D>& map, PointView<D> scan, const Pose<D>& guess,
                                  const Outputs& wanted) {
  if (!guess.is_finite())
    throw Error("the guess is not finite", "Icp::align", "give the last known pose, or set one where the robot starts");
  if (state_->options.method != Method::point_to_point && map.size() > 0 && !map.has_surfaces())
    throw Error("the map has no surfaces", "Icp::align",
                "build it with SurfaceOptions::neighbours above 0, or use Method::point_to_point");
  state_->forget();
  state_->room = std::max(state_->room, scan.size());
  state_->make_room(map.size(), wanted);
  state_->find_pose(map, scan, guess * Pose<D>{});  // angles leave the library in (-pi, pi], the guess's too
  state_->result.searches = state_->correspondences.searches();
  state_->hand_out(map, scan, wanted);
  state_->result.searches_for_outputs = state_->correspondences.searches() - state_->result.searches;
  return state_->result;
}

template <int D>
void Icp<D>::reserve(std::size_t points) {
  state_->room = std::max(state_->room, points);
  state_->correspondences.reserve(points);
}

template <int D>
const IcpResult<D>& Icp<D>::result() const noexcept {
  return state_->result;
}

template <int D>
const IcpOptions& Icp<D>::options() const noexcept {
  return state_->options;
}

template <int D>
IcpResult<D> align(const PointCloud<D>& source, const PointCloud<D>& target, const Pose<D>& guess,
                   const IcpOptions& options, const Outputs& wanted) {
  Icp<D> icp(options);
  SurfaceOptions surfaces;
  if (options.method == Method::point_to_point) surfaces.neighbours = 0;
  return icp.align(IndexedPoints<D>(target, surfaces), source, guess, wanted);
}

template class Icp<2>;
template class Icp<3>;
template IcpResult<2> align(const PointCloud<2>&, const PointCloud<2>&, const Pose<2>&, const IcpOptions&,
                            const Outputs&);
template IcpResult<3> align(const PointCloud<3>&, const PointCloud<3>&, const Pose<3>&, const IcpOptions&,
                            const Outputs&);

}  // namespace slamicp
