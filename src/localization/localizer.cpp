// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Eigenvalues>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/registration/icp.hpp>

#include "localization/judge.hpp"
#include "localization/pose_belief.hpp"
#include "localization/prediction.hpp"
#include "localization/slide.hpp"

namespace slamicp {

IcpOptions LocalizerOptions::icp() const noexcept {
  IcpOptions icp;
  icp.method = method;
  icp.max_correspondence_distance = max_correspondence_distance;
  icp.outlier_distance = outlier_distance;
  icp.obstacle_distance = obstacle_distance;
  icp.max_iterations = max_iterations;
  icp.kernel = kernel;
  icp.kernel_scale = kernel_scale;
  icp.guess_share = guess_share;
  icp.final_gate = final_gate;
  icp.noise = noise;
  return icp;
}

std::string LocalizerOptions::problem() const {
  if (!(ranges.min_range >= 0.0)) return "ranges.min_range must be at least 0 m";
  if (!(ranges.max_range > ranges.min_range)) return "ranges.max_range must be above ranges.min_range";
  if (const std::string in_prediction = prediction.problem(); !in_prediction.empty())
    return "prediction: " + in_prediction;
  if (const std::string in_quality = quality.problem(); !in_quality.empty()) return "quality: " + in_quality;
  if (const std::string in_search = search.problem(); !in_search.empty()) return "search: " + in_search;
  return icp().problem();
}

namespace {

/// From the first scan's stamp to half way through what the lasers sweep, on average [s].
double half_of(std::span<const LaserScan> scans) noexcept {
  double sum = 0.0;
  for (const LaserScan& scan : scans) sum += scan.stamp - scans.front().stamp + 0.5 * sweep_time(scan);
  return sum / static_cast<double>(scans.size());
}

/// How the scan's rays lie; those of joined scans count as the first one's.
Rays rays_of(const LaserScan& scan) noexcept {
  Rays rays;
  const double spacing = std::abs(scan.angle_increment);
  if (spacing > 1e-6 && spacing < 1.0) rays.spacing = spacing;
  if (is_finite<2>(scan.T_robot_laser.translation())) rays.origin = scan.T_robot_laser.translation();
  return rays;
}

}  // namespace

struct Localizer::State {
  explicit State(const LocalizerOptions& chosen)
      : options(chosen),
        icp(chosen.icp()),
        prediction(chosen.use_odometry),
        belief(chosen.prediction),
        judge_of_pose(chosen.quality) {
    forget();
  }

  LocalizerOptions options;
  Icp<2> icp;
  Prediction prediction;
  PoseBelief belief;
  Judge judge_of_pose;
  std::optional<LocalSearch> search;  // where one is under way ...
  Pose2 moved;                        // ... the motion since its scan
  Pose2 trusted;                      // the last pose that was not doubted, moved on by odometry
  PosePrior prior;                    // the prediction, where it takes part
  PointMap2::Pointer map;             // null until the first scan in scan-to-scan mode
  bool scan_to_scan = false;
  std::vector<ScanProjector> projectors;  // one for each of the scans that are joined
  Fix fix;

