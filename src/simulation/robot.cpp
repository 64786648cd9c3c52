// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/simulation/robot.hpp>

namespace slamicp {

std::string OmniRobotModel::problem() const {
  if (const std::string in_drive = drive.problem(); !in_drive.empty()) return "drive: " + in_drive;
  for (const double error : radius_errors)
    if (!(std::abs(error) < 0.5)) return "radius_errors are shares: give less than half of the radius";
  if (!(slip >= 0.0 && slip <= 0.5)) return "slip is a share: give 0 to 0.5";
  if (!(slip_time > 0.0)) return "slip_time must be above 0 s";
  if (!(delay >= 0.0 && std::isfinite(delay))) return "delay must be 0 s or more";
  if (!(encoder_noise >= 0.0 && std::isfinite(encoder_noise))) return "encoder_noise must be 0 rad or more";
  return {};
}

OmniRobotModel apr02() {
  OmniRobotModel robot;
  robot.radius_errors = {0.004, -0.003, 0.002};
  robot.slip = 0.02;
  return robot;
}

SimulatedRobot::SimulatedRobot(const OmniRobotModel& model, const Pose2& T_map_robot, std::uint64_t seed)
    : model_(model), really_(model.drive), random_(seed), T_map_robot_(T_map_robot) {
  if (const std::string problem = model.problem(); !problem.empty()) throw Error(problem, "OmniRobotModel");
  for (std::size_t k = 0; k < 3; ++k) {
    really_.radii[k] *= 1.0 + model.radius_errors[k];
    slipping_[k] = random_.normal();
  }
}

void SimulatedRobot::command(double stamp, const VelocityCommand& command) { told_.push_back({stamp, command}); }

void SimulatedRobot::advance(double stamp) {
  while (this->stamp() + 0.5 * time_step < stamp) step();
}

void SimulatedRobot::step() {
  while (!told_.empty() && told_.front().stamp + model_.delay <= stamp() + 1e-9) {
    now_ = told_.front().command;
    told_.pop_front();
  }
  ++steps_;
  const Pose2 wanted = Pose2::exp(time_step * Pose2::Tangent(now_.x, now_.y, now_.turn));
  WheelTurns<3> turns = model_.drive.turns(wanted);
  WheelTurns<3> rolled = turns;
  // An Ornstein-Uhlenbeck process: a wheel that slips goes on slipping for a while. It loses way, it never gains any.
  const double keeps = std::exp(-time_step / model_.slip_time);
  const double jolts = std::sqrt(1.0 - keeps * keeps);
  for (std::size_t k = 0; k < 3; ++k) {
    slipping_[k] = keeps * slipping_[k] + jolts * random_.normal();
    rolled[k] *= 1.0 - std::min(0.9, model_.slip * std::abs(slipping_[k]));
    turns[k] += model_.encoder_noise * std::sqrt(std::abs(turns[k])) * random_.normal();
  }
  const Pose2 moved = really_.motion(rolled);
  velocity_ = moved.log() / time_step;
  T_map_robot_ = T_map_robot_ * moved;
  T_odom_robot_ = T_odom_robot_ * model_.drive.motion(turns);
}

}  // namespace slamicp
