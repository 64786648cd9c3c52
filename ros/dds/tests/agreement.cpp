// SPDX-License-Identifier: Apache-2.0
#include "agreement.hpp"

#include <cstring>
#include <slamicp_node/marker.hpp>

#include "expect.hpp"

namespace slamicp::dds_peer {

bool operator==(const node::Position& a, const node::Position& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool operator==(const node::Quaternion& a, const node::Quaternion& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}
bool operator==(const node::Stamp& a, const node::Stamp& b) { return a.nanoseconds == b.nanoseconds; }

namespace {

bool same(const std::vector<node::Point>& a, const std::vector<node::Point>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(node::Point)) == 0);
}

bool same(const node::Obstacle& a, const node::Obstacle& b) {
  return a.id == b.id && a.kind == b.kind && a.state == b.state && a.x == b.x && a.y == b.y && a.heading == b.heading &&
         a.width == b.width && a.depth == b.depth && a.radius == b.radius && a.velocity_x == b.velocity_x &&
         a.velocity_y == b.velocity_y && a.distance == b.distance && a.points == b.points;
}

/// But for their states, which a message has as text, and for times.
bool same(const node::Status& a, const node::Status& b) {
  return a.tracking == b.tracking && a.stop == b.stop && a.usable == b.usable && a.probability == b.probability &&
         a.awareness == b.awareness && a.blind == b.blind && a.blind_x == b.blind_x && a.blind_y == b.blind_y &&
         a.carried_by == b.carried_by && a.points == b.points && a.inliers == b.inliers && a.outliers == b.outliers &&
         a.iterations == b.iterations && a.had_odometry == b.had_odometry && a.scans == b.scans &&
         a.dropped == b.dropped && a.recoveries == b.recoveries;
}

std::string brief(const std::string& state, const node::Status& status) {
  return state + ", " + status.tracking + ", " + status.stop + ", " + status.carried_by +
         (status.had_odometry ? ", with" : ", without") + " odometry, " + std::to_string(status.inliers) +
         " inliers, " + std::to_string(status.scans) + " scans, " + std::to_string(status.dropped) + " dropped";
}

}  // namespace

void must_agree(const Pose& pose, const node::Output& output, const std::string& at) {
  must(pose.frame == "map" && pose.position == node::Position{output.pose.x, output.pose.y, 0.0} &&
           pose.orientation == node::turn_by(output.pose.theta),
       "another pose" + at);
  must(pose.covariance == output.covariance, "another covariance" + at);
}

void must_agree(const node::Transform& map_to_odom, const node::Output& output, const std::string& at) {
  must(map_to_odom.frame == "map" && map_to_odom.child == "odom" &&
           map_to_odom.translation == node::Position{output.transform.x, output.transform.y, 0.0} &&
           map_to_odom.rotation == node::turn_by(output.transform.theta),
       "another transform" + at);
}

void must_agree(const Cloud& cloud, const std::vector<node::Point>& points, const std::string& frame,
                const std::string& at) {
  must(cloud.frame == frame && cloud.fields == std::vector<std::string>{"x@0", "y@4", "z@8"}, "a cloud's fields" + at);
  must(same(cloud.points, points), "another cloud" + at);
}

void must_agree(const Obstacles& obstacles, const node::Output& output, const std::string& at) {
  must(obstacles.obstacles.size() == output.obstacles.size(), "other obstacles" + at);
  for (std::size_t i = 0; i < output.obstacles.size(); ++i)
    must(same(obstacles.obstacles[i], output.obstacles[i]), "another obstacle" + at);
}

void must_agree(const std::vector<DrawnMarker>& markers, const node::Output& output, const std::string& at) {
  must(markers.size() >= output.obstacles.size(), "too few markers" + at);
  for (std::size_t i = 0; i < markers.size(); ++i) {
    constexpr std::int32_t add = 0, remove = 2, cube = 1, cylinder = 3;
    const DrawnMarker& drawn = markers[i];
    must(drawn.ns == "obstacles" && drawn.id == static_cast<std::int32_t>(i) && drawn.frame == "map",
         "another marker" + at);
    const bool is_there = i < output.obstacles.size();
    must(drawn.action == (is_there ? add : remove), "a marker's action" + at);
    if (!is_there) continue;
    const node::Marker ours = node::marker_of(output.obstacles[i]);
    must(drawn.type == (ours.is_round ? cylinder : cube) && drawn.position == ours.position &&
             drawn.scale == ours.scale && drawn.alpha == ours.alpha,
         "another marker" + at);
  }
}

void must_agree(const Status& status, const node::Output& output, const std::string& at) {
  const std::string state = node::to_string(output.status.state);
  must(status.state == state && same(status.status, output.status),
       "another status" + at + ": " + brief(status.state, status.status) + "; not " + brief(state, output.status));
  must(status.status.dropped == 0, "dropped scans" + at);
  must(status.status.localization_seconds > 0.0, "no stopwatch" + at);
}

}  // namespace slamicp::dds_peer
