// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/registration/icp.hpp>

#include "registration/correspondences.hpp"
#include "registration/prior_fusion.hpp"
#include "registration/schedule.hpp"
#include "registration/step.hpp"
#include "registration/vector_match.hpp"

namespace slamicp {
namespace {

// A robot that is lost should not make its guess worse: fewer pairs than a pose has degrees of freedom hold nothing.
template <int D>
constexpr std::size_t fewest_points = D + 1;

PointClass class_of(bool is_inlier, bool is_outlier) noexcept {
  return is_inlier && is_outlier ? PointClass::both
         : is_inlier             ? PointClass::inlier
         : is_outlier            ? PointClass::outlier
                                 : PointClass::neither;
}

}  // namespace

template <int D>
struct Icp<D>::State {
  explicit State(const IcpOptions& chosen) : options(chosen), vector_match(passes_of(chosen.instruction_set)) {}

  IcpOptions options;
  IcpResult<D> result;
  Correspondences<D> correspondences;  // the match one point at a time
  VectorMatch vector_match;            // the match many points at a time, in the plane
  std::size_t room = 0;                // scan points to be ready for
  Rays rays;

  bool is_vectorized() const noexcept { return D == 2 && vector_match.exists(); }
  std::optional<NoiseModel> noise_model(const IndexedPoints<D>& map, bool wanted) const noexcept;
  std::size_t begin(const IndexedPoints<D>& map, PointView<D> scan);
  Step<D> step(const StepInput<D>& input) noexcept;
  std::size_t searches() const noexcept;

