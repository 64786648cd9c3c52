// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <slamicp_node/marker.hpp>

namespace slamicp::node {
namespace {

void colour(Marker& marker, float red, float green, float blue) {
  marker.red = red;
  marker.green = green;
  marker.blue = blue;
  marker.alpha = 0.8F;
}

}  // namespace

Quaternion turn_by(double theta) { return {0.0, 0.0, std::sin(0.5 * theta), std::cos(0.5 * theta)}; }

Marker marker_of(const Obstacle& obstacle) {
  constexpr double height = 0.5, thinnest = 0.03;
  Marker marker;
  marker.is_round = obstacle.kind == "circle";
  marker.position = {obstacle.x, obstacle.y, 0.5 * height};
  marker.orientation = turn_by(obstacle.heading);
  marker.scale = {std::max(obstacle.width, thinnest), std::max(obstacle.depth, thinnest), height};
  if (obstacle.state == "person" || obstacle.state == "leg" || obstacle.state == "moving")
    colour(marker, 0.9F, 0.2F, 0.1F);
  else if (obstacle.state == "static")
    colour(marker, 0.9F, 0.6F, 0.1F);
  else
    colour(marker, 0.6F, 0.6F, 0.6F);
  return marker;
}

}  // namespace slamicp::node
