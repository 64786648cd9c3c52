// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <slamicp_node/messages.hpp>
#include <slamicp_node/parameters.hpp>
#include <string>

#include "names.hpp"
#include "participant.hpp"

namespace slamicp::node {

/// Of a line of the log, in rcl_interfaces/Log's numbers.
enum class Severity : std::uint8_t { info = 20, warning = 30, error = 40 };

/// The topics that the node gives. Clouds, obstacles and status are made only where somebody listens.
class Publications {
 public:
  Publications(const NodeOptions& options, const Names& names, Participant& participant);

  void publish(const Output& output);
  void publish(const Status& status, const Stamp& stamp);
  void publish(const Diagnostic& diagnostic, const Stamp& now);
  void publish(const Grid& grid);
  void publish(Severity severity, const std::string& line, const Stamp& now);

 private:
  void publish_transform(const Output& output) const;
  void publish_pose(const Output& output);
  void publish_cloud(dds_entity_t writer, const std::vector<Point>& points, const Output& output) const;
  void publish_obstacles(const Output& output);
  void publish_markers(const Output& output);

  std::string frame_;  // the map's
  std::string name_;   // in diagnostics
  std::string logger_;
  bool broadcasts_;
  dds_entity_t tf_ = 0, pose_, outliers_, inliers_, obstacles_, markers_, status_, diagnostics_, log_, map_ = 0;
  std::size_t markers_shown_ = 0;
};

}  // namespace slamicp::node
