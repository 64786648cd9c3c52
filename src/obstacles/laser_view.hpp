// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/scan/laser_scan.hpp>

namespace slamicp {

/// What a scan shows of a place.
enum class Sight {
  unseen,  ///< the laser does not look there, or not so far
  hidden,  ///< something nearer stands before it
  taken,   ///< something is there
  free,    ///< the rays about it all go on beyond it, some to what stands there
  silent,  ///< no ray about it came back: free, or it swallows light
};

/// A scan at its pose, to ask about places in the map. It looks at the ranges of somebody else.
class LaserView {
 public:
  LaserView() = default;
  /// @param turn_rate  of the robot while it swept [rad/s]
  LaserView(const LaserScan& scan, const Pose2& T_map_robot, double turn_rate) noexcept;

  /// @param margin  a ray that ends so near to the place's own range ends at it [m]
  /// @param shift   so far sideways the place may be off [m]
  /// @param turn    so far the heading may be off [rad]
  Sight look(const Point2& in_map, double margin, double shift, double turn) const noexcept;

  /// From the laser to the place [m].
  double range_to(const Point2& in_map) const noexcept { return (T_laser_map_ * in_map).norm(); }

  /// The same with ranges that are kept elsewhere: a copy of them.
  LaserView with(std::span<const float> ranges) const noexcept;
  std::span<const float> ranges() const noexcept { return ranges_; }

 private:
  RigidTransform<2> T_laser_map_;
  double first_ = 0.0;      // direction of the first beam [rad]
  double increment_ = 0.0;  // with the robot's turn meanwhile [rad]
  float least_ = 0.0F;
  float most_ = 0.0F;
  std::span<const float> ranges_;
};

}  // namespace slamicp
