// SPDX-License-Identifier: Apache-2.0
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/covariance_trial.hpp>
#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/scan/scan_points.hpp>

namespace slamicp {
namespace {

/// Ranges at a pose and how they change when the robot moves a little ahead and to the left.
struct RangesAround {
  std::vector<double> here, ahead, left;

  static constexpr double step = 1e-6;  // [m]

  RangesAround(const World& world, const Pose2& T_map_robot, const LidarModel& lidar) {
    true_ranges(world, T_map_robot * lidar.T_robot_laser, lidar, here);
    true_ranges(world, T_map_robot * Pose2{step, 0.0, 0.0} * lidar.T_robot_laser, lidar, ahead);
    true_ranges(world, T_map_robot * Pose2{0.0, step, 0.0} * lidar.T_robot_laser, lidar, left);
  }

  /// dr/d(position) = -normal / cos(incidence).
  Vector<2> slope(std::size_t i) const noexcept { return {(ahead[i] - here[i]) / step, (left[i] - here[i]) / step}; }
};

/// True for a place this near to where walls end or meet, or to something round.
bool is_at_corner(const World& world, const Point2& place, double reach) {
  for (const Segment& wall : world.walls)
    if (std::min((place - wall.a).norm(), (place - wall.b).norm()) < reach) return true;
  for (const Door& door : world.doors)
    for (const Segment& side : sides(leaf(door, door.opening)))
      if ((place - side.a).norm() < reach) return true;
  return std::any_of(world.pillars.begin(), world.pillars.end(),
                     [&](const Circle& pillar) { return (place - pillar.centre).norm() < pillar.radius + reach; });
}

}  // namespace

Matrix<3, 3> least_covariance(const World& known, const World& world, const Pose2& T_map_robot, const LidarModel& lidar,
                              double range_noise, double map_noise, double off_corners) {
  const RangesAround around(world, T_map_robot, lidar);
  std::vector<double> of_known;
  true_ranges(known, T_map_robot * lidar.T_robot_laser, lidar, of_known);
  constexpr double steepest = 200.0;  // an edge within the step, not a wall
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < around.here.size(); ++i) {
    const double range = around.here[i];
    const Vector<2> slope = around.slope(i);
    if (!(range < lidar.range_max) || range < of_known[i] - 1e-9 || !(slope.norm() < steepest)) continue;
    const double angle = lidar.angle_min + static_cast<double>(i) * lidar.angle_increment;
    const Point2 point = lidar.T_robot_laser * Point2(range * std::cos(angle), range * std::sin(angle));
    if (off_corners > 0.0 && is_at_corner(known, T_map_robot * point, off_corners)) continue;
    const Vector<2> normal = -slope.normalized();
    const double cosine = 1.0 / slope.norm();
    const Eigen::Vector3d h(normal.x(), normal.y(), cross(point, normal));
    information += h * h.transpose() / (range_noise * range_noise * cosine * cosine + map_noise * map_noise);
  }
  return information.inverse();
}

double CovarianceTrial::nees() const noexcept { return error.dot(Eigen::Matrix3d(told.covariance).inverse() * error); }

std::string CovarianceTrialOptions::problem() const {
  if (!(map_noise >= 0.0)) return "map_noise must be at least 0 m";
  if (!(off_corners >= 0.0)) return "off_corners must be at least 0 m";
  return {};
}

CovarianceTrials::CovarianceTrials(std::string_view world_name, std::uint64_t seed,
                                   const CovarianceTrialOptions& options)
    : options_(options), world_(trial_world(world_name)), lidar_(hokuyo_utm30lx()), random_(seed) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "CovarianceTrialOptions");
  map_ = PointMap2::create(sample_map(world_, default_map_spacing, options.map_noise, random_));
  icp_.set_rays({lidar_.T_robot_laser.translation(), lidar_.angle_increment});
}

CovarianceTrial CovarianceTrials::draw(double unmapped) {
  const Pose2 truth = place_beside_route(world_, random_);
  const World now = unmapped > 0.0 ? with_unmapped_things(world_, truth, lidar_, unmapped, random_) : world_;
  ScanPoints points = to_points(scan(now, truth, lidar_, random_));
  if (options_.off_corners > 0.0)
    std::erase_if(points.in_robot,
                  [&](const Point2& point) { return is_at_corner(world_, truth * point, options_.off_corners); });
  // One statement each: the order of the draws is part of what a seed means.
  const double ahead = 0.02 * random_.normal();
  const double left = 0.02 * random_.normal();
  const double turn = 0.01 * random_.normal();
  const IcpResult2& match =
      icp_.align(map_->indexed(), points.in_robot, truth * Pose2{ahead, left, turn}, {.covariance = true});
  const double smoothed = options_.map_noise / std::sqrt(map_->indexed().line_noise().points);
  CovarianceTrial trial;
  trial.error = (truth.inverse() * match.pose).log();
  trial.told = match.uncertainty;
  trial.least = least_covariance(world_, now, truth, lidar_, lidar_.range_noise, smoothed, options_.off_corners);
  trial.plain = least_covariance(world_, now, truth, lidar_, lidar_.range_noise, 0.0, options_.off_corners);
  trial.usable = match.usable();
  return trial;
}

void CovarianceScore::add(const CovarianceTrial& trial) noexcept {
  constexpr double off = 0.1;  // [m]: another place, or none
  if (!trial.usable || trial.error.head<2>().norm() > off) {
    ++failed_;
    return;
  }
  if (trial.told.blind) {
    ++blind_;
    return;
  }
  ++count_;
  const double nees = trial.nees();
  nees_ += nees;
  inside_ += nees <= within_95_percent ? 1U : 0U;
  position2_ += trial.error.head<2>().squaredNorm();
  turn2_ += trial.error[2] * trial.error[2];
  told2_ += trial.told.covariance(0, 0) + trial.told.covariance(1, 1);
  bound2_ += trial.least(0, 0) + trial.least(1, 1);
  bound_turn2_ += trial.least(2, 2);
  plain2_ += trial.plain(0, 0) + trial.plain(1, 1);
}

double CovarianceScore::rmse() const noexcept { return std::sqrt(position2_ / n()); }
double CovarianceScore::rmse_turn() const noexcept { return std::sqrt(turn2_ / n()); }
double CovarianceScore::told() const noexcept { return std::sqrt(told2_ / n()); }
double CovarianceScore::bound() const noexcept { return std::sqrt(bound2_ / n()); }
double CovarianceScore::bound_turn() const noexcept { return std::sqrt(bound_turn2_ / n()); }
double CovarianceScore::plain_bound() const noexcept { return std::sqrt(plain2_ / n()); }

}  // namespace slamicp