  bool fuses() const noexcept {
    return options.outputs.covariance && options.method == Method::point_to_line && !scan_to_scan;
  }
  void forget() noexcept;
  void match(std::span<const LaserScan> scans);
  void predict(const LaserScan& first, const Pose2& motion) noexcept;
  void judge(const LaserScan& first) noexcept;
  double surprise() const noexcept;
  void doubt() noexcept;
  bool recover(int budget);
  bool lies_along(const Vector<2>& direction) const noexcept;
  void look_along_blind_direction();
  void look_nearer(bool by_odometry);
  void project(std::span<const LaserScan> scans, const Velocity& velocity);
  SweepMotion sweep_of(const LaserScan& scan, const LaserScan& first, const Velocity& velocity) const noexcept;
  bool worth_another_look(std::span<const LaserScan> scans, const Velocity& before, const Velocity& now) const noexcept;
  void align_to_map(const Pose2& guess);
  void take(const IcpResult2& result);
  void take_scan_as_map();
};

void Localizer::State::match(std::span<const LaserScan> scans) {
  const LaserScan& first = scans.front();
  fix.stamp = first.stamp;
  const Pose2 motion = prediction.motion_until(first);
  moved = moved * motion;
  if (prediction.is_by_odometry(first)) trusted = trusted * motion;
  const Pose2 predicted = fix.pose * motion;
  fix.predicted = predicted.is_finite() ? predicted : fix.pose;  // odometry may tell tales
  predict(first, motion);
  Velocity velocity = prediction.velocity_at(first, motion);
  const double half = half_of(scans);
  project(scans, velocity);
  if (map) {
    fix.map = map;
    align_to_map(fix.predicted);
    if (fuses()) {
      look_nearer(prediction.is_by_odometry(first));
      look_along_blind_direction();
    }
    if (fix.match.usable()) {
      const Pose2 middle = fix.match.pose * velocity.over(half);
      const Velocity measured = prediction.velocity_at(first, prediction.motion_to(middle));
      if (worth_another_look(scans, velocity, measured)) {
        velocity = measured;
        project(scans, velocity);
        align_to_map(middle * velocity.over(-half));
      }
    }
    fix.pose =
        fix.match.stop == Stop::too_few_points || fix.match.stop == Stop::no_overlap ? fix.predicted : fix.match.pose;
    if (options.outputs.covariance) judge(first);
    doubt();
  }
  prediction.remember(first, fix.pose * velocity.over(half));
  if (scan_to_scan) take_scan_as_map();
}

void Localizer::State::forget() noexcept {
  // Who sets a pose knows it to about where a match would find it.
  belief.forget(options.max_correspondence_distance / 3.0, 0.1);
  prediction.forget();
  judge_of_pose.forget();
  trusted = fix.pose;
}

void Localizer::State::predict(const LaserScan& first, const Pose2& motion) noexcept {
  prior = {};
  if (!fuses()) return;
  if (prediction.is_by_odometry(first))
    belief.move_by_odometry(motion);
  else if (prediction.has_last())
    belief.move_by_velocity(motion);
  prior = belief.prior(fix.predicted);
  icp.set_rays(rays_of(first));
}

/// How sure the fix is, and what it follows where the scan does not hold it.
void Localizer::State::judge(const LaserScan& first) noexcept {
  const Uncertainty& match = fix.match.uncertainty;
  fix.carried_by = Carrier::scan;
  fix.blind_direction.setZero();
  if (match.blind || !match.known)
    fix.carried_by = prediction.is_by_odometry(first) ? Carrier::odometry : Carrier::velocity;
  if (match.blind) fix.blind_direction = fix.pose.rotation() * match.weakest;
  // Scan and wheels together hold every direction: that is a pose.
  if (fix.match.stop == Stop::degenerate && match.blind && fix.carried_by == Carrier::odometry)
    fix.match.stop = Stop::converged;
  if (!fuses()) {
    fix.covariance = match.covariance;
    return;
  }
  belief.fuse(match, prior, fix.pose.theta);
  fix.covariance = belief.covariance();
  if (!match.blind) return;
  // Along a direction that is a little off, the way is a shift to the side too.
  const double along2 = match.weakest.dot(fix.covariance.topLeftCorner<2, 2>() * match.weakest);
  const Vector<2> aside(-match.weakest.y(), match.weakest.x());
  fix.covariance.topLeftCorner<2, 2>() += match.tilt_sigma * match.tilt_sigma * along2 * aside * aside.transpose();
  fix.covariance(2, 2) += match.twist_sigma * match.twist_sigma * along2;
}

/// How likely a match that contradicts the prediction has taken the robot elsewhere: the farther it went, the likelier.
double Localizer::State::surprise() const noexcept {
  constexpr double far = 0.15;                // [m]
  constexpr double wide = 5.0 * rad_per_deg;  // [rad]
  if (!(fix.match.uncertainty.surprise >= Uncertainty::credible)) return 0.0;
  const PoseDistance off = distance(fix.pose, fix.predicted);
  return std::min(1.0, std::max(off.translation / far, off.rotation / wide));
}

/// Whether the pose is right at all.
void Localizer::State::doubt() noexcept {
  if (options.quality.rays == 0 || scan_to_scan) return;
  const IndexedPoints<2>& points = map->indexed();
  const bool matched = fix.match.usable() || fix.match.stop == Stop::degenerate;
  const double range_noise =
      fix.match.uncertainty.known ? fix.match.uncertainty.range_noise : std::max(options.noise.range, 0.01);
  const double noise = std::hypot(range_noise, points.line_noise().across);
  const Evidence evidence = look(points, {fix.scan, fix.ray_origins, fix.pose}, options.quality.rays,
                                 options.max_correspondence_distance, noise);
  const bool held = fix.match.stop != Stop::degenerate && fix.blind_direction.isZero();
  fix.quality = judge_of_pose.update(evidence, matched, held, surprise());
  if (!fix.quality.doubted()) trusted = fix.pose;
}

bool Localizer::State::recover(int budget) {
  if (!fix.quality.doubted())
    search.reset();
  else if (!search && map && !fix.scan.in_robot.empty()) {
    search.emplace(map, fix.scan, fix.ray_origins.front(), trusted, options.icp(), options.search);
    moved = {};
  }
  if (!search || !search->step(budget)) return false;
  const std::optional<FoundPlace> found = search->found();
  search.reset();
  if (!found || !found->unique || found->probability < options.quality.suspect_below) return false;
  fix.pose = found->pose * moved;
  forget();
  return true;
}

/// What stands before the walls may pull a match away from them. One that ends where it was not to be expected, or
/// whose pairs pull against each other, is tried again in a narrower gate, nearer to the prediction.
void Localizer::State::look_nearer(bool by_odometry) {
  constexpr double credible = 25.0;                        // squared, in standard deviations
  constexpr double gate = 0.1;                             // [m]
  constexpr double as_expected = 3e-3, usual_range = 3.0;  // [m]
  const Uncertainty& match = fix.match.uncertainty;
  if (!match.known || match.blind || (match.surprise < credible && !match.contradicts_itself())) return;
  // One that ends where it was expected would end there again.
  const PoseDistance off = distance(fix.match.pose, fix.predicted);
  if (off.translation + usual_range * off.rotation < as_expected) return;
  PosePrior near_by = prior;
  near_by.first_gate = std::min(gate, options.max_correspondence_distance);
  const IcpResult2& near = icp.align(map->indexed(), fix.scan.in_robot, fix.predicted, options.outputs, near_by);
  // Wheels have a say of their own.
  const double enough = (by_odometry ? 0.9 : 1.0) * static_cast<double>(fix.match.pairs);
  if (near.usable() && static_cast<double>(near.pairs) >= enough) take(near);
}

/// True where the match is as the prediction would have it but for a way in that direction, which is known to a degree:
/// how far the way may be off to the side, the prediction's noise does not say.
bool Localizer::State::lies_along(const Vector<2>& direction) const noexcept {
  if (fix.match.uncertainty.surprise <= Uncertainty::credible) return true;
  constexpr double aside = 0.03;              // [m]
  constexpr double tilt = 1.0 * rad_per_deg;  // [rad]
  const Vector<2> way = fix.match.pose.translation() - fix.predicted.translation();
  return std::abs(cross(direction, way)) <= aside + tilt * std::abs(direction.dot(way)) &&
         std::abs(wrap_angle(fix.match.pose.theta - fix.predicted.theta)) <= tilt;
}

/// Where the position may be far off in some direction, what has no match here may have one further along. If so, the
/// match starts again there.
void Localizer::State::look_along_blind_direction() {
  const Eigen::Matrix2d covariance = belief.covariance().topLeftCorner<2, 2>();
  const double enough = options.max_correspondence_distance / 3.0;
  if (!(covariance.trace() > 4.0 * enough * enough) || !fix.match.uncertainty.known) return;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(covariance);
  const Vector<2> direction = fix.match.pose.rotation() * eigen.eigenvectors().col(1);
  const Slide slide(*map, fix.scan.in_robot, fix.match.pose, options.max_correspondence_distance);
  const auto shift = slide.best_shift(direction, 3.0 * std::sqrt(eigen.eigenvalues()[1]));
  if (!shift) return;
  Pose2 start = fix.match.pose;
  start.x += *shift * direction.x();
  start.y += *shift * direction.y();
  align_to_map(start);
  if (fix.match.stop == Stop::converged && lies_along(direction)) return;
  align_to_map(fix.predicted);
}

/// The points of all scans, where they are as seen from the robot at the first one's stamp.
void Localizer::State::project(std::span<const LaserScan> scans, const Velocity& velocity) {
  if (projectors.size() < scans.size()) projectors.resize(scans.size());
  fix.scan.in_robot.clear();
  fix.scan.beams.clear();
  fix.scan.scans.clear();
  fix.ray_origins.clear();
  std::size_t most = 0;
  for (const LaserScan& scan : scans) {
    most += scan.ranges.size();
    fix.ray_origins.push_back(scan.T_robot_laser.translation());
  }
  fix.scan.in_robot.reserve(most);
  fix.scan.beams.reserve(most);
  icp.reserve(most);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    projectors[k].append(scans[k], options.ranges, sweep_of(scans[k], scans.front(), velocity), fix.scan);
    if (scans.size() > 1) fix.scan.scans.resize(fix.scan.in_robot.size(), static_cast<int>(k));
  }
}

