// SPDX-License-Identifier: Apache-2.0
#pragma once
// C++17: what the tests' ROS nodes know of slamicp's simulation.

#include <memory>
#include <string>
#include <vector>

namespace slamicp::drive {

struct PlainPose {
  double x = 0.0, y = 0.0, theta = 0.0;
};
struct Command {
  double x = 0.0, y = 0.0, turn = 0.0;
};
struct Thing {
  double x = 0.0, y = 0.0, radius = 0.0;
};

/// One sweep of the robot's lidar, and where its wheels say it was.
struct Sweep {
  double stamp = 0.0, end = 0.0;  // of the first beam, the last [s]
  double angle_min = 0.0, angle_increment = 0.0, time_increment = 0.0, range_max = 0.0;
  std::vector<float> ranges;
  PlainPose odometry, odometry_at_end, truth;
};

/// The paper's robot in corridor_world(), at the start of the reference path; a box stands on its way, 4 m ahead.
class SimulatedRobot {
 public:
  SimulatedRobot();
  ~SimulatedRobot();
  /// The next sweep; the command holds from the end of the last one on.
  const Sweep& step(const Command& command);
  void remove_box();
  /// What brings it to a place that wanders to and fro along the path.
  Command wander() const;
  double rate = 20.0;  // sweeps a second, before the first step
  /// A careful survey's map of the world without the box. Returns where the robot starts in it.
  static PlainPose write_map(const std::string& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Follows the reference path, and stands before what is on it.
class Follower {
 public:
  Follower();
  ~Follower();
  Command follow(double stamp, const PlainPose& pose, const std::vector<Thing>& things);
  double travelled() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slamicp::drive
