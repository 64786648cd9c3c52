// SPDX-License-Identifier: Apache-2.0
#include "io/frame_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <slamicp/geometry/planar.hpp>

namespace slamicp {
namespace {

bool is_elsewhere(const Pose3& a, const Pose3& b) noexcept {
  constexpr double farthest = 1e-3;                            // [m]
  constexpr double most_angle = 0.1 * std::numbers::pi / 180;  // [rad]
  const PoseDistance apart = distance(planar(a), planar(b));
  return !(apart.translation <= farthest && apart.rotation <= most_angle);
}

}  // namespace

std::string_view without_slash(std::string_view name) noexcept { return name.starts_with('/') ? name.substr(1) : name; }

std::string_view last_part(std::string_view name) noexcept {
  const std::size_t slash = name.rfind('/');
  return slash == std::string_view::npos ? name : name.substr(slash + 1);
}

void FrameTree::add(const ros::Transform& transform, double stamp) {
  const std::string_view parent = without_slash(transform.header.frame);
  const std::string child(without_slash(transform.child_frame));
  Link& link = links_[child];
  if (link.samples.empty()) link.parent = parent;
  if (link.parent != parent) {
    if (std::find(contested_.begin(), contested_.end(), child) == contested_.end()) contested_.push_back(child);
    return;
  }
  link.samples.push_back({stamp, transform.pose});
  link.moves = link.moves || is_elsewhere(link.samples.front().T_parent_child, transform.pose);
}

bool FrameTree::has(std::string_view frame) const noexcept {
  return links_.contains(frame) ||
         std::any_of(links_.begin(), links_.end(), [&](const auto& link) { return link.second.parent == frame; });
}

std::vector<std::string> FrameTree::frames() const {
  std::set<std::string> names;
  for (const auto& [child, link] : links_) {
    names.insert(child);
    names.insert(link.parent);
  }
  return {names.begin(), names.end()};
}

std::optional<std::string> FrameTree::find(std::initializer_list<std::string_view> names) const {
  const std::vector<std::string> all = frames();
  for (const std::string_view name : names) {
    if (has(name)) return std::string(name);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& frame) { return last_part(frame) == name; });
    if (found != all.end()) return *found;
  }
  return std::nullopt;
}

std::vector<const FrameTree::Links::value_type*> FrameTree::above(std::string_view frame) const {
  std::vector<const Links::value_type*> chain;
  // As many steps as there are links: a broken recording may have frames that sit on each other in a ring.
  for (auto link = links_.find(frame); link != links_.end() && chain.size() < links_.size();
       link = links_.find(link->second.parent))
    chain.push_back(&*link);
  return chain;
}

std::optional<FrameTree::Mount> FrameTree::mount(std::string_view base, std::string_view frame) const {
  // Both ways up, each with the pose of where it began in each frame on it.
  const auto way_up = [&](std::string_view from) {
    std::vector<std::pair<std::string_view, Mount>> way{{from, Mount{}}};
    for (const auto* const link : above(from)) {
      const Mount& below = way.back().second;
      way.emplace_back(link->second.parent, Mount{link->second.samples.front().T_parent_child * below.T_base_frame,
                                                  below.moves || link->second.moves});
    }
    return way;
  };
  const auto from_base = way_up(base);
  for (const auto& [meeting, of_frame] : way_up(frame)) {
    const auto of_base = std::find_if(from_base.begin(), from_base.end(),
                                      [name = meeting](const auto& step) { return step.first == name; });
    if (of_base == from_base.end()) continue;
    return Mount{of_base->second.T_base_frame.inverse() * of_frame.T_base_frame,
                 of_base->second.moves || of_frame.moves};
  }
  return std::nullopt;
}

std::optional<std::string> FrameTree::odometry_frame(std::string_view base) const {
  for (const auto* const link : above(base))
    if (last_part(link->second.parent).starts_with("odom")) return link->second.parent;
  return std::nullopt;
}

MotionTrack FrameTree::motion(std::string_view odometry_frame, std::string_view base) const {
  std::vector<const Link*> chain;
  for (const auto* const link : above(base)) {
    chain.push_back(&link->second);
    if (link->second.parent == odometry_frame) break;
  }
  if (chain.empty()) return {};
  const Link* const leading = *std::max_element(
      chain.begin(), chain.end(), [](const Link* a, const Link* b) { return a->samples.size() < b->samples.size(); });

  // The link that tells most sets the moments; the others count as they last were.
  std::vector<MotionTrack::Sample> track;
  std::vector<std::size_t> latest(chain.size(), 0);
  for (const Sample& moment : leading->samples) {
    Pose3 T_odom_base;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const std::vector<Sample>& samples = chain[i]->samples;
      if (chain[i] == leading) {
        T_odom_base = moment.T_parent_child * T_odom_base;
        continue;
      }
      while (latest[i] + 1 < samples.size() && samples[latest[i] + 1].stamp <= moment.stamp) ++latest[i];
      T_odom_base = samples[latest[i]].T_parent_child * T_odom_base;
    }
    track.push_back({moment.stamp, planar(T_odom_base)});
  }
  return MotionTrack(std::move(track));
}

}  // namespace slamicp
