// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <slamicp_node/messages.hpp>
#include <string>
#include <string_view>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/scan/motion_track.hpp>

namespace slamicp::node {

/// The name without the slash that it may begin with.
std::string without_slash(std::string_view name);

/// Nothing where it is not finite, or the quaternion has no direction.
std::optional<Pose3> pose_of(const Position& position, const Quaternion& orientation);

/// Which frames sit on which, as tf last said. Names count without a leading slash.
class Frames {
 public:
  Frames(std::string_view odom, std::string_view base);

  /// Where the robot is by its wheels, if this link says so: the one between odometry and base that is told most often.
  /// The others count as they last were.
  std::optional<MotionTrack::Sample> add(const Transform& transform, bool is_static);

  /// How `frame` sits on `base`, over any number of frames between.
  std::optional<Pose3> mount(std::string_view base, std::string_view frame) const;

  /// Links that could not be taken: a frame on itself, a broken pose.
  std::uint64_t broken() const noexcept { return broken_; }

 private:
  struct Link {
    std::string parent;
    Pose3 T_parent_child;
    std::uint64_t told = 0;
  };
  using Links = std::map<std::string, Link, std::less<>>;

  /// The links from `frame` up to `to`, or to the top; nearest first. No more than there are: they may form a ring.
  std::vector<Links::const_iterator> above(std::string_view frame, std::string_view to = {}) const;

  std::string odom_, base_;
  Links links_;  // by the child's name
  std::uint64_t broken_ = 0;
};

}  // namespace slamicp::node
