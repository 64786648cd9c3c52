// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include <slamicp/localization/localizer.hpp>
#include <slamicp/simulation/lidar.hpp>
#include <slamicp/simulation/random.hpp>
#include <slamicp/simulation/world.hpp>

namespace slamicp {

/// True where a pose is not taken for wrong: within half a metre and 15 deg of the truth.
bool is_right(const Pose2& pose, const Pose2& truth) noexcept;

/// Within so many scans a localizer should notice that it is elsewhere.
inline constexpr int scans_to_notice = 40;

/// Another heading, 45 to 180 deg off to either side.
Pose2 turned_on_the_spot(const Pose2& pose, Random& random);

/// What a localizer made of being somewhere else than it thought.
struct JumpOutcome {
  double shift = 0.0;         ///< from where it thought to be [m]
  double turn = 0.0;          ///< [rad], not negative
  bool noticed = false;       ///< within 40 scans it was suspect, lost, or right again
  int scans_until = 0;        ///< that it took
  bool right_again = false;   ///< it noticed by being right again
  int longest_confident = 0;  ///< most scans in a row that it was wrong, and neither suspect nor lost
  /// What the mapped world shows at the wrong pose is what it shows at the right one, in nine beams of ten to within
  /// 5 cm: nobody could tell.
  bool alike = false;
  bool recovered = false;  ///< at the end it was right and said so; with `recover`
};

/// Robots that are put down 2 to 6 m, or 45 to 180 deg, from where their localizers think they are, in a noisy map of a
/// world, and then drive on a metre and wait.
class JumpTrials {
 public:
  /// @param world_name      of trial_world()
  /// @param furniture_gone  pieces that the map has and that are not there any more
  JumpTrials(std::string_view world_name, std::uint64_t seed, int furniture_gone = 0);

  /// @param unmapped  share of the rays that meet what the map does not know
  /// @param budget    of Localizer::recover after each scan; 0: it is not called
  JumpOutcome draw(double unmapped, int budget = 0);

  /// Called with each fix of the trials to come, and whether its pose is right: to learn from.
  void watch(std::function<void(const Fix&, bool)> watcher) { watcher_ = std::move(watcher); }

 private:
  Pose2 elsewhere(const Pose2& truth);
  bool is_alike(const Pose2& pose, const Pose2& truth) const;

  World world_;
  LidarModel lidar_;
  Random random_;
  PointMap2::Pointer map_;
  std::function<void(const Fix&, bool)> watcher_;
};

}  // namespace slamicp
