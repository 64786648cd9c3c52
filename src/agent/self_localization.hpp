// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <slamicp/agent/agent.hpp>

namespace slamicp {

/// The subtasks that the two forms of the agent do differently: where the robot is, and what does not fit the map.
class SelfLocalization {
 public:
  virtual ~SelfLocalization() = default;

  virtual void set_pose(const Pose2& pose) = 0;
  /// Finds the pose.
  virtual void localize(const LaserScan& scan) = 0;
  /// Sees to it that the fix has the outliers.
  virtual void find_discrepancies() = 0;
  virtual const Fix& fix() const noexcept = 0;
};

std::unique_ptr<SelfLocalization> original_localization(PointMap2::Pointer map, const AgentOptions& options);
std::unique_ptr<SelfLocalization> improved_localization(PointMap2::Pointer map, const AgentOptions& options);

}  // namespace slamicp
