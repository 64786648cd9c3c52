// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/simulation/crowd.hpp>
#include <slamicp/simulation/random.hpp>

#include "simulation/clearance.hpp"

namespace slamicp {
namespace {

constexpr int most_tries = 500;
constexpr double group_distance = 0.5;  // of who stands from the route, and from who else stands [m]

/// Finds people places about a route. What a place asks for is in `try_...`: nothing, where chance chose badly.
class CrowdPlanner {
 public:
  CrowdPlanner(const World& world, std::span<const Point2> route, const CrowdOptions& options)
      : options_(options), clearance_(world), route_(route), random_(Random(options.seed).stream(4)) {
    for (const Pose2& pose : route_.sampled(0.1)) taken_.push_back(pose.translation());
    for (const Person& person : world.people)
      if (person.way.size() == 1) taken_.push_back(person.way[0]);
  }

  std::vector<Person> people() {
    std::vector<Person> people;
    const auto wanted = static_cast<std::size_t>(options_.people);
    for (int tries = 0; people.size() < wanted; ++tries) {
      if (tries == most_tries)
        throw Error(
            "there is no room for person " + std::to_string(people.size() + 1) + " of " + std::to_string(wanted),
            "CrowdOptions", "ask for fewer people, another layout, or a smaller clearance");
      std::vector<Person> more = try_some(wanted - people.size());
      if (!more.empty()) tries = -1;
      std::move(more.begin(), more.end(), std::back_inserter(people));
    }
    return people;
  }

 private:
  std::vector<Person> try_some(std::size_t most) {
    const double middle = random_.uniform(0.0, route_.length());
    const Pose2 place = route_.at(middle);
    if (options_.layout == CrowdLayout::groups) return try_group(place, most);
    PointCloud2 way;
    if (options_.layout == CrowdLayout::crossing) way = try_crossing(place);
    if (options_.layout == CrowdLayout::along) way = try_along(middle);
    if (options_.layout == CrowdLayout::random_walk) way = try_random_walk(place);
    if (way.size() < 2) return {};
    Person person;
    person.way = std::move(way);
    person.speed = random_.uniform(0.8, 1.5);
    person.start = random_.uniform(0.0, 60.0);
    person.pause = random_.uniform(0.0, 2.0);
    return {person};
  }

  bool is_free(const Point2& a, const Point2& b) const noexcept {
    return clearance_.is_clear(a, b, options_.clearance);
  }
  /// No wall between them, at least: a robot may pass nearer to things than people do.
  bool is_in_sight(const Pose2& place, const Point2& point) const noexcept {
    return clearance_.is_clear(place.translation(), point, 0.01);
  }

  /// As far as one can go from a place, 4 m at most.
  Point2 reach(const Point2& from, const Point2& direction) const noexcept {
    constexpr double step = 0.25;
    Point2 end = from;
    for (int k = 1; k <= 16; ++k) {
      const Point2 next = from + k * step * direction;
      if (!is_free(end, next)) break;
      end = next;
    }
    return end;
  }

  PointCloud2 try_crossing(const Pose2& place) {
    const double angle = place.theta + 0.5 * std::numbers::pi + random_.uniform(-0.4, 0.4);
    const Point2 across(std::cos(angle), std::sin(angle));
    const Point2 left = reach(place.translation(), across);
    const Point2 right = reach(place.translation(), -across);
    return (left - right).norm() < 0.75 ? PointCloud2{} : PointCloud2{left, right};
  }

  PointCloud2 try_along(double middle) {
    const double aside = random_.uniform(0.4, 1.2) * (random_.uniform() < 0.5 ? -1.0 : 1.0);
    const auto beside = [&](double distance) -> Point2 { return route_.at(distance) * Point2(0.0, aside); };
    if (!is_in_sight(route_.at(middle), beside(middle))) return {};
    const auto go = [&](double direction) {
      PointCloud2 way = {beside(middle)};
      for (double gone = 1.0; gone <= 5.0; gone += 1.0) {
        const double distance = middle + direction * gone;
        if (distance < 0.0 || distance > route_.length() || !is_free(way.back(), beside(distance))) break;
        way.push_back(beside(distance));
      }
      return way;
    };
    PointCloud2 way = go(-1.0);
    std::reverse(way.begin(), way.end());
    const PointCloud2 ahead = go(1.0);
    way.insert(way.end(), ahead.begin() + 1, ahead.end());
    return way.size() < 3 ? PointCloud2{} : way;
  }

  PointCloud2 try_random_walk(const Pose2& place) {
    const Point2 start = place * Point2(0.0, random_.uniform(-1.5, 1.5));
    if (!is_in_sight(place, start) || !is_free(start, start)) return {};
    PointCloud2 way = {start};
    for (int tries = 0; tries < 100 && way.size() < 12; ++tries) {
      const double angle = random_.uniform(-std::numbers::pi, std::numbers::pi);
      const double length = random_.uniform(1.0, 4.0);
      const Point2 next = way.back() + length * Point2(std::cos(angle), std::sin(angle));
      if (is_free(way.back(), next)) way.push_back(next);
    }
    return way;
  }

  std::vector<Person> try_group(const Pose2& place, std::size_t most) {
    const std::size_t wanted = std::min(most, 2 + static_cast<std::size_t>(random_.uniform(0.0, 3.0)));
    const double aside = random_.uniform(0.6, 2.2) * (random_.uniform() < 0.5 ? -1.0 : 1.0);
    const Point2 middle = place * Point2(0.0, aside);
    const double turned = random_.uniform(-std::numbers::pi, std::numbers::pi);
    std::vector<Person> group;
    for (std::size_t k = 0; k < wanted; ++k) {
      const double angle = turned + 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(wanted);
      const Point2 stand = middle + 0.4 * Point2(std::cos(angle), std::sin(angle));
      if (!is_free(stand, stand) || !is_in_sight(place, stand) || is_taken(stand)) return {};
      Person person;
      person.way = {stand};
      person.heading = wrap_angle(angle + std::numbers::pi);
      group.push_back(std::move(person));
    }
    for (const Person& person : group) taken_.push_back(person.way[0]);
    return group;
  }

  bool is_taken(const Point2& point) const noexcept {
    return std::any_of(taken_.begin(), taken_.end(),
                       [&](const Point2& other) { return (other - point).norm() < group_distance; });
  }

  CrowdOptions options_;
  Clearance clearance_;
  SplinePath route_;
  PointCloud2 taken_;  // by the robot's way, and by who stands
  Random random_;
};

}  // namespace

const char* to_string(CrowdLayout layout) noexcept {
  switch (layout) {
    case CrowdLayout::crossing:
      return "crossing";
    case CrowdLayout::along:
      return "along";
    case CrowdLayout::groups:
      return "groups";
    case CrowdLayout::random_walk:
      return "random_walk";
  }
  return "unknown";
}

std::string CrowdOptions::problem() const {
  if (people < 0 || people > 1000) return "people is " + std::to_string(people) + ": give 0 to 1000";
  if (!(clearance > 0.0 && std::isfinite(clearance))) return "clearance must be above 0 m";
  return {};
}

World with_crowd(World world, std::span<const Point2> route, const CrowdOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "CrowdOptions");
  std::vector<Person> crowd = CrowdPlanner(world, route, options).people();
  for (std::size_t k = 0; k < crowd.size(); ++k) {
    crowd[k].name = "person " + std::to_string(k + 1);
    world.people.push_back(std::move(crowd[k]));
  }
  return world;
}

}  // namespace slamicp
