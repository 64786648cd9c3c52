// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <slamicp/navigation/spline_path.hpp>

namespace slamicp {

/// What a robot's motors are told: a velocity in its own frame.
struct VelocityCommand {
  double x = 0.0;     ///< ahead [m/s]
  double y = 0.0;     ///< to the left [m/s]; 0 for a differential drive
  double turn = 0.0;  ///< counter-clockwise [rad/s]
};

/// What a robot's wheels can do.
enum class DriveKind {
  holonomic,     ///< any velocity at any heading: omnidirectional wheels, as the paper's APR-02
  differential,  ///< ahead and around only
};

struct PathTrackerOptions {
  DriveKind drive = DriveKind::holonomic;
  double speed = 0.35;            ///< along the path where nothing holds the robot back [m/s], > 0
  double max_acceleration = 0.5;  ///< along and across the path [m/s^2], > 0; curves are taken so slowly
  double max_turn_rate = 1.5;     ///< [rad/s], > 0
  double delay = 0.05;            ///< from a scan's stamp until the command that follows from it takes effect [s]
  double cross_track_gain = 3.0;  ///< how fast an offset from the path dies away [1/s], > 0; too fast swings
  double heading_gain = 4.0;      ///< the same for the heading [1/s], > 0
  double goal_tolerance = 0.01;   ///< the way is done this near to its end [m], > 0

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// Where the robot is on its way, and what to tell its motors.
struct Tracking {
  VelocityCommand command;
  double travelled = 0.0;      ///< along the path, at the pose given [m]
  double cross_track = 0.0;    ///< of the pose given from the path, positive to the left [m]
  double heading_error = 0.0;  ///< of the pose given against the path's direction [rad]
  double speed = 0.0;          ///< along the path that the command asks for [m/s]
  bool finished = false;
};

/// Follows a path: the speed of the way where it is straight, less in curves and before the end, and back to the path
/// where the robot has left it. A holonomic robot goes back sideways, a differential one by steering (Samson 1992).
///
/// The commands of the last `delay` are still to take effect: the robot is led from where it will be then.
class PathTracker {
 public:
  /// Throws Error with options.problem(), or for a null path.
  PathTracker(std::shared_ptr<const SplinePath> path, const PathTrackerOptions& options = {});

  /// @param T_map_robot  where the robot is at `stamp` [s]
  /// @param speed_limit  what obstacles leave of the speed [m/s], 0 to stop
  /// Stamps must rise; one that does not gives the last answer again. O(1).
  const Tracking& update(const Pose2& T_map_robot, double stamp,
                         double speed_limit = std::numeric_limits<double>::infinity()) noexcept;

  const SplinePath& path() const noexcept { return *path_; }
  const PathTrackerOptions& options() const noexcept { return options_; }

 private:
  struct Issued {
    double stamp;
    VelocityCommand command;
  };

  double allowed_speed(double distance) const noexcept;
  Pose2 predicted(const Pose2& T_map_robot, double stamp) noexcept;
  VelocityCommand lead(const Pose2& ahead, const PathPlace& place, double speed) const noexcept;

  std::shared_ptr<const SplinePath> path_;
  PathTrackerOptions options_;
  std::vector<double> speeds_;  // that curves and the end allow, along the path
  std::vector<Issued> issued_;  // commands that are still to take effect, the oldest first
  Tracking tracking_;
  double last_stamp_ = 0.0;
  bool started_ = false;
};

}  // namespace slamicp
