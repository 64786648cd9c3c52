// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>
#include <slamicp_node/node.hpp>
#include <string>
#include <vector>

#include "announcement.hpp"
#include "conversions.hpp"
#include "names.hpp"
#include "participant.hpp"
#include "publications.hpp"

namespace slamicp::node {

/// The node's topics as ROS 2 has them over DDS. All in one thread but DDS's own.
class Front {
 public:
  Front(const NodeOptions& options, const Names& names, bool use_sim_time, std::uint32_t domain, Spelling spelling);

  /// Until `stopped` is set.
  void spin(const volatile std::sig_atomic_t& stopped);

 private:
  void subscribe(const Names& names, bool use_sim_time);
  Stamp now() const;
  void take_all_there_is();
  /// Steps the node as long as it has something, and publishes that.
  void pump();
  void now_and_then();
  void publish_state();
  void take(const nav_msgs_msg_dds__OccupancyGrid_& map);
  void take(const geometry_msgs_msg_dds__PoseWithCovarianceStamped_& pose);
  /// On the screen and on /rosout.
  void tell(Severity severity, const std::string& text);

  NodeOptions options_;
  std::string name_;
  Node node_;
  Participant participant_;
  Publications publications_;
  dds_entity_t clock_ = 0, static_tf_ = 0, tf_ = 0, odometry_ = 0, pose_ = 0, map_ = 0;  // 0: none
  std::vector<dds_entity_t> scans_;
  Stamp played_;  // the time of /clock
  bool has_map_;
  double next_second_ = 0.0, next_warning_ = 0.0;  // [s], of a clock that only passes
};

}  // namespace slamicp::node
