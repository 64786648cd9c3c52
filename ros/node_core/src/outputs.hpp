// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp_node/messages.hpp>
#include <span>

#include <slamicp/localization/fix.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>
#include <slamicp/obstacles/track.hpp>

namespace slamicp::node {

PlanarPose to_message(const Pose2& pose);

/// Pose, covariance and what the match says of itself.
void tell_fix(const Fix& fix, Output& output);

/// The scan's points in the frame of its laser, which sits at `T_base_laser` on the robot.
void tell_points(const Fix& fix, const Pose3& T_base_laser, Output& output);

void tell_obstacles(std::span<const slamicp::Obstacle> found, std::span<const Track> tracks, Output& output);

}  // namespace slamicp::node
