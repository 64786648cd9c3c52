// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/registration/icp.hpp>

namespace slamicp {

IcpOptions LocalizerOptions::icp() const noexcept {
  IcpOptions icp;
  icp.method = method;
  icp.max_correspondence_distance = max_correspondence_distance;
  icp.outlier_distance = outlier_distance;
  icp.max_iterations = max_iterations;
  icp.kernel = kernel;
  icp.kernel_scale = kernel_scale;
  icp.guess_share = guess_share;
  icp.final_gate = final_gate;
  return icp;
}

std::string LocalizerOptions::problem() const {
  if (!(ranges.min_range >= 0.0)) return "ranges.min_range must be at least 0 m";
  if (!(ranges.max_range > ranges.min_range)) return "ranges.max_range must be above ranges.min_range";
  return icp().problem();
}

namespace {

/// Where the robot has got to since its last pose.
class Prediction {
 public:
  void forget() noexcept { has_last_ = has_velocity_ = false; }

  Pose2 motion_until(const LaserScan& scan) const noexcept {
    if (!has_last_) return {};
    if (last_odometry_ && odometry_of(scan)) return last_odometry_->inverse() * *scan.T_odom_robot;
    return has_velocity_ ? interpolate(velocity_, share_of_last_interval(scan.stamp)) : Pose2{};
  }

  void remember(const LaserScan& scan, const Pose2& pose) noexcept {
    if (has_last_) {
      velocity_ = last_pose_.inverse() * pose;
      interval_ = scan.stamp - last_stamp_;
    }
    has_velocity_ = has_last_;
    has_last_ = true;
    last_pose_ = pose;
    last_stamp_ = scan.stamp;
    last_odometry_ = odometry_of(scan) ? scan.T_odom_robot : std::nullopt;
  }

 private:
  static bool odometry_of(const LaserScan& scan) noexcept {
    return scan.T_odom_robot && scan.T_odom_robot->is_finite();
  }

  // How the time since the last scan compares to the interval before it. Stamps that stand still or run backwards
  // (the Intel log's do) tell nothing: then scans count as evenly spaced. A long gap is no reason to fly far.
  double share_of_last_interval(double stamp) const noexcept {
    const double now = stamp - last_stamp_;
    if (!(now > 0.0) || !(interval_ > 0.0)) return 1.0;
    return std::min(now / interval_, 3.0);
  }

  bool has_last_ = false;
  bool has_velocity_ = false;
  Pose2 last_pose_;
  double last_stamp_ = 0.0;
  std::optional<Pose2> last_odometry_;
  Pose2 velocity_;  // motion from the last pose but one to the last
  double interval_ = 0.0;
};

}  // namespace

struct Localizer::State {
  explicit State(const LocalizerOptions& chosen) : options(chosen), icp(chosen.icp()) {}

  LocalizerOptions options;
  Icp<2> icp;
  Prediction prediction;
  PointMap2::Pointer map;  // null until the first scan in scan-to-scan mode
  bool scan_to_scan = false;
  Fix fix;

  void match(const LaserScan& scan);
  void align_to_map(const Pose2& guess);
  void take_scan_as_map();
};

void Localizer::State::match(const LaserScan& scan) {
  fix.stamp = scan.stamp;
  to_points(scan, options.ranges, fix.scan);
  icp.reserve(scan.ranges.size());
  const Pose2 predicted = fix.pose * prediction.motion_until(scan);
  fix.predicted = predicted.is_finite() ? predicted : fix.pose;  // odometry may tell tales
  if (map) {
    fix.map = map;
    align_to_map(fix.predicted);
    fix.pose =
        fix.match.stop == Stop::too_few_points || fix.match.stop == Stop::no_overlap ? fix.predicted : fix.match.pose;
  }
  prediction.remember(scan, fix.pose);
  if (scan_to_scan) take_scan_as_map();
}

void Localizer::State::align_to_map(const Pose2& guess) {
  const IcpResult2& result = icp.align(map->indexed(), fix.scan.in_robot, guess, options.outputs);
  // The copy gets as much room as the original: a scan with more outliers than those before allocates nothing.
  fix.match.outlier_indices.reserve(result.outlier_indices.capacity());
  fix.match.outliers_in_map.reserve(result.outliers_in_map.capacity());
  fix.match.transformed_scan.reserve(result.transformed_scan.capacity());
  fix.match.updated_map.reserve(result.updated_map.capacity());
  fix.match.matches.reserve(result.matches.capacity());
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
  map = PointMap2::create(std::move(in_map), {}, {.eager = false});
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
  state_->prediction.forget();
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

const Fix& Localizer::update(const LaserScan& scan) noexcept {
  state_->match(scan);
  return state_->fix;
}

const Fix& Localizer::fix() const noexcept { return state_->fix; }
const LocalizerOptions& Localizer::options() const noexcept { return state_->options; }

}  // namespace slamicp
