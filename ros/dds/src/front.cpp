// SPDX-License-Identifier: Apache-2.0
#include "front.hpp"

#include <chrono>
#include <cstdio>

namespace slamicp::node {
namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

Front::Front(const NodeOptions& options, const Names& names, bool use_sim_time, std::uint32_t domain, Spelling spelling)
    : options_(options),
      name_(names.node),
      node_(options, use_sim_time, seconds),
      participant_(domain),
      publications_(options, names, participant_),
      has_map_(!options.map_file.empty()) {
  subscribe(names, use_sim_time);
  announce(names, spelling, participant_);
  const bool is_old = spelling == Spelling::until_humble;
  tell(Severity::info, "node " + names.whole() + ", listed as " +
                           (is_old ? "Humble reads it" : "Iron and later read it (ROS_DISTRO=humble: as Humble does)"));
}

void Front::subscribe(const Names& names, bool use_sim_time) {
  if (use_sim_time)
    clock_ = participant_.reader(rosgraph_msgs_msg_dds__Clock__desc, names.topic("/clock"), {false, false, 1});
  static_tf_ = participant_.reader(tf2_msgs_msg_dds__TFMessage__desc, names.topic("/tf_static"), latched_motion);
  tf_ = participant_.reader(tf2_msgs_msg_dds__TFMessage__desc, names.topic("/tf"), motion);
  if (!options_.odom_topic.empty())
    odometry_ = participant_.reader(nav_msgs_msg_dds__Odometry__desc, names.topic(options_.odom_topic), motion);
  for (const std::string& topic : options_.scan_topics)
    scans_.push_back(participant_.reader(sensor_msgs_msg_dds__LaserScan__desc, names.topic(topic), sensor_data));
  pose_ =
      participant_.reader(geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc, names.topic("initialpose"), usual);
  if (options_.mode != "mapping" && options_.map_file.empty() && options_.use_map_topic)
    map_ = participant_.reader(nav_msgs_msg_dds__OccupancyGrid__desc, names.topic(options_.map_topic), latched);
}

Stamp Front::now() const {
  using std::chrono::system_clock;
  if (clock_ != 0) return played_;
  return {std::chrono::duration_cast<std::chrono::nanoseconds>(system_clock::now().time_since_epoch()).count()};
}

void Front::spin(const volatile std::sig_atomic_t& stopped) {
  constexpr double a_moment = 0.01;
  while (stopped == 0) {
    participant_.wait(a_moment);
    take_all_there_is();
    pump();
    now_and_then();
  }
}

void Front::take_all_there_is() {
  if (clock_ != 0)
    take_all<rosgraph_msgs_msg_dds__Clock_>(clock_, [this](const auto& message) { played_ = stamp_of(message.clock); });
  for (const bool is_static : {true, false})
    take_all<tf2_msgs_msg_dds__TFMessage_>(is_static ? static_tf_ : tf_, [&](const auto& message) {
      for (std::uint32_t k = 0; k < message.transforms._length; ++k)
        node_.take_transform(from_dds(message.transforms._buffer[k]), is_static);
    });
  if (odometry_ != 0)
    take_all<nav_msgs_msg_dds__Odometry_>(
        odometry_, [this](const auto& message) { node_.take_odometry(from_dds(message), now()); });
  if (map_ != 0)
    take_all<nav_msgs_msg_dds__OccupancyGrid_>(map_, [this](const auto& message) {
      if (!has_map_ || !options_.first_map_only) take(message);
    });
  take_all<geometry_msgs_msg_dds__PoseWithCovarianceStamped_>(pose_, [this](const auto& message) { take(message); });
  for (std::size_t k = 0; k < scans_.size(); ++k)
    take_all<sensor_msgs_msg_dds__LaserScan_>(
        scans_[k], [&](const auto& message) { node_.take_scan(static_cast<int>(k), from_dds(message), now()); });
}

void Front::pump() {
  while (const Output* const output = node_.step(now())) publications_.publish(*output);
}

void Front::now_and_then() {
  if (const Grid* const grid = node_.new_map(now())) publications_.publish(*grid);
  const double passed = seconds();
  if (passed < next_second_) return;
  next_second_ = passed + 1.0;
  publish_state();
  for (const std::string& line : participant_.unheard()) tell(Severity::warning, line);
}

void Front::publish_state() {
  const Diagnostic diagnostic = node_.diagnostic(now());
  publications_.publish(diagnostic, now());
  const State state = node_.state(now());
  if (state == State::localizing || state == State::mapping || state == State::recovering) return;
  Status status;
  if (const Output* const last = node_.last()) status = last->status;
  status.state = state;
  publications_.publish(status, now());
  if (diagnostic.level == 0 || next_second_ < next_warning_) return;
  next_warning_ = next_second_ + 10.0;
  tell(Severity::warning, diagnostic.message);
}

void Front::take(const nav_msgs_msg_dds__OccupancyGrid_& map) {
  std::string problem;
  if (!node_.take_map(from_dds(map), problem)) {
    tell(Severity::error, "map: " + problem);
    return;
  }
  has_map_ = true;
  tell(Severity::info,
       "took a map of " + std::to_string(map.info.width) + " x " + std::to_string(map.info.height) + " cells");
}

void Front::take(const geometry_msgs_msg_dds__PoseWithCovarianceStamped_& pose) {
  std::string problem;
  if (!node_.take_pose(from_dds(pose), problem)) tell(Severity::error, "initialpose: " + problem);
}

void Front::tell(Severity severity, const std::string& text) {
  const char* const word = severity == Severity::info ? "INFO" : severity == Severity::warning ? "WARN" : "ERROR";
  std::fprintf(stderr, "[%s] [%s]: %s\n", word, name_.c_str(), text.c_str());
  publications_.publish(severity, text, now());
}

}  // namespace slamicp::node