  void forget() noexcept;
  void make_room(std::size_t map_points, const Outputs& wanted);
  void find_pose(const IndexedPoints<D>& map, PointView<D> scan, const Pose<D>& guess, const NoiseModel* noise,
                 bool has_prior, double widest_gate);
  void judge(const IndexedPoints<D>& map, PointView<D> scan, const NoiseModel& noise, const PosePrior& prior,
             const Pose<D>& guess);
  void hand_out(const IndexedPoints<D>& map, PointView<D> scan, const Outputs& wanted);
  void match_all(PointView<D> scan, const Outputs& wanted, bool want_outliers);
  void find_far_points(PointView<D> scan, double threshold, std::vector<int>& indices);
  double obstacle_distance(const IndexedPoints<D>& map) const noexcept;
  double stray_distance() const noexcept { return IcpResult<D>::stray_share * result.obstacle_distance; }
};

template <int D>
void Icp<D>::State::forget() noexcept {
  result.iterations = 0;
  result.pairs = result.inliers = 0;
  result.mean_inlier_distance = 0.0;
  result.outlier_indices.clear();
  result.outliers_in_map.clear();
  result.updated_map.clear();
  result.stray_indices.clear();
  result.obstacle_distance = 0.0;
  result.searches = result.searches_for_outputs = 0;
  result.uncertainty = {};
}

template <int D>
void Icp<D>::State::make_room(std::size_t map_points, const Outputs& wanted) {
  if (wanted.outlier_indices || wanted.outliers_in_map || wanted.updated_map) result.outlier_indices.reserve(room);
  if (wanted.outliers_in_map || wanted.updated_map) result.outliers_in_map.reserve(room);
  if (wanted.transformed_scan) result.transformed_scan.reserve(room);
  if (wanted.updated_map) result.updated_map.reserve(map_points + room);
  if (wanted.matches) result.matches.reserve(room);
  if (wanted.strays) result.stray_indices.reserve(room);
}

/// What the noise of the pairs is made of, where it is wanted and known: in the plane, point to line.
template <int D>
std::optional<NoiseModel> Icp<D>::State::noise_model(const IndexedPoints<D>& map, bool wanted) const noexcept {
  if constexpr (D == 2) {
    if (!wanted || options.method == Method::point_to_point) return {};
    const LineNoise& found = map.line_noise();
    return NoiseModel{options.noise, options.noise.map > 0.0 ? found.with(options.noise.map) : found, rays};
  }
  return {};
}

/// Takes up a scan. Returns how many of its points are numbers.
template <int D>
std::size_t Icp<D>::State::begin(const IndexedPoints<D>& map, PointView<D> scan) {
  if constexpr (D == 2)
    if (is_vectorized()) return vector_match.begin(map.cells(), scan);
  correspondences.reset(map, scan,
                        std::max({options.max_correspondence_distance, options.outlier_threshold(),
                                  options.obstacle_distance.value_or(0.0)}));
  return correspondences.usable_points();
}

template <int D>
Step<D> Icp<D>::State::step(const StepInput<D>& input) noexcept {
  const bool by_points = options.method == Method::point_to_point;
  if constexpr (D == 2)
    if (is_vectorized())
      return by_points ? vector_match.point_to_point_step(input) : vector_match.point_to_surface_step(input);
  return by_points ? point_to_point_step<D>(input, correspondences) : point_to_surface_step<D>(input, correspondences);
}

template <int D>
std::size_t Icp<D>::State::searches() const noexcept {
  return is_vectorized() ? vector_match.searches() : correspondences.searches();
}

template <int D>
void Icp<D>::State::find_pose(const IndexedPoints<D>& map, PointView<D> scan, const Pose<D>& guess,
                              const NoiseModel* noise, bool has_prior, double widest_gate) {
  result.pose = guess;
  if (begin(map, scan) < fewest_points<D>) {
    result.stop = Stop::too_few_points;
    return;
  }
  Gate gate(options, map.spacing(), widest_gate);
  Convergence<D> convergence(options, guess);
  Stride stride(D == 2 && options.coarse_to_fine ? scan.size() : 0);
  constexpr double nearly_there = 3e-3;  // [m]: after such a step the next one is mostly the last
  double shift = 1.0;
  while (true) {
    const bool is_last = shift < nearly_there && gate.is_final() && stride.is_final();
    const Step<D> step =
        this->step({map, scan, stride.value(), result.pose, gate.value(), options.kernel, options.kernel_scale, guess,
                    options.guess_share, is_last ? noise : nullptr, nullptr});
    result.pairs = step.pairs;
    result.uncertainty = step.uncertainty;
    ++result.iterations;
    if (step.pairs < fewest_points<D> || !step.pose.is_finite()) {
      result.stop = Stop::no_overlap;
      result.pose = guess;
      result.uncertainty = {};
      return;
    }
    if (step.uncertainty.blind && has_prior) {
      result.stop = Stop::degenerate;  // more steps would follow the noise: see fuse()
      return;
    }
    const PoseDistance moved = distance(result.pose, step.pose);
    result.pose = step.pose;
    convergence.step_to(result.pose);
    if (convergence.reached() && gate.is_final() && stride.is_final()) {
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
    shift = moved.translation + step.reach * moved.rotation;
    gate.shrink(shift * std::max(1.0, convergence.left_of_last_step()));
    stride.refine(shift);
  }
}

/// How well the pairs hold the pose, and takes in what was known before. Where they hold it they have found it, and the
/// prior moves it in one step; in a direction that they do not hold, where they have followed the noise, it is found
/// anew.
template <int D>
void Icp<D>::State::judge(const IndexedPoints<D>& map, PointView<D> scan, const NoiseModel& noise,
                          const PosePrior& prior, const Pose<D>& guess) {
  if constexpr (D == 2) {
    if (result.stop == Stop::no_overlap || result.stop == Stop::too_few_points) return;
    constexpr int most_steps = 10;
    const double gate = Gate(options, map.spacing(), 0.0).last();
    const auto step_from = [&](const Pose2& pose, const PosePrior* with) {
      return step(
          {map, scan, 1, pose, gate, options.kernel, options.kernel_scale, guess, options.guess_share, &noise, with});
    };
    if (!result.uncertainty.known) result.uncertainty = step_from(result.pose, nullptr).uncertainty;
    if (!result.uncertainty.known || !prior.given()) return;
    const double share = static_cast<double>(result.pairs) / static_cast<double>(scan.size());
    if (!result.uncertainty.blind) {
      result.uncertainty.surprise = surprise(result.uncertainty, prior, result.pose);
      doubt_contradiction(share, result.uncertainty);
      result.pose = result.pose * Pose2::exp(motion_by_prior(result.uncertainty, prior, result.pose));
      return;
    }
    Convergence<2> convergence(options, result.pose);
    for (int k = 0; k < most_steps && !(k > 0 && convergence.reached()); ++k) {
      const Step<2> next = step_from(result.pose, &prior);
      if (next.pairs < fewest_points<2> || !next.pose.is_finite()) break;
      result.pose = next.pose;
      result.pairs = next.pairs;
      result.uncertainty = next.uncertainty;
      ++result.iterations;
      convergence.step_to(result.pose);
    }
    result.uncertainty.surprise = surprise(result.uncertainty, prior, result.pose);
    if (doubt_contradiction(share, result.uncertainty))
      result.pose = result.pose * Pose2::exp(motion_by_prior(result.uncertainty, prior, result.pose));
    result.stop = result.uncertainty.blind ? Stop::degenerate : Stop::converged;
  }
}

/// How far from the map something stands that is no noise.
template <int D>
double Icp<D>::State::obstacle_distance(const IndexedPoints<D>& map) const noexcept {
  if (options.obstacle_distance) return *options.obstacle_distance;
  constexpr double usual_range = 0.01;  // [m]
  constexpr double least = 0.05;        // [m], what maps are off for other reasons than noise
  constexpr double sigmas = 4.0;
  double range = options.noise.range > 0.0 ? options.noise.range : usual_range;
  double across = options.noise.map;
  if constexpr (D == 2) {
    if (result.uncertainty.known) range = result.uncertainty.range_noise;
    if (!(across > 0.0)) across = map.line_noise().across;
  }
  return std::min(std::max(sigmas * std::hypot(range, across), least), options.outlier_threshold());
}

/// The nearest map point of every scan point: matches, their mean distance, and the outliers if wanted.
template <int D>
void Icp<D>::State::match_all(PointView<D> scan, const Outputs& wanted, bool want_outliers) {
  const RigidTransform<D> T_map_robot(result.pose);
  if constexpr (D == 2)
    if (is_vectorized())
      vector_match.find_matches(
          result.pose, std::max({options.max_correspondence_distance, options.outlier_threshold(), stray_distance()}));
  const auto nearest = [&](std::size_t i) -> std::pair<Neighbour, double> {
    if constexpr (D == 2)
      if (is_vectorized()) return vector_match.match(i, result.pose);
    const Neighbour found = correspondences.nearest(i, T_map_robot * scan[i]);
    return {found, std::sqrt(found.squared_distance)};
  };
  const double inlier2 = options.max_correspondence_distance * options.max_correspondence_distance;
  const double outlier2 = options.outlier_threshold() * options.outlier_threshold();
  const double stray2 = stray_distance() * stray_distance();
  double sum = 0.0;
  std::size_t inliers = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    Match match;
    if (is_finite<D>(scan[i])) {
      const auto [neighbour, distance] = nearest(i);
      // Squares, as every path compares them: a point's class does not depend on which outputs were asked for.
      const bool is_inlier = neighbour.squared_distance < inlier2;
      const bool is_outlier = !(neighbour.squared_distance < outlier2);
      match = {neighbour.index, distance, class_of(is_inlier, is_outlier)};
      inliers += is_inlier ? 1U : 0U;
      sum += is_inlier ? match.distance : 0.0;
      if (is_outlier && want_outliers) result.outlier_indices.push_back(static_cast<int>(i));
      if (wanted.strays && !(neighbour.squared_distance < stray2)) result.stray_indices.push_back(static_cast<int>(i));
    }
    if (wanted.matches) result.matches[i] = match;
  }
  result.inliers = inliers;
  if (inliers > 0) result.mean_inlier_distance = sum / static_cast<double>(inliers);
}

template <int D>
void Icp<D>::State::find_far_points(PointView<D> scan, double threshold, std::vector<int>& indices) {
  if constexpr (D == 2)
    if (is_vectorized()) return vector_match.find_outliers(result.pose, threshold, indices);
  const RigidTransform<D> T_map_robot(result.pose);
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (correspondences.finite(i) && !correspondences.closer_than(i, T_map_robot * scan[i], threshold))
      indices.push_back(static_cast<int>(i));
}

template <int D>
void Icp<D>::State::hand_out(const IndexedPoints<D>& map, PointView<D> scan, const Outputs& wanted) {
  const bool want_outliers = wanted.outlier_indices || wanted.outliers_in_map || wanted.updated_map;
  result.matches.resize(wanted.matches ? scan.size() : 0);
  result.transformed_scan.resize(wanted.transformed_scan ? scan.size() : 0);
  if (wanted.strays) result.obstacle_distance = obstacle_distance(map);
  if (wanted.mean_inlier_distance || wanted.matches) {
    match_all(scan, wanted, want_outliers);
  } else {
    if (want_outliers) find_far_points(scan, options.outlier_threshold(), result.outlier_indices);
    if (wanted.strays) find_far_points(scan, stray_distance(), result.stray_indices);
  }

  const RigidTransform<D> T_map_robot(result.pose);
  for (std::size_t i = 0; i < result.transformed_scan.size(); ++i) result.transformed_scan[i] = T_map_robot * scan[i];
  if (wanted.outliers_in_map || wanted.updated_map)
    for (const int i : result.outlier_indices)
      result.outliers_in_map.push_back(T_map_robot * scan[static_cast<std::size_t>(i)]);
  if (wanted.updated_map) {
    result.updated_map.assign(map.points().begin(), map.points().end());
    result.updated_map.insert(result.updated_map.end(), result.outliers_in_map.begin(), result.outliers_in_map.end());
  }
  if (!wanted.outlier_indices) result.outlier_indices.clear();
  if (!wanted.outliers_in_map) result.outliers_in_map.clear();
}

template <int D>
Icp<D>::Icp(const IcpOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "IcpOptions");
  state_ = std::make_unique<State>(options);
}

