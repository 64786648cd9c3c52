// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/scan/motion_track.hpp>

#include "io/ros_messages.hpp"

namespace slamicp {

/// The name of a frame or topic without the slash that it may begin with.
std::string_view without_slash(std::string_view name) noexcept;

/// What follows the last slash: "scan" of "/robot1/scan".
std::string_view last_part(std::string_view name) noexcept;

/// The frames of a recording and how they sit on each other, of its tf messages. Names count without a leading slash.
class FrameTree {
 public:
  void add(const ros::Transform& transform, double stamp);

  bool has(std::string_view frame) const noexcept;
  /// The first of these that there is, also under a prefix: "robot1/base_link" is a base_link.
  std::optional<std::string> find(std::initializer_list<std::string_view> names) const;
  /// In the order of their names.
  std::vector<std::string> frames() const;
  /// Frames that came with more than one parent; the first is used.
  const std::vector<std::string>& contested() const noexcept { return contested_; }

  struct Mount {
    Pose3 T_base_frame;  ///< as it was first
    bool moves = false;  ///< by more than 1 mm or 0.1 deg in the plane
  };
  /// How `frame` sits on `base`, over any number of frames between; nothing where they are not connected.
  std::optional<Mount> mount(std::string_view base, std::string_view frame) const;

  /// The nearest frame above `base` whose name begins with "odom".
  std::optional<std::string> odometry_frame(std::string_view base) const;
  /// The way of `base` in `odometry_frame`, a frame above it.
  MotionTrack motion(std::string_view odometry_frame, std::string_view base) const;

 private:
  struct Sample {
    double stamp = 0.0;
    Pose3 T_parent_child;
  };
  struct Link {
    std::string parent;
    std::vector<Sample> samples;
    bool moves = false;
  };
  using Links = std::map<std::string, Link, std::less<>>;

  /// The links above `frame`, nearest first.
  std::vector<const Links::value_type*> above(std::string_view frame) const;

  Links links_;  ///< by the child's name
  std::vector<std::string> contested_;
};

}  // namespace slamicp
