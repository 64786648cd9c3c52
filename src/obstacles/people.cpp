// SPDX-License-Identifier: Apache-2.0
#include "obstacles/people.hpp"

#include <algorithm>

namespace slamicp {
namespace {

constexpr double step_between_legs = 0.8;  // at most [m]

/// The nearest other leg that is no step too far, or somebody of whom one leg is seen.
Followed* leg_beside(std::vector<Followed>& followed, const Followed& leg, double stamp) noexcept {
  Followed* nearest = nullptr;
  double least = step_between_legs;
  for (Followed& it : followed) {
    if (&it == &leg || !it.seen_at(stamp) || it.shown.state != TrackState::confirmed) continue;
    if (it.is_person() ? it.shown.obstacles[1] >= 0 : it.shown.width > widest_leg) continue;
    if (!it.ever_moved && it.shown.motion == TrackMotion::still) continue;  // a post
    if (!it.is_person() && it.shown.width < 1.6 * least_leg) continue;      // too thin
    const double distance = (it.motion.position - leg.motion.position).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = &it;
  }
  return nearest;
}

/// Somebody of whom one leg is seen, and a leg beside them that nothing is known of: it is theirs.
void give_second_legs(std::vector<Followed>& followed, double stamp) noexcept {
  constexpr double apart = 0.5;  // at most, from the middle of both [m]
  for (std::size_t k = 0; k < followed.size(); ++k) {
    if (!followed[k].is_person() || !followed[k].seen_at(stamp) || followed[k].shown.obstacles[1] >= 0) continue;
    const auto leg = std::find_if(followed.begin(), followed.end(), [&](const Followed& it) {
      return !it.is_person() && it.seen_at(stamp) && it.shown.width <= widest_leg &&
             it.shown.motion != TrackMotion::still && (it.motion.position - followed[k].motion.position).norm() < apart;
    });
    if (leg == followed.end()) continue;
    followed[k].shown.obstacles[1] = leg->shown.obstacles[0];
    const auto at = static_cast<std::size_t>(leg - followed.begin());
    followed.erase(leg);
    if (at <= k) --k;
  }
}

/// Makes one track of two; the one that was there first, or is somebody already, stays.
void join(std::vector<Followed>& followed, Followed& a, Followed& b) noexcept {
  const bool a_stays = a.is_person() || (!b.is_person() && a.shown.id < b.shown.id);
  Followed& stays = a_stays ? a : b;
  const Followed& goes = a_stays ? b : a;
  if (!stays.is_person()) {
    stays.shown.kind = TrackKind::person;
    stays.motion.position = 0.5 * (stays.motion.position + goes.motion.position);
    stays.motion.velocity = 0.5 * (stays.motion.velocity + goes.motion.velocity);
    stays.motion.of_position += round_noise(0.05);
    stays.motion.of_both.setZero();
    stays.motion.of_velocity = round_noise(0.5);
  }
  stays.ever_moved = true;
  stays.reached = std::max(stays.reached, step_between_legs);  // two of them went along
  stays.shown.motion = TrackMotion::moving;
  stays.last_moved = std::max(stays.last_moved, goes.last_moved);
  stays.shown.obstacles[1] = goes.shown.obstacles[0];
  stays.partner = 0;
  followed.erase(followed.begin() + (&goes - followed.data()));
}

}  // namespace

void find_people(std::vector<Followed>& followed, double stamp) noexcept {
  constexpr int tests = 3;
  constexpr double way = 0.15;  // that the two have come [m]
  give_second_legs(followed, stamp);
  for (std::size_t k = 0; k < followed.size(); ++k) {
    Followed& leg = followed[k];
    if (leg.shown.kind != TrackKind::leg || !leg.moves() || !leg.seen_at(stamp)) continue;
    Followed* other = leg_beside(followed, leg, stamp);
    if (other == nullptr) {
      leg.partner = 0;
      continue;
    }
    const Point2 middle = 0.5 * (leg.motion.position + other->motion.position);
    if (!other->is_person()) other->shown.kind = TrackKind::leg;
    other->beside = stamp;
    if (leg.partner != other->shown.id) {
      leg.partner = other->shown.id;
      leg.together = 0;
      leg.met = middle;
    }
    if (++leg.together < tests || (middle - leg.met).norm() < way) continue;
    join(followed, leg, *other);
    return;  // the others next time: tracks have changed places
  }
}

}  // namespace slamicp
