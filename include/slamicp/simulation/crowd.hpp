// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// How people move about a robot's way.
enum class CrowdLayout {
  crossing,     ///< from side to side across the way, there and back
  along,        ///< beside the way and parallel to it, 10 m at most, there and back
  groups,       ///< two to four stand together beside the way and talk; who is left over stands alone
  random_walk,  ///< from place to place as chance has it, twelve places at most, there and back
};

/// "crossing", "along", "groups", "random_walk"
const char* to_string(CrowdLayout layout) noexcept;

struct CrowdOptions {
  int people = 6;  ///< 0 to 1000
  CrowdLayout layout = CrowdLayout::crossing;
  std::uint64_t seed = 1;   ///< another seed is another crowd
  double clearance = 0.35;  ///< from the middle of somebody to what stands in the world [m], above 0

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// The world with more people in it, where the robot will meet them: all begin in sight of the route, keep clear of
/// what stands there, and walk at 0.8 to 1.5 m/s. Groups keep 0.6 m away from the route; others may walk through the
/// robot, as people are not told of it, nor of each other. The same arguments give the same people.
///
/// Throws Error for options with a problem(), waypoints that make no path, and where somebody finds no room.
/// O(people * tries * things); a place is tried 500 times at most.
World with_crowd(World world, std::span<const Point2> route, const CrowdOptions& options);

}  // namespace slamicp
