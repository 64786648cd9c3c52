// SPDX-License-Identifier: Apache-2.0
#include "io/ros_robot.hpp"

#include <slamicp/error.hpp>
#include <slamicp/geometry/planar.hpp>

#include "io/ros_topics.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

/// Throws Error where nothing in the recording goes by the name.
void require_frame(const RosRecording& recording, const std::string& base, const std::string& laser,
                   const RosTopic* odometry) {
  if (recording.frames().has(base) || base == laser) return;
  if (odometry != nullptr && base == odometry->odometry_child) return;
  std::string names;
  for (const std::string& frame : recording.frames().frames()) names += (names.empty() ? "" : ", ") + frame;
  throw Error("has no frame " + text::quoted(base), recording.name(),
              names.empty() ? "leave --base-frame out" : "choose among " + names);
}

std::string base_of(const RosRecording& recording, const ScanLogOptions& options, const std::string& laser,
                    const RosTopic* odometry) {
  if (!options.base_frame.empty()) {
    std::string base(without_slash(options.base_frame));
    require_frame(recording, base, laser, odometry);
    return base;
  }
  if (odometry != nullptr && !odometry->odometry_child.empty()) return odometry->odometry_child;
  return recording.frames().find({"base_footprint", "base_link", "base"}).value_or(laser);
}

/// The odometry of a frame on the robot as that of `base`.
void move_to_base(const FrameTree& frames, const std::string& child, const std::string& base,
                  std::vector<MotionTrack::Sample>& odometry, std::vector<std::string>& warnings) {
  if (child.empty() || child == base) return;
  const std::optional<FrameTree::Mount> mount = frames.mount(child, base);
  if (!mount) {
    warnings.push_back("no transform from '" + base + "' to '" + child + "', which odometry is of: taken as the same");
    return;
  }
  const Pose2 T_child_base = planar(mount->T_base_frame);
  for (MotionTrack::Sample& sample : odometry) sample.T_odom_robot = sample.T_odom_robot * T_child_base;
}

MotionTrack odometry_of_tf(const FrameTree& frames, const std::string& base, std::vector<std::string>& warnings) {
  const std::optional<std::string> odom = frames.odometry_frame(base);
  if (!odom) return {};
  warnings.push_back("odometry is taken from tf, '" + *odom + "' to '" + base + "'");
  return frames.motion(*odom, base);
}

}  // namespace

RosRobot find_robot(RosRecording& recording, const ScanLogOptions& options, const std::string& laser,
                    std::vector<std::string>& warnings) {
  RosTopic* const topic = choose_odometry_topic(recording, options.odometry_topic, warnings);
  RosRobot robot;
  robot.base = base_of(recording, options, laser, topic);
  if (topic == nullptr) {
    robot.odometry = odometry_of_tf(recording.frames(), robot.base, warnings);
    return robot;
  }
  move_to_base(recording.frames(), topic->odometry_child, robot.base, topic->odometry, warnings);
  robot.odometry = MotionTrack(std::move(topic->odometry));
  return robot;
}

}  // namespace slamicp
