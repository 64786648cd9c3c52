// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <slamicp/evaluation/jump_trial.hpp>
#include <slamicp/evaluation/trial_world.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/simulation/map_sampler.hpp>

namespace slamicp {
namespace {

constexpr int scans_in_all = 200;  // at 40 Hz five seconds

/// A metre ahead in the scans that it has to notice, or a turn on the spot where there is no room; then it waits.
Pose2 step_of(const World& world, const Pose2& truth, int scan) {
  if (scan >= scans_to_notice) return {};
  const Pose2 ahead{1.0 / scans_to_notice, 0.0, 0.0};
  const Pose2 turn{0.0, 0.0, 1.0 / scans_to_notice};
  const Point2 bumper = truth * Point2(0.4, 0.0);
  return distance_to_walls(world, bumper) > 0.3 ? ahead : turn;
}

}  // namespace

bool is_right(const Pose2& pose, const Pose2& truth) noexcept {
  const PoseDistance off = distance(pose, truth);
  return off.translation < 0.5 && off.rotation < 15.0 * rad_per_deg;
}

Pose2 turned_on_the_spot(const Pose2& pose, Random& random) {
  const double turn = random.uniform(0.25, 1.0) * std::numbers::pi;
  return pose * Pose2{0.0, 0.0, random.uniform() < 0.5 ? turn : -turn};
}

JumpTrials::JumpTrials(std::string_view world_name, std::uint64_t seed, int furniture_gone)
    : world_(trial_world(world_name)), lidar_(hokuyo_utm30lx()), random_(seed) {
  map_ = PointMap2::create(sample_map(furnished(world_, furniture_gone, random_), random_));
}

/// Where the robot thinks it is: somewhere along the routes, or here with another heading.
Pose2 JumpTrials::elsewhere(const Pose2& truth) {
  if (random_.uniform() < 0.3) return turned_on_the_spot(truth, random_);
  while (true) {
    const Pose2 pose = place_beside_route(world_, random_);
    const double shift = (pose.translation() - truth.translation()).norm();
    if (shift >= 2.0 && shift <= 6.0) return pose;
  }
}

bool JumpTrials::is_alike(const Pose2& pose, const Pose2& truth) const {
  std::vector<double> there, here;
  true_ranges(world_, pose, lidar_, there);
  true_ranges(world_, truth, lidar_, here);
  std::size_t same = 0;
  for (std::size_t i = 0; i < here.size(); ++i) same += std::abs(there[i] - here[i]) < 0.05 || there[i] == here[i];
  return 10 * same >= 9 * here.size();
}

JumpOutcome JumpTrials::draw(double unmapped, int budget) {
  Pose2 truth = place_beside_route(world_, random_);
  const World now = unmapped > 0.0 ? with_unmapped_things(world_, truth, lidar_, unmapped, random_) : world_;
  const Pose2 thought = elsewhere(truth);
  JumpOutcome outcome;
  outcome.shift = (thought.translation() - truth.translation()).norm();
  outcome.turn = distance(thought, truth).rotation;

  Localizer localizer(map_);
  localizer.set_pose(thought);
  Pose2 odometry;
  int confident = 0;
  for (int k = 0; k < scans_in_all; ++k) {
    LaserScan seen = scan(now, truth, lidar_, random_);
    seen.stamp = k / lidar_.rate;
    seen.T_odom_robot = odometry;
    const Fix& fix = localizer.update(seen);
    const bool right = is_right(fix.pose, truth);
    if (watcher_) watcher_(fix, right);
    confident = !right && !fix.quality.doubted() ? confident + 1 : 0;
    outcome.longest_confident = std::max(outcome.longest_confident, confident);
    if (!outcome.noticed && k < scans_to_notice && (right || fix.quality.doubted())) {
      outcome.noticed = true;
      outcome.right_again = right;
      outcome.scans_until = k + 1;
    }
    if (k + 1 == scans_to_notice && !right) outcome.alike = is_alike(fix.pose, truth);
    outcome.recovered = right && !fix.quality.doubted();
    if (budget > 0) localizer.recover(budget);
    const Pose2 step = step_of(now, truth, k);
    truth = truth * step;
    odometry = odometry * step;
  }
  return outcome;
}

}  // namespace slamicp