SweepMotion Localizer::State::sweep_of(const LaserScan& scan, const LaserScan& first,
                                       const Velocity& velocity) const noexcept {
  SweepMotion motion;
  if (&scan != &first) {
    const bool by_wheels = prediction.has_odometry(scan) && prediction.has_odometry(first);
    motion.T_start_first =
        by_wheels ? first.T_odom_robot->inverse() * *scan.T_odom_robot : velocity.over(scan.stamp - first.stamp);
  }
  if (!options.deskew || scan.time_increment == 0.0) return motion;
  const Pose2* const by_wheels = prediction.sweep_motion(scan);
  motion.T_first_last = by_wheels != nullptr ? *by_wheels : velocity.over(sweep_time(scan));
  return motion;
}

/// Whether points would move by more than a millimetre, ten metres away, now that the match has told how fast the robot
/// really goes. Wheels are believed.
bool Localizer::State::worth_another_look(std::span<const LaserScan> scans, const Velocity& before,
                                          const Velocity& now) const noexcept {
  constexpr double most = 1e-3;
  constexpr double reach = 10.0;
  if (prediction.has_odometry(scans.front())) return false;
  for (const LaserScan& scan : scans) {
    const SweepMotion was = sweep_of(scan, scans.front(), before);
    const SweepMotion is = sweep_of(scan, scans.front(), now);
    const PoseDistance shift = distance(was.T_start_first * was.T_first_last, is.T_start_first * is.T_first_last);
    if (shift.translation + reach * shift.rotation > most) return true;
  }
  return false;
}

