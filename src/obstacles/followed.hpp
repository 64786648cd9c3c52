// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <slamicp/obstacles/obstacle_tracker.hpp>

#include "obstacles/constant_velocity.hpp"
#include "obstacles/detection.hpp"
#include "obstacles/past_views.hpp"

namespace slamicp {

/// A track, and what its user need not know.
struct Followed {
  /// Of it, when a view was kept.
  struct Before {
    int serial = 0;  // of the view; 0: not seen then
    Point2 middle = Point2::Zero();
    double width = 0.0;
    Footprint footprint;
  };

  Track shown;
  ConstantVelocity motion;
  std::array<Before, PastViews::most> before;
  Footprint footprint;      // as last seen
  double width = 0.0;       // the same [m]
  int missed = 0;           // scans since it began that did not show it
  double patience = 0.0;    // without being seen [s]
  double leg_share = 0.0;   // of the last scans that showed it as wide as a leg
  double next_test = 0.0;   // of its motion [s]
  double last_moved = 0.0;  // when a test told so [s]
  int evidence = 0;         // tests in a row that told that it moves
  bool ever_moved = false;
  Point2 set_out = Point2::Zero();  // where it was first told to move ...
  double reached = 0.0;             // ... and how far from there it has been since [m]
  double beside = 0.0;              // when it last stood beside a leg that moved [s]
  bool is_part = false;             // as last seen: what is seen of it changes with the map's edge
  int partner = 0;                  // id of the leg that keeps near; 0: none
  int together = 0;                 // tests in a row that it did
  Point2 met = Point2::Zero();      // the middle of both when it began to

  bool is_person() const noexcept { return shown.kind == TrackKind::person; }
  bool seen_at(double stamp) const noexcept { return shown.last_seen == stamp; }
  bool moves() const noexcept { return shown.motion == TrackMotion::moving; }
};

/// Whether free space tells that it moves; to be asked now and then, where it was just seen.
void test_motion(Followed& it, const PastViews& views, const LaserView& now, double stamp, const ViewErrors& errors,
                 const ObstacleTrackerOptions& options) noexcept;

/// Of its acceleration [m^2/s^3].
double agility_of(const Followed& it, const ObstacleTrackerOptions& options) noexcept;

}  // namespace slamicp
