// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <deque>
#include <string>

#include <slamicp/navigation/path_tracker.hpp>
#include <slamicp/scan/odometry_model.hpp>
#include <slamicp/simulation/random.hpp>

namespace slamicp {

/// A three-wheel omnidirectional robot, as its designer knows it and as it is.
struct OmniRobotModel {
  OmniDrive drive{{0.148, 0.148, 0.148}, 0.195, 0.0};     ///< as designed: what commands and odometry go by
  std::array<double, 3> radius_errors = {0.0, 0.0, 0.0};  ///< of each wheel, a share of its radius
  double slip = 0.0;             ///< of each wheel: the share of its roll that is lost, 1 sigma, in [0, 0.5]
  double slip_time = 0.5;        ///< how long a wheel slips as it does [s], > 0
  double delay = 0.05;           ///< from a command until the wheels do it [s], >= 0
  double encoder_noise = 0.001;  ///< of a wheel's turn after one radian, 1 sigma [rad]

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// The robot of the paper, APR-02, without and with what its wheels get wrong.
OmniRobotModel apr02();

/// A robot that does as it is told, late and not quite. It moves in steps of a millisecond; the same commands at the
/// same times and the same seed give the same motion.
class SimulatedRobot {
 public:
  /// Throws Error for a model with a problem().
  SimulatedRobot(const OmniRobotModel& model, const Pose2& T_map_robot, std::uint64_t seed);

  /// What the motors are told at `stamp` [s]; stamps must not fall.
  void command(double stamp, const VelocityCommand& command);

  /// Moves on until `stamp` [s].
  void advance(double stamp);

  double stamp() const noexcept { return static_cast<double>(steps_) * time_step; }
  const Pose2& pose() const noexcept { return T_map_robot_; }       ///< where it really is, T_map_robot
  const Pose2& odometry() const noexcept { return T_odom_robot_; }  ///< by its encoders, from (0, 0, 0)
  /// What it does right now, as it really is, in its own frame [m/s, m/s, rad/s].
  const Pose2::Tangent& velocity() const noexcept { return velocity_; }

 private:
  static constexpr double time_step = 1e-3;

  struct Told {
    double stamp;
    VelocityCommand command;
  };

  void step();

  OmniRobotModel model_;
  OmniDrive really_;
  Random random_;
  std::deque<Told> told_;
  VelocityCommand now_;
  std::array<double, 3> slipping_ = {};
  Pose2 T_map_robot_;
  Pose2 T_odom_robot_;
  Pose2::Tangent velocity_ = Pose2::Tangent::Zero();
  std::uint64_t steps_ = 0;
};

}  // namespace slamicp
