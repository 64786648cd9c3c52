// SPDX-License-Identifier: Apache-2.0
#pragma once
// C++17: fronts whose headers know no C++20 include this.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// What a node takes and gives, as plain structs: the fields of ROS's messages, without ROS. Units are those of ROS:
/// m, rad, s.
namespace slamicp::node {

/// A moment, to the nanosecond: what came with a message goes out with its answer unchanged.
struct Stamp {
  std::int64_t nanoseconds = 0;  ///< in the clock of the messages

  static Stamp from(std::int64_t seconds, std::int64_t nanoseconds) { return {seconds * 1000000000 + nanoseconds}; }
  static Stamp from_seconds(double seconds) { return {static_cast<std::int64_t>(seconds * 1e9)}; }
  std::int64_t whole_seconds() const { return nanoseconds / 1000000000; }
  std::int64_t rest() const { return nanoseconds % 1000000000; }
  /// As the readers of recordings have it: the same to the last bit.
  double seconds() const { return static_cast<double>(whole_seconds()) + 1e-9 * static_cast<double>(rest()); }
};

struct Position {
  double x = 0.0, y = 0.0, z = 0.0;
};
struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};
struct PlanarPose {
  double x = 0.0, y = 0.0, theta = 0.0;
};

/// geometry_msgs/TransformStamped: T_frame_child
struct Transform {
  Stamp stamp;
  std::string frame, child;
  Position translation;
  Quaternion rotation;
};

/// nav_msgs/Odometry: the pose of `child` in `frame`
using Odometry = Transform;

/// sensor_msgs/LaserScan. The ranges are the caller's.
struct Scan {
  Stamp stamp;
  std::string frame;
  float angle_min = 0.0F, angle_increment = 0.0F, time_increment = 0.0F, scan_time = 0.0F;
  float range_min = 0.0F, range_max = 0.0F;
  const float* ranges = nullptr;
  std::size_t count = 0;
};

/// nav_msgs/OccupancyGrid: -1 unknown, 0 to 100 the probability that a cell is occupied, in per cent
struct Grid {
  Stamp stamp;
  std::string frame;
  double resolution = 0.0;  ///< [m]
  int width = 0, height = 0;
  Position origin;  ///< the outer corner of the first cell
  Quaternion orientation;
  std::vector<std::int8_t> cells;  ///< row by row from the lowest
};

/// geometry_msgs/PoseWithCovarianceStamped
struct GivenPose {
  Stamp stamp;
  std::string frame;
  Position position;
  Quaternion orientation;
};

struct Point {
  float x = 0.0F, y = 0.0F, z = 0.0F;
};

/// What the node is about.
enum class State {
  waiting_for_map,
  waiting_for_pose,      ///< wait_for_initial_pose
  waiting_for_scan,      ///< none has come, or none for `scan_timeout`
  waiting_for_frames,    ///< nobody says where the laser sits on the robot
  waiting_for_odometry,  ///< none has ever come
  localizing,
  recovering,  ///< the pose is doubted; it looks around
  lost,        ///< the pose is lost, and it does not look around
  mapping,
};
/// "waiting_for_map", ...
const char* to_string(State state);

/// Something that stands or moves where the map has nothing. In the map's frame.
struct Obstacle {
  int id = 0;         ///< of its track, the same from scan to scan; 0: not followed yet
  std::string kind;   ///< "unknown", "line", "circle", "box"
  std::string state;  ///< "tentative", "static", "moving", "leg", "person", "undecided"
  double x = 0.0, y = 0.0, heading = 0.0;
  double width = 0.0, depth = 0.0, radius = 0.0;  ///< a circle has a radius, all have width and depth
  double velocity_x = 0.0, velocity_y = 0.0;      ///< zero where it is not known to move
  double distance = 0.0;                          ///< from the laser to its nearest seen point
  int points = 0;                                 ///< that show it
};

/// How a scan went.
struct Status {
  State state = State::waiting_for_map;
  std::string tracking;                 ///< "tracking", "degenerate", "suspect", "lost"
  std::string stop;                     ///< how the match ended: "converged", "no_overlap", ...
  bool usable = false;                  ///< the pose can be used
  double probability = 0.0;             ///< that the pose is right at all, 0 to 1
  double awareness = 0.0;               ///< share of the surroundings that the map explains, 0 to 1
  bool blind = false;                   ///< the scan does not hold every direction
  double blind_x = 0.0, blind_y = 0.0;  ///< the one it does not hold, a unit vector in the map
  std::string carried_by;               ///< what that one follows: "scan" (there is none), "odometry", "velocity"
  int points = 0, inliers = 0, outliers = 0, iterations = 0;
  double localization_seconds = 0.0;  ///< 0 without a stopwatch
  double obstacle_seconds = 0.0;
  double waited = 0.0;  ///< for odometry, from the scan's arrival, in the node's clock
  bool had_odometry = false;
  std::uint64_t scans = 0, dropped = 0, recoveries = 0;  ///< so far
};

/// What one scan led to. Its memory is used again for the next.
struct Output {
  Stamp stamp;             ///< of the scan
  std::string scan_frame;  ///< its laser
  PlanarPose pose;         ///< of the base in the map
  /// Of (x, y, z, about x, about y, about z) in the map's axes, row by row, as PoseWithCovariance has it.
  std::array<double, 36> covariance{};
  /// What goes to tf: nothing where odometry does not tell where the robot was. Map to odometry, or to the base where
  /// odometry is not used.
  bool has_transform = false;
  std::string frame, child;
  Stamp transform_stamp;  ///< in the future by `transform_tolerance`
  PlanarPose transform;
  std::vector<Point> outliers, inliers;  ///< in the laser's frame
  std::vector<Obstacle> obstacles;
  Status status;
};

/// diagnostic_msgs/DiagnosticStatus
struct Diagnostic {
  int level = 0;  ///< 0 ok, 1 warning, 2 error, 3 stale
  std::string message;
  std::vector<std::pair<std::string, std::string>> values;
};

}  // namespace slamicp::node
