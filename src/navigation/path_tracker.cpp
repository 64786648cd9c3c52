// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/navigation/path_tracker.hpp>

namespace slamicp {
namespace {

constexpr double profile_step = 0.02;  // [m]
constexpr double search_behind = 0.3;  // a robot may be pushed back [m]
constexpr double search_ahead = 0.6;   // [m]

bool above_zero(double value) noexcept { return value > 0.0 && std::isfinite(value); }

}  // namespace

std::string PathTrackerOptions::problem() const {
  if (!above_zero(speed)) return "speed must be above 0 m/s; 0.35 is the default";
  if (!above_zero(max_acceleration)) return "max_acceleration must be above 0 m/s^2; 0.5 is the default";
  if (!above_zero(max_turn_rate)) return "max_turn_rate must be above 0 rad/s; 1.5 is the default";
  if (!(delay >= 0.0 && delay < 1.0)) return "delay must be in [0, 1) s";
  if (!above_zero(cross_track_gain) || !above_zero(heading_gain)) return "gains must be above 0 1/s";
  if (!above_zero(goal_tolerance)) return "goal_tolerance must be above 0 m; 0.01 is the default";
  return {};
}

PathTracker::PathTracker(std::shared_ptr<const SplinePath> path, const PathTrackerOptions& options)
    : path_(std::move(path)), options_(options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "PathTrackerOptions");
  if (!path_) throw Error("the path is null", "PathTracker", "make one from waypoints: SplinePath");
  issued_.reserve(64);
  // What each curve allows, then what braking for what comes leaves of it, from the end to the start.
  const auto count = static_cast<std::size_t>(std::ceil(path_->length() / profile_step)) + 1;
  speeds_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double bend = std::abs(path_->curvature(static_cast<double>(i) * profile_step));
    speeds_[i] = options_.speed;
    if (bend > 0.0)
      speeds_[i] =
          std::min({options_.speed, 0.8 * options_.max_turn_rate / bend, std::sqrt(options_.max_acceleration / bend)});
  }
  speeds_.back() = 0.0;
  for (std::size_t i = count - 1; i-- > 0;)
    speeds_[i] =
        std::min(speeds_[i], std::hypot(speeds_[i + 1], std::sqrt(2.0 * options_.max_acceleration * profile_step)));
}

double PathTracker::allowed_speed(double distance) const noexcept {
  const double at = std::clamp(distance / profile_step, 0.0, static_cast<double>(speeds_.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(at), speeds_.size() - 2);
  const double share = at - static_cast<double>(i);
  return (1.0 - share) * speeds_[i] + share * speeds_[i + 1];
}

/// Where the robot will be when the command to be given takes effect.
Pose2 PathTracker::predicted(const Pose2& T_map_robot, double stamp) noexcept {
  const double from = stamp - options_.delay;
  // The command in force at `from` is the last one issued before it.
  while (issued_.size() > 1 && issued_[1].stamp <= from) issued_.erase(issued_.begin());
  Pose2 pose = T_map_robot;
  for (std::size_t k = 0; k < issued_.size(); ++k) {
    const double begin = std::max(issued_[k].stamp, from);
    const double end = k + 1 < issued_.size() ? issued_[k + 1].stamp : stamp;
    if (!(end > begin)) continue;
    const VelocityCommand& command = issued_[k].command;
    pose = pose * Pose2::exp((end - begin) * Pose2::Tangent(command.x, command.y, command.turn));
  }
  return pose;
}

/// What brings the robot along the path, and back to it.
/// @param place  where `ahead` is beside the path
VelocityCommand PathTracker::lead(const Pose2& ahead, const PathPlace& place, double speed) const noexcept {
  const Pose2 on_path = path_->at(place.distance);
  const double bend = path_->curvature(place.distance);
  const double heading_error = wrap_angle(ahead.theta - on_path.theta);
  VelocityCommand command;
  if (options_.drive == DriveKind::holonomic) {
    const double most_aside = std::max(0.1, speed);
    const double aside = std::clamp(-options_.cross_track_gain * place.cross_track, -most_aside, most_aside);
    // In the path's frame, then in the robot's.
    const Point2 velocity = Pose2{0.0, 0.0, -heading_error} * Point2(speed, aside);
    command = {velocity.x(), velocity.y(), bend * speed - options_.heading_gain * heading_error};
  } else {
    // Offsets die away over a distance, not a time: what does not move does not steer.
    const double k = options_.cross_track_gain / options_.speed;
    const double sinc = std::abs(heading_error) > 1e-6 ? std::sin(heading_error) / heading_error : 1.0;
    const double damping = options_.heading_gain / options_.speed;
    command.x = speed * std::max(0.0, std::cos(heading_error));
    command.turn = speed * (bend - 0.5 * k * damping * place.cross_track * sinc - damping * heading_error);
    if (std::abs(heading_error) > 1.0) command.turn = -std::copysign(0.5 * options_.max_turn_rate, heading_error);
  }
  command.turn = std::clamp(command.turn, -options_.max_turn_rate, options_.max_turn_rate);
  return command;
}

const Tracking& PathTracker::update(const Pose2& T_map_robot, double stamp, double speed_limit) noexcept {
  if (!T_map_robot.is_finite() || (started_ && !(stamp > last_stamp_))) return tracking_;
  const double from = started_ ? tracking_.travelled - search_behind : 0.0;
  const double to = started_ ? tracking_.travelled + search_ahead : path_->length();
  const PathPlace place = path_->nearest(T_map_robot.translation(), from, to);
  tracking_.travelled = place.distance;
  tracking_.cross_track = place.cross_track;
  tracking_.heading_error = wrap_angle(T_map_robot.theta - path_->at(place.distance).theta);
  tracking_.finished = path_->length() - place.distance < options_.goal_tolerance;

  const Pose2 ahead = predicted(T_map_robot, stamp);
  const PathPlace there =
      path_->nearest(ahead.translation(), place.distance - search_behind, place.distance + search_ahead);
  const double step = started_ ? std::min(stamp - last_stamp_, 0.2) : 0.0;
  const double most = std::min(allowed_speed(there.distance), std::max(0.0, speed_limit));
  // Braking for an obstacle may be harder than comfort allows.
  const double wanted = std::min(most, tracking_.speed + options_.max_acceleration * step);
  tracking_.speed = tracking_.finished ? 0.0 : std::max(wanted, 0.0);
  tracking_.command = tracking_.speed > 0.0 ? lead(ahead, there, tracking_.speed) : VelocityCommand{};

  if (issued_.size() == issued_.capacity()) issued_.erase(issued_.begin());
  issued_.push_back({stamp, tracking_.command});
  last_stamp_ = stamp;
  started_ = true;
  return tracking_;
}

}  // namespace slamicp
