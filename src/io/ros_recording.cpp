// SPDX-License-Identifier: Apache-2.0
#include "io/ros_recording.hpp"

#include <algorithm>

#include <slamicp/error.hpp>
#include <slamicp/geometry/planar.hpp>

#include "io/text.hpp"

namespace slamicp {
namespace {

RosTopic::Kind kind_of(std::string_view type) noexcept {
  if (type == "sensor_msgs/LaserScan") return RosTopic::Kind::scan;
  if (type == "nav_msgs/Odometry") return RosTopic::Kind::odometry;
  if (type == "tf2_msgs/TFMessage" || type == "tf/tfMessage") return RosTopic::Kind::tf;
  return RosTopic::Kind::other;
}

/// Drivers without a clock leave stamps at 0.
double stamp_of(const ros::Header& header, double logged, RosTopic& topic) noexcept {
  if (header.stamp != 0.0) return header.stamp;
  ++topic.unstamped;
  return logged;
}

}  // namespace

RosRecording::RosRecording(std::string name, const std::vector<std::string>& scan_topics)
    : name_(std::move(name)), scan_topics_(scan_topics) {}

int RosRecording::open(const Channel& channel) {
  const auto [entry, is_new] = topic_of_.emplace(std::pair(channel.topic, channel.type), topics_.size());
  if (is_new) {
    RosTopic& topic = topics_.emplace_back();
    topic.name = channel.topic;
    topic.type = channel.type;
    topic.kind = kind_of(channel.type);
  }
  const RosTopic& topic = topics_[entry->second];
  const bool is_chosen =
      scan_topics_.empty() || std::any_of(scan_topics_.begin(), scan_topics_.end(), [&](const std::string& chosen) {
        return chosen == every_topic || same_name(chosen, topic.name);
      });
  const bool is_wanted = topic.kind == RosTopic::Kind::scan ? is_chosen : topic.kind != RosTopic::Kind::other;
  channels_.push_back({entry->second, channel.serialization, is_wanted});
  return static_cast<int>(channels_.size()) - 1;
}

void RosRecording::take(int channel, double logged, std::string_view body) {
  const OpenChannel& from = channels_[static_cast<std::size_t>(channel)];
  RosTopic& topic = topics_[from.topic];
  ++topic.messages;
  if (!from.is_wanted) return;
  try {
    decode(topic, from.serialization, logged, body);
  } catch (const Error& error) {
    if (topic.broken++ == 0) topic.problem = error.problem();
  }
}

void RosRecording::decode(RosTopic& topic, Serialization serialization, double logged, std::string_view body) {
  if (topic.kind == RosTopic::Kind::scan) {
    ros::LaserScan message = ros::read_laser_scan(serialization, body, name_);
    message.scan.stamp = stamp_of(message.header, logged, topic);
    topic.scans.push_back(std::move(message));
  } else if (topic.kind == RosTopic::Kind::odometry) {
    const ros::Odometry message = ros::read_odometry(serialization, body, name_);
    if (topic.odometry.empty()) topic.odometry_child = without_slash(message.child_frame);
    topic.odometry.push_back({stamp_of(message.header, logged, topic), planar(message.pose)});
  } else {
    for (const ros::Transform& transform : ros::read_transforms(serialization, body, name_))
      frames_.add(transform, transform.header.stamp != 0.0 ? transform.header.stamp : logged);
  }
}

std::vector<std::string> RosRecording::warnings() const {
  std::vector<std::string> all = warnings_;
  for (const RosTopic& topic : topics_) {
    const std::string of = " of " + text::count_of(topic.messages, "message") + " of " + topic.name;
    if (topic.broken > 0) all.push_back(std::to_string(topic.broken) + of + " left out: " + topic.problem);
    if (topic.unstamped > 0)
      all.push_back(std::to_string(topic.unstamped) + of + " without a stamp: stamped as recorded");
  }
  for (const std::string& frame : frames_.contested())
    all.push_back("frame '" + frame + "' has several parents in tf: the first is used");
  return all;
}

}  // namespace slamicp
