// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/cluttered_drive.hpp>
#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp {
namespace {

constexpr double berth = 0.7;  // that things give the robot [m]

void move(PlacedObstacle& thing, const Vector<2>& by) {
  for (Box& box : thing.boxes) box.centre += by;
  for (Cylinder& cylinder : thing.cylinders) cylinder.centre += by;
}

const ClutteredDriveOptions& checked(const ClutteredDriveOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "ClutteredDriveOptions");
  return options;
}

}  // namespace

std::string ClutteredDriveOptions::problem() const {
  if (!(unmapped >= 0.0 && unmapped <= 0.8)) return "unmapped must lie between 0 and 0.8";
  if (furniture_gone < 0) return "furniture_gone must be at least 0";
  if (!(speed > 0.0)) return "speed must be above 0 m/s";
  if (!(scene_time > 0.0)) return "scene_time must be above 0 s";
  return odometry.problem();
}

ClutteredDrive::ClutteredDrive(std::string_view world_name, std::uint64_t seed, const ClutteredDriveOptions& options)
    : options_(checked(options)),
      world_(trial_world(world_name)),
      lidar_(hokuyo_utm30lx()),
      random_(seed),
      map_(PointMap2::create(sample_map(furnished(world_, options_.furniture_gone, random_), random_))),
      path_(route(world_, "reference").waypoints),
      now_(world_),
      truth_(pose_at(0)),
      scans_of_a_scene_(std::max(1, static_cast<int>(std::lround(options_.scene_time * lidar_.rate)))) {}

/// There and back again, without turning round.
Pose2 ClutteredDrive::pose_at(int scan) const {
  const double along = std::fmod(scan * options_.speed / lidar_.rate, 2.0 * path_.length());
  return path_.at(along > path_.length() ? 2.0 * path_.length() - along : along);
}

const LaserScan& ClutteredDrive::next() {
  const Pose2 before = truth_;
  truth_ = pose_at(scans_);
  if (scans_ > 0) odometry_ = odometry_ * measured_motion(before.inverse() * truth_, options_.odometry, random_);
  if (scans_ % scans_of_a_scene_ == 0)
    set_the_scene();
  else if (options_.moving)
    let_things_walk();
  scan_ = slamicp::scan(now_, truth_, lidar_, random_);
  scan_.stamp = scans_ / lidar_.rate;
  scan_.T_odom_robot = odometry_;
  ++scans_;
  return scan_;
}

/// Where no scene comes out as asked for, the robot is alone for its time.
void ClutteredDrive::set_the_scene() {
  now_ = world_;
  for (int tries = 0; tries < 50 && options_.unmapped > 0.0; ++tries) {
    World scene = with_unmapped_things(world_, truth_, lidar_, options_.unmapped, random_);
    if (!is_fair(scene)) continue;
    now_ = std::move(scene);
    break;
  }
  velocities_.clear();
  for (std::size_t k = world_.obstacles.size(); k < now_.obstacles.size(); ++k) {
    const double direction = random_.uniform(-std::numbers::pi, std::numbers::pi);
    velocities_.push_back(random_.uniform(0.5, 1.4) * Vector<2>(std::cos(direction), std::sin(direction)));
  }
}

/// Nothing in the way, and no more hidden than asked for as the robot goes on.
bool ClutteredDrive::is_fair(const World& scene) const {
  constexpr int looks = 4;
  std::vector<double> bare, now;
  for (int k = 0; k < looks; ++k) {
    const Pose2 pose = pose_at(scans_ + k * (scans_of_a_scene_ - 1) / (looks - 1));
    for (const PlacedObstacle& thing : scene.obstacles)
      if (distance(thing, pose.translation()) < berth) return false;
    true_ranges(world_, pose * lidar_.T_robot_laser, lidar_, bare);
    true_ranges(scene, pose * lidar_.T_robot_laser, lidar_, now);
    if (hidden_share(bare, now) > options_.unmapped + 0.1) return false;
  }
  return true;
}

void ClutteredDrive::let_things_walk() {
  for (std::size_t k = 0; k < velocities_.size(); ++k) {
    PlacedObstacle& thing = now_.obstacles[world_.obstacles.size() + k];
    const Vector<2> step = velocities_[k] / lidar_.rate;
    move(thing, step);
    if (distance(thing, truth_.translation()) < berth) move(thing, -step);
  }
}

}  // namespace slamicp
