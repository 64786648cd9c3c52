// SPDX-License-Identifier: Apache-2.0
#include "frames.hpp"

#include <algorithm>
#include <utility>

#include <slamicp/geometry/planar.hpp>

namespace slamicp::node {

std::string without_slash(std::string_view name) {
  return std::string(name.substr(!name.empty() && name.front() == '/' ? 1 : 0));
}

std::optional<Pose3> pose_of(const Position& position, const Quaternion& orientation) {
  Pose3 pose;
  pose.position = {position.x, position.y, position.z};
  pose.orientation = Pose3::Quaternion(orientation.w, orientation.x, orientation.y, orientation.z);
  const double norm = pose.orientation.norm();
  if (!(norm > 1e-6) || !pose.is_finite()) return std::nullopt;
  pose.orientation.normalize();
  return pose;
}

Frames::Frames(std::string_view odom, std::string_view base) : odom_(without_slash(odom)), base_(without_slash(base)) {}

std::vector<Frames::Links::const_iterator> Frames::above(std::string_view frame, std::string_view to) const {
  std::vector<Links::const_iterator> chain;
  while (frame != to && chain.size() < links_.size()) {
    const auto link = links_.find(frame);
    if (link == links_.end()) break;
    chain.push_back(link);
    frame = link->second.parent;
  }
  return chain;
}

std::optional<MotionTrack::Sample> Frames::add(const Transform& transform, bool is_static) {
  const std::string child = without_slash(transform.child), parent = without_slash(transform.frame);
  const std::optional<Pose3> pose = pose_of(transform.translation, transform.rotation);
  if (!pose || child.empty() || parent.empty() || child == parent) {
    ++broken_;
    return std::nullopt;
  }
  Link& link = links_[child];
  link.parent = parent;
  link.T_parent_child = *pose;
  ++link.told;
  if (is_static || child == odom_) return std::nullopt;

  const std::vector<Links::const_iterator> chain = above(base_, odom_);
  if (chain.empty() || chain.back()->second.parent != odom_) return std::nullopt;
  const auto leading = std::max_element(chain.begin(), chain.end(),
                                        [](const auto& a, const auto& b) { return a->second.told < b->second.told; });
  if ((*leading)->first != child) return std::nullopt;
  Pose3 T_odom_base;
  for (const auto& each : chain) T_odom_base = each->second.T_parent_child * T_odom_base;
  return MotionTrack::Sample{transform.stamp.seconds(), planar(T_odom_base)};
}

std::optional<Pose3> Frames::mount(std::string_view base, std::string_view frame) const {
  const std::string from = without_slash(base), to = without_slash(frame);
  // Both ways up, each with the pose of where it began in each frame on it.
  const auto way_up = [&](const std::string& start) {
    std::vector<std::pair<std::string_view, Pose3>> way{{start, Pose3{}}};
    for (const auto& link : above(start))
      way.emplace_back(link->second.parent, link->second.T_parent_child * way.back().second);
    return way;
  };
  const auto from_base = way_up(from);
  for (const auto& [meeting, of_frame] : way_up(to)) {
    const auto of_base = std::find_if(from_base.begin(), from_base.end(),
                                      [name = meeting](const auto& step) { return step.first == name; });
    if (of_base != from_base.end()) return of_base->second.inverse() * of_frame;
  }
  return std::nullopt;
}

}  // namespace slamicp::node