template <int D>
Icp<D>::~Icp() = default;
template <int D>
Icp<D>::Icp(Icp&&) noexcept = default;
template <int D>
Icp<D>& Icp<D>::operator=(Icp&&) noexcept = default;

template <int D>
const IcpResult<D>& Icp<D>::align(const IndexedPoints<D>& map, PointView<D> scan, const Pose<D>& guess,
                                  const Outputs& wanted, const PosePrior& prior) {
  if (!guess.is_finite())
    throw Error("the guess is not finite", "Icp::align", "give the last known pose, or set one where the robot starts");
  if (state_->options.method != Method::point_to_point && map.size() > 0 && !map.has_surfaces())
    throw Error("the map has no surfaces", "Icp::align",
                "build it with SurfaceOptions::neighbours above 0, or use Method::point_to_point");
  state_->forget();
  state_->room = std::max(state_->room, scan.size());
  state_->make_room(map.size(), wanted);
  const std::optional<NoiseModel> noise = state_->noise_model(map, wanted.covariance || prior.given());
  // Angles leave the library in (-pi, pi], the guess's too.
  const Pose<D> start = guess * Pose<D>{};
  state_->find_pose(map, scan, start, noise ? &*noise : nullptr, prior.given(), first_gate(state_->options, prior));
  state_->result.searches = state_->searches();
  if (noise) state_->judge(map, scan, *noise, prior, start);
  state_->hand_out(map, scan, wanted);
  state_->result.searches_for_outputs = state_->searches() - state_->result.searches;
  return state_->result;
}

template <int D>
void Icp<D>::set_rays(const Rays& rays) noexcept {
  state_->rays = rays;
}

template <int D>
void Icp<D>::reserve(std::size_t points) {
  state_->room = std::max(state_->room, points);
  if (state_->is_vectorized())
    state_->vector_match.reserve(points);
  else
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
  SurfaceOptions surfaces = SurfaceOptions::sparse();
  if (options.method == Method::point_to_point) surfaces.neighbours = 0;
  if constexpr (D == 2)
    return icp.align(IndexedPoints<D>(target, surfaces, {.eager = false}), source, guess, wanted);  // one match only
  else
    return icp.align(IndexedPoints<D>(target, surfaces), source, guess, wanted);
}

template class Icp<2>;
template class Icp<3>;
template IcpResult<2> align(const PointCloud<2>&, const PointCloud<2>&, const Pose<2>&, const IcpOptions&,
                            const Outputs&);
template IcpResult<3> align(const PointCloud<3>&, const PointCloud<3>&, const Pose<3>&, const IcpOptions&,
                            const Outputs&);

}  // namespace slamicp