void Localizer::State::align_to_map(const Pose2& guess) {
  take(icp.align(map->indexed(), fix.scan.in_robot, guess, options.outputs, prior));
}

void Localizer::State::take(const IcpResult2& result) {
  // The copy gets as much room as the original: a scan with more outliers than those before allocates nothing.
  fix.match.outlier_indices.reserve(result.outlier_indices.capacity());
  fix.match.outliers_in_map.reserve(result.outliers_in_map.capacity());
  fix.match.transformed_scan.reserve(result.transformed_scan.capacity());
  fix.match.updated_map.reserve(result.updated_map.capacity());
  fix.match.matches.reserve(result.matches.capacity());
  fix.match.stray_indices.reserve(result.stray_indices.capacity());
  fix.match = result;
}

void Localizer::State::take_scan_as_map() {
  PointCloud2 in_map;
  in_map.reserve(fix.scan.in_robot.size());
  for (const Point2& point : fix.scan.in_robot)
    if (is_finite<2>(fix.pose * point)) in_map.push_back(fix.pose * point);
  if (in_map.empty()) return;
  const bool is_first = map == nullptr;
  // A map for one scan: its cells would cost more than they save.
  map = PointMap2::create(std::move(in_map), SurfaceOptions::sparse(), {.eager = false});
  if (!is_first) return;
  // The first scan defines the map: it fits itself where it was told to stand.
  fix.map = map;
  align_to_map(fix.pose);
  fix.pose = fix.predicted;
}

Localizer::Localizer(const LocalizerOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "LocalizerOptions");
  state_ = std::make_unique<State>(options);
  state_->scan_to_scan = true;
}

Localizer::Localizer(PointMap2::Pointer map, const LocalizerOptions& options) : Localizer(options) {
  set_map(std::move(map));
}

Localizer::~Localizer() = default;
Localizer::Localizer(Localizer&&) noexcept = default;
Localizer& Localizer::operator=(Localizer&&) noexcept = default;

void Localizer::set_pose(const Pose2& pose) {
  if (!pose.is_finite())
    throw Error("the pose is not finite", "Localizer::set_pose", "give x [m], y [m], heading [rad]");
  state_->fix.pose = {pose.x, pose.y, wrap_angle(pose.theta)};
  state_->forget();
}

void Localizer::set_map(PointMap2::Pointer map) {
  if (!map) throw Error("the map is null", "Localizer::set_map", "make one with PointMap2::create, or load_map");
  if (state_->options.method != Method::point_to_point && !map->indexed().has_surfaces())
    throw Error("the map has no surfaces", "Localizer::set_map",
                "build it with SurfaceOptions::neighbours above 0, or use Method::point_to_point");
  state_->map = std::move(map);
  state_->scan_to_scan = false;
}

const PointMap2::Pointer& Localizer::map() const noexcept { return state_->map; }

const Fix& Localizer::update(const LaserScan& scan) noexcept { return update({&scan, 1}); }

const Fix& Localizer::update(std::span<const LaserScan> scans) noexcept {
  if (!scans.empty()) state_->match(scans);
  return state_->fix;
}

bool Localizer::recover(int budget) { return state_->recover(budget); }

const Fix& Localizer::fix() const noexcept { return state_->fix; }
const LocalizerOptions& Localizer::options() const noexcept { return state_->options; }

}  // namespace slamicp
