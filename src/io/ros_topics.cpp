// SPDX-License-Identifier: Apache-2.0
#include "io/ros_topics.hpp"

#include <algorithm>

#include <slamicp/error.hpp>

#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr const char* record_scans = "record a topic of sensor_msgs/LaserScan";

bool has_content(const RosTopic& topic) noexcept { return !topic.scans.empty() || !topic.odometry.empty(); }

std::vector<RosTopic*> topics_with(RosRecording& recording, RosTopic::Kind kind) {
  std::vector<RosTopic*> found;
  for (RosTopic& topic : recording.topics())
    if (topic.kind == kind && has_content(topic)) found.push_back(&topic);
  return found;
}

template <class Topics>
std::string names_of(const Topics& topics) {
  std::string names;
  for (const auto* const topic : topics) names += (names.empty() ? "" : ", ") + topic->name;
  return names;
}

/// The topic of this name and kind.
RosTopic& find_topic(RosRecording& recording, const std::string& name, RosTopic::Kind kind, const char* option) {
  const RosTopic* other = nullptr;
  for (RosTopic& topic : recording.topics()) {
    if (!same_name(topic.name, name)) continue;
    if (topic.kind == kind && has_content(topic)) return topic;
    other = &topic;
  }
  std::vector<const RosTopic*> of_kind;
  for (const RosTopic& topic : recording.topics())
    if (topic.kind == kind && topic.messages > topic.broken) of_kind.push_back(&topic);
  const std::string choices = names_of(of_kind);
  const std::string mend = choices.empty() ? std::string("leave ") + option + " out" : "choose among " + choices;
  if (other == nullptr) throw Error("has no topic " + text::quoted(name), recording.name(), mend);
  if (other->kind == kind)
    throw Error(
        "no message of " + told(*other) + " can be used" + (other->problem.empty() ? "" : ": " + other->problem),
        recording.name(), mend);
  throw Error("topic " + told(*other) + " is of another type", recording.name(), mend);
}

/// The one whose name ends like this; null where it is not one.
RosTopic* only_named(const std::vector<RosTopic*>& topics, std::string_view last) {
  RosTopic* found = nullptr;
  for (RosTopic* const topic : topics) {
    if (without_slash(topic->name) == last) return topic;
    if (last_part(topic->name) != last) continue;
    if (found != nullptr) return nullptr;
    found = topic;
  }
  return found;
}

[[noreturn]] void fail_without_scans(const RosRecording& recording) {
  std::string found, problem;
  bool has_clouds = false;
  for (const RosTopic& topic : recording.topics()) {
    found += (found.empty() ? "; topics: " : ", ") + told(topic);
    has_clouds = has_clouds || topic.type == "sensor_msgs/PointCloud2";
    if (topic.kind == RosTopic::Kind::scan && problem.empty()) problem = topic.problem;
  }
  const std::vector<std::string> warnings = recording.warnings();
  if (problem.empty() && !warnings.empty()) problem = warnings.front();
  if (!problem.empty()) problem = " (" + problem + ")";
  throw Error("holds no scan" + problem + found, recording.name(),
              std::string(record_scans) + (has_clouds ? "; pointcloud_to_laserscan makes one of clouds" : ""));
}

}  // namespace

std::string told(const RosTopic& topic) { return topic.name + " (" + topic.type + ")"; }

std::vector<RosTopic*> choose_scan_topics(RosRecording& recording, const std::vector<std::string>& names) {
  std::vector<RosTopic*> chosen;
  if (names.size() == 1 && names.front() == every_topic) {
    chosen = topics_with(recording, RosTopic::Kind::scan);
    if (chosen.empty()) fail_without_scans(recording);
    return chosen;
  }
  for (const std::string& name : names) {
    RosTopic* const topic = &find_topic(recording, name, RosTopic::Kind::scan, "--scan-topic");
    if (std::find(chosen.begin(), chosen.end(), topic) == chosen.end()) chosen.push_back(topic);
  }
  if (!chosen.empty()) return chosen;
  std::vector<RosTopic*> topics = topics_with(recording, RosTopic::Kind::scan);
  if (topics.empty()) fail_without_scans(recording);
  if (topics.size() == 1) return topics;
  if (RosTopic* const scan = only_named(topics, "scan"); scan != nullptr) return {scan};
  throw Error("holds scans of " + std::to_string(topics.size()) + " topics: " + names_of(topics), recording.name(),
              "name one by --scan-topic, or several for one log of them all");
}

RosTopic* choose_odometry_topic(RosRecording& recording, const std::string& name, std::vector<std::string>& warnings) {
  if (!name.empty()) return &find_topic(recording, name, RosTopic::Kind::odometry, "--odometry-topic");
  const std::vector<RosTopic*> topics = topics_with(recording, RosTopic::Kind::odometry);
  if (topics.empty()) return nullptr;
  if (topics.size() == 1) return topics.front();
  if (RosTopic* const odom = only_named(topics, "odom"); odom != nullptr) return odom;
  warnings.push_back("holds odometry of several topics, " + names_of(topics) +
                     ": none is used; name one by --odometry-topic");
  return nullptr;
}

}  // namespace slamicp
