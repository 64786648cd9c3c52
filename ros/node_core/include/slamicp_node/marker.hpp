// SPDX-License-Identifier: Apache-2.0
#pragma once
// C++17: fronts whose headers know no C++20 include this.

#include <slamicp_node/messages.hpp>

namespace slamicp::node {

/// About the vertical.
Quaternion turn_by(double theta);

/// How an obstacle is drawn: what visualization_msgs/Marker has of it.
struct Marker {
  bool is_round = false;  ///< a cylinder, else a box
  Position position;
  Quaternion orientation;
  Position scale;  ///< [m]
  float red = 0.0F, green = 0.0F, blue = 0.0F, alpha = 0.0F;
};
Marker marker_of(const Obstacle& obstacle);

}  // namespace slamicp::node
