// SPDX-License-Identifier: Apache-2.0
#pragma once
// C++17: fronts whose headers know no C++20 include this.

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace slamicp::node {

/// A parameter's value, as it was given.
using Value = std::variant<bool, int, double, std::string, std::vector<std::string>>;
using Values = std::vector<std::pair<std::string, Value>>;

/// All that a user can choose. Names are those of the parameters; amcl's where it has them.
struct NodeOptions {
  std::string mode = "localization";
  std::string map_file;
  bool use_map_topic = true;
  std::string map_topic = "map";
  bool first_map_only = false;
  std::vector<std::string> scan_topics = {"scan"};
  std::string odom_topic;
  std::string global_frame_id = "map";
  std::string odom_frame_id = "odom";
  std::string base_frame_id = "base_link";
  bool use_odometry = true;
  double odometry_wait = 0.1;
  double scan_timeout = 1.0;
  double initial_pose_x = 0.0, initial_pose_y = 0.0, initial_pose_a = 0.0;
  bool wait_for_initial_pose = false;
  bool tf_broadcast = true;
  double transform_tolerance = 0.1;
  double save_pose_rate = 0.5;
  double min_range = 0.0, max_range = 1e9;
  double max_correspondence_distance = 0.3;
  double outlier_distance = 0.0;
  double obstacle_distance = 0.0;
  int max_iterations = 50;
  bool deskew = true;
  bool recover = true;
  int recover_places = 2000;
  double map_update_interval = 5.0;
  double resolution = 0.05;

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// One line of what there is to choose.
struct ParameterInfo {
  std::string name, type, unit, fallback, range, meaning;
};
/// In the order of NodeOptions.
std::vector<ParameterInfo> parameters();

/// Parameters of amcl, ROS 1's and nav2's, that this node has no use for, and why: taken, with a warning, so that
/// amcl's launch and parameter files run. A name that ends in '*' stands for all that begin so.
std::vector<std::pair<std::string, std::string>> parameters_without_use();

/// Chooses; amcl's names for what has another one here are understood. Throws slamicp::Error (a std::runtime_error) for
/// a name that is none, with the nearest one; for a value of another type, or out of range.
/// @param warnings  of names that are taken, and do nothing
NodeOptions options_from(const Values& values, std::vector<std::string>& warnings);

}  // namespace slamicp::node
