// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <slamicp/geometry/pose.hpp>

namespace slamicp {

/// What a lidar sees of somebody.
enum class PersonShape {
  legs,  ///< two legs that swing as they walk: a lidar near the floor
  body,  ///< one round thing: a lidar at the height of the hips
};

/// Somebody who walks a polyline, there and back or round and round, and turns on the spot at its corners; one corner
/// alone: who stands there. Where they are is a function of time alone, so a run repeats to the bit; they mind neither
/// walls nor robots.
struct Person {
  std::string name;
  std::vector<Point2> way;  ///< corners [m], at least one; no corner twice in a row
  bool is_loop = false;     ///< from the last corner on to the first; else back the way they came
  double speed = 1.2;       ///< on the straight [m/s], > 0
  double start = 0.0;       ///< how long they have been walking at time 0 [s]; they left the first corner then
  double pause = 0.0;       ///< they stand so long at both ends of the way, of a loop at its first corner [s], >= 0
  double heading = 0.0;     ///< where who stands looks [rad]; of no meaning for who walks
  PersonShape shape = PersonShape::legs;
  double leg_radius = 0.06;    ///< [m], > 0
  double leg_distance = 0.24;  ///< between the middles of the legs, across the heading [m], >= 0
  double step_length = 0.7;    ///< from one foot to the other [m], > 0; each straight takes a whole number of steps
  double body_radius = 0.22;   ///< [m], > 0

  /// The first rule broken, in words; empty where all is well.
  std::string problem() const;
};

/// How fast somebody turns on the spot [rad/s].
inline constexpr double person_turn_rate = 4.0;

/// Where somebody is at `stamp` [s], and looks, in the map's frame. O(corners).
Pose2 pose_at(const Person& person, double stamp) noexcept;

/// The round things that a lidar meets, all of one size.
struct PersonOutline {
  std::array<Point2, 2> centres;  ///< in the map's frame [m]
  std::size_t count = 0;          ///< of the centres, 1 or 2
  double radius = 0.0;            ///< [m]
};

/// What a lidar meets of somebody at `stamp` [s]. The legs swing by a sine against each other, so far that the one that
/// bears the weight stands still for a moment; they are side by side at corners. O(corners).
PersonOutline outline_at(const Person& person, double stamp) noexcept;

}  // namespace slamicp
