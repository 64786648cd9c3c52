// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <slamicp/simulation/person.hpp>

namespace slamicp {
namespace {

/// Where somebody is on their way.
struct Gait {
  Pose2 T_map_person;
  double swing = 0.0;  // of the left leg ahead of the middle, of the right one behind it [m]
};

/// One round of a way: corner after corner until the first again.
class WayRound {
 public:
  explicit WayRound(const Person& person) noexcept
      : person_(person), count_(person.way.size() < 2 ? 0 : legs_of(person)) {}

  double duration() const noexcept {
    double seconds = 0.0;
    for (std::size_t leg = 0; leg < count_; ++leg) seconds += walking(leg) + standing(leg) + turning(leg);
    return seconds;
  }

  /// @param seconds  since the first corner was left, from 0 to duration()
  Gait at(double seconds) const noexcept {
    for (std::size_t leg = 0; leg < count_; ++leg) {
      if (seconds < walking(leg)) return on_leg(leg, seconds);
      seconds -= walking(leg);
      if (seconds < standing(leg)) return {pose(corner(leg + 1), heading(leg))};
      seconds -= standing(leg);
      if (seconds < turning(leg)) {
        const double turned = std::copysign(person_turn_rate * seconds, turn_after(leg));
        return {pose(corner(leg + 1), heading(leg) + turned)};
      }
      seconds -= turning(leg);
    }
    return {pose(corner(0), heading(0))};
  }

 private:
  static std::size_t legs_of(const Person& person) noexcept {
    return person.is_loop ? person.way.size() : 2 * (person.way.size() - 1);
  }
  static Pose2 pose(const Point2& at, double heading) noexcept { return {at.x(), at.y(), wrap_angle(heading)}; }

  /// Where leg k begins.
  const Point2& corner(std::size_t k) const noexcept {
    k %= count_;
    return person_.way[k < person_.way.size() ? k : count_ - k];
  }
  Point2 along(std::size_t leg) const noexcept { return corner(leg + 1) - corner(leg); }
  double heading(std::size_t leg) const noexcept {
    const Point2 ahead = along(leg);
    return std::atan2(ahead.y(), ahead.x());
  }

  double walking(std::size_t leg) const noexcept { return along(leg).norm() / person_.speed; }
  double standing(std::size_t leg) const noexcept {
    const bool is_end = leg + 1 == count_ || (!person_.is_loop && 2 * (leg + 1) == count_);
    return is_end ? person_.pause : 0.0;
  }
  double turn_after(std::size_t leg) const noexcept { return wrap_angle(heading((leg + 1) % count_) - heading(leg)); }
  double turning(std::size_t leg) const noexcept { return std::abs(turn_after(leg)) / person_turn_rate; }

  Gait on_leg(std::size_t leg, double seconds) const noexcept {
    const Point2 ahead = along(leg);
    const double length = ahead.norm();
    const double share = std::min(1.0, seconds * person_.speed / length);
    const double steps = std::max(1.0, std::round(length / person_.step_length));
    // A leg moves with speed * (1 +- swing * pi / step * cos(...)): with this swing it stands still in between.
    const double farthest = length / steps / std::numbers::pi;
    return {pose(corner(leg) + share * ahead, heading(leg)), farthest * std::sin(std::numbers::pi * steps * share)};
  }

  const Person& person_;
  std::size_t count_;  // of straights in a round
};

Gait gait_at(const Person& person, double stamp) noexcept {
  if (person.way.empty()) return {};
  if (person.way.size() == 1) return {{person.way[0].x(), person.way[0].y(), wrap_angle(person.heading)}};
  const WayRound round(person);
  const double duration = round.duration();
  const double seconds = std::fmod(person.start + stamp, duration);
  return round.at(seconds < 0.0 ? seconds + duration : seconds);
}

}  // namespace

std::string Person::problem() const {
  if (way.empty()) return "way has no corner: give at least where they stand";
  for (const Point2& point : way)
    if (!point.allFinite()) return "way has a corner that is not finite: give metres";
  for (std::size_t k = 1; k < way.size(); ++k)
    if (way[k] == way[k - 1]) return "way has the same corner twice in a row: leave one out";
  if (is_loop && way.size() > 1 && way.front() == way.back())
    return "way ends where it begins: a loop goes on to its first corner by itself";
  if (!(speed > 0.0 && std::isfinite(speed))) return "speed must be above 0 m/s; who stands has one corner";
  if (!std::isfinite(start)) return "start is not a finite number: give seconds";
  if (!(pause >= 0.0 && std::isfinite(pause))) return "pause must be 0 s or more";
  if (!std::isfinite(heading)) return "heading is not a finite number: give radians";
  if (!(leg_radius > 0.0 && std::isfinite(leg_radius))) return "leg_radius must be above 0 m";
  if (!(leg_distance >= 0.0 && std::isfinite(leg_distance))) return "leg_distance must be 0 m or more";
  if (!(step_length > 0.0 && std::isfinite(step_length))) return "step_length must be above 0 m";
  if (!(body_radius > 0.0 && std::isfinite(body_radius))) return "body_radius must be above 0 m";
  return {};
}

Pose2 pose_at(const Person& person, double stamp) noexcept { return gait_at(person, stamp).T_map_person; }

PersonOutline outline_at(const Person& person, double stamp) noexcept {
  const auto [T_map_person, swing] = gait_at(person, stamp);
  if (person.shape == PersonShape::body)
    return {{T_map_person.translation(), T_map_person.translation()}, 1, person.body_radius};
  const double aside = 0.5 * person.leg_distance;
  return {{T_map_person * Point2(swing, aside), T_map_person * Point2(-swing, -aside)}, 2, person.leg_radius};
}

}  // namespace slamicp
