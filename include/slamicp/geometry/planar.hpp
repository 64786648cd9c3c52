// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// A pose in space seen from above: where it is, and where its x axis points.
inline Pose2 planar(const Pose3& pose) noexcept {
  const Point3 ahead = pose.orientation * Point3::UnitX();
  return {pose.position.x(), pose.position.y(), wrap_angle(std::atan2(ahead.y(), ahead.x()))};
}

}  // namespace slamicp
