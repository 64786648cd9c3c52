// SPDX-License-Identifier: Apache-2.0
#include "obstacles/followed.hpp"

#include <algorithm>
#include <cmath>

namespace slamicp {
namespace {

/// Tests in a row that must.
constexpr int tests_that_tell = 2;

/// How far a thing has come, at least: where more of it is seen than before, or less, its middle is elsewhere by half
/// of that without a step.
double way(const Point2& from, double width_then, const Point2& to, double width_now) noexcept {
  return (to - from).norm() - 0.5 * std::abs(width_now - width_then);
}

/// It is elsewhere than when the view was made, and free space says so too.
bool has_moved_since(const Followed& it, int slot, const PastViews& views, const LaserView& now,
                     const ViewErrors& errors, double least_motion) noexcept {
  const Followed::Before& before = it.before[static_cast<std::size_t>(slot)];
  const Point2& here = it.motion.position;
  if (way(before.middle, before.width, here, it.width) < least_motion + errors.shift) return false;
  const FreeSpace came = free_space(views.view(slot), it.footprint, errors, true);
  if (came.tells()) return true;
  const FreeSpace left = free_space(now, before.footprint, errors, false);
  return left.tells() || FreeSpace{came.free + left.free, came.taken + left.taken}.tells();
}

/// It has come some way in each of two times one after the other: what only looks otherwise from here than from there
/// jumps once.
bool goes_on_moving(const Followed& it, const PastViews& views, double least_motion) noexcept {
  const auto known = [&](int slot) {
    return views.has(slot) && it.before[static_cast<std::size_t>(slot)].serial == views.serial(slot);
  };
  const double part = 0.6 * least_motion;
  for (int middle = 0; middle < PastViews::most; ++middle) {
    if (!known(middle)) continue;
    const Followed::Before& then = it.before[static_cast<std::size_t>(middle)];
    if (way(then.middle, then.width, it.motion.position, it.width) < part) continue;
    for (int first = 0; first < PastViews::most; ++first) {
      const Followed::Before& once = it.before[static_cast<std::size_t>(first)];
      if (known(first) && views.stamp(first) < views.stamp(middle) &&
          way(once.middle, once.width, then.middle, then.width) >= part)
        return true;
    }
  }
  return false;
}

}  // namespace

void test_motion(Followed& it, const PastViews& views, const LaserView& now, double stamp, const ViewErrors& errors,
                 const ObstacleTrackerOptions& options) noexcept {
  bool moved = false;
  bool knows = false;
  const bool goes_on = it.moves() || goes_on_moving(it, views, options.least_motion);
  for (int slot = 0; slot < PastViews::most && !moved; ++slot) {
    if (!views.has(slot) || it.before[static_cast<std::size_t>(slot)].serial != views.serial(slot)) continue;
    // Who has walked and stands now is not to be told for ever that they walked.
    if (it.moves() && stamp - views.stamp(slot) > options.settle) continue;
    knows = true;
    moved = goes_on && has_moved_since(it, slot, views, now, errors, options.least_motion);
  }
  if (!knows) return;
  it.evidence = moved ? it.evidence + 1 : 0;
  if (moved) {
    it.last_moved = stamp;
    if (it.evidence >= tests_that_tell) it.shown.motion = TrackMotion::moving;
  } else if (it.shown.motion != TrackMotion::still &&
             stamp - std::max(it.last_moved, it.shown.born) >= options.settle) {
    it.shown.motion = TrackMotion::still;
    it.motion.halt();
  }
}

double agility_of(const Followed& it, const ObstacleTrackerOptions& options) noexcept {
  constexpr double of_a_leg = 20.0;  // it swings
  constexpr double of_what_stands = 0.02;
  if (it.is_person()) return options.agility;
  if (it.shown.motion == TrackMotion::still && !it.ever_moved) return of_what_stands * options.agility;
  return it.leg_share > 0.5 ? of_a_leg * options.agility : 2.0 * options.agility;
}

}  // namespace slamicp
