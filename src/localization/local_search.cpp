// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/localization/local_search.hpp>
#include <slamicp/registration/icp.hpp>

#include "localization/judge.hpp"

namespace slamicp {

std::string LocalSearchOptions::problem() const {
  if (!(radius > 0.0 && radius <= 20.0)) return "radius must be above 0, at most 20 m";
  if (!(step >= 0.01)) return "step must be at least 0.01 m";
  if (!(heading_step >= 0.02 && heading_step <= 1.0)) return "heading_step must be 0.02 to 1 rad";
  if (points < 10 || points > 500) return "points must be 10 to 500";
  if (matches < 1 || matches > 200) return "matches must be 1 to 200";
  if (!(lead >= 0.0)) return "lead must be at least 0";
  return {};
}

namespace {

bool is_same_place(const Pose2& a, const Pose2& b, double translation, double rotation) noexcept {
  const PoseDistance apart = distance(a, b);
  return apart.translation < translation && apart.rotation < rotation;
}

PointCloud2 some_of(const PointCloud2& points, int count) {
  const std::size_t kept = std::min(points.size(), static_cast<std::size_t>(count));
  PointCloud2 some;
  some.reserve(kept);
  for (std::size_t k = 0; k < kept; ++k) some.push_back(points[evenly_chosen(k, kept, points.size())]);
  return some;
}

/// Offsets of a grid within the radius, from near to far.
std::vector<Point2> places_within(double radius, double step) {
  const int most = static_cast<int>(std::floor(radius / step));
  std::vector<Point2> places;
  for (int row = -most; row <= most; ++row)
    for (int column = -most; column <= most; ++column)
      if (const Point2 place(column * step, row * step); place.norm() <= radius) places.push_back(place);
  std::stable_sort(places.begin(), places.end(),
                   [](const Point2& a, const Point2& b) { return a.squaredNorm() < b.squaredNorm(); });
  return places;
}

constexpr int price_of_match = 50;  // places

}  // namespace

struct LocalSearch::State {
  /// A place and what speaks for it: points that end near surfaces, later log odds.
  struct Candidate {
    Pose2 pose;
    double score = 0.0;
  };
  static bool is_better(const Candidate& a, const Candidate& b) noexcept { return a.score > b.score; }

  PointMap2::Pointer map;
  ScanPoints scan;
  Point2 origin;
  Pose2 around;
  LocalSearchOptions options;
  double match_distance;
  Icp<2> icp;

  PointCloud2 some;            // of the scan's points, in the robot's frame
  std::vector<Point2> places;  // offsets from `around`
  int headings;
  std::vector<Candidate> best;     // so far, the worst first: a heap
  std::vector<Candidate> matched;  // those that were matched
  std::size_t next_place = 0;
  int next_heading = 0;
  bool all_looked_at = false;

  bool done() const noexcept { return all_looked_at && best.empty(); }
  void look_at_next();
  void keep(const Candidate& candidate);
  void match_next();
};

void LocalSearch::State::look_at_next() {
  const double heading = around.theta + next_heading * (2.0 * std::numbers::pi / headings);
  const Point2 place = around.translation() + places[next_place];
  Candidate candidate{{place.x(), place.y(), wrap_angle(heading)}, 0.0};
  const RigidTransform<2> T_map_robot(candidate.pose);
  const double reach2 = match_distance * match_distance;
  for (const Point2& point : some) {
    const Neighbour nearest = map->indexed().nearest(T_map_robot * point, match_distance);
    if (nearest.found()) candidate.score += 1.0 - nearest.squared_distance / reach2;
  }
  keep(candidate);
  if (++next_heading < headings) return;
  next_heading = 0;
  if (++next_place < places.size()) return;
  all_looked_at = true;
  std::sort(best.begin(), best.end(), [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
}

/// Keeps the best, of those that lead to one match only the best one.
void LocalSearch::State::keep(const Candidate& candidate) {
  for (Candidate& other : best)
    if (is_same_place(other.pose, candidate.pose, 1.5 * options.step, 1.5 * options.heading_step)) {
      if (!is_better(candidate, other)) return;
      other = candidate;
      std::make_heap(best.begin(), best.end(), is_better);
      return;
    }
  if (best.size() == static_cast<std::size_t>(options.matches)) {
    if (!is_better(candidate, best.front())) return;
    std::pop_heap(best.begin(), best.end(), is_better);
    best.pop_back();
  }
  best.push_back(candidate);
  std::push_heap(best.begin(), best.end(), is_better);
}

void LocalSearch::State::match_next() {
  constexpr int rays = 128;
  const Candidate candidate = best.back();
  best.pop_back();
  const IcpResult2& result = icp.align(map->indexed(), scan.in_robot, candidate.pose);
  if (!result.usable() && result.stop != Stop::degenerate) return;
  const double noise = std::max(0.01, map->indexed().line_noise().across);
  const Evidence evidence = look(map->indexed(), {scan, {&origin, 1}, result.pose}, rays, match_distance, noise);
  matched.push_back({result.pose, log_odds(evidence)});
}

LocalSearch::LocalSearch(PointMap2::Pointer map, ScanPoints scan, const Point2& origin, const Pose2& around,
                         const IcpOptions& icp, const LocalSearchOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "LocalSearchOptions");
  if (!map) throw Error("the map is null", "LocalSearch", "make one with PointMap2::create, or load_map");
  scan.scans.clear();  // all rays as from one place
  PointCloud2 some = some_of(scan.in_robot, options.points);
  std::vector<Point2> places = places_within(options.radius, options.step);
  const int headings = static_cast<int>(std::ceil(2.0 * std::numbers::pi / options.heading_step));
  state_ = std::make_unique<State>(State{.map = std::move(map),
                                         .scan = std::move(scan),
                                         .origin = origin,
                                         .around = around,
                                         .options = options,
                                         .match_distance = icp.max_correspondence_distance,
                                         .icp = Icp<2>(icp),
                                         .some = std::move(some),
                                         .places = std::move(places),
                                         .headings = headings,
                                         .best = {},
                                         .matched = {}});
}

LocalSearch::~LocalSearch() = default;
LocalSearch::LocalSearch(LocalSearch&&) noexcept = default;
LocalSearch& LocalSearch::operator=(LocalSearch&&) noexcept = default;

bool LocalSearch::step(int budget) {
  State& state = *state_;
  while (budget > 0 && !state.done()) {
    if (!state.all_looked_at) {
      state.look_at_next();
      --budget;
    } else {
      state.match_next();
      budget -= price_of_match;
    }
  }
  return state.done();
}

std::optional<FoundPlace> LocalSearch::found() const {
  const State& state = *state_;
  if (!state.done() || state.matched.empty()) return {};
  const auto best = std::min_element(state.matched.begin(), state.matched.end(), State::is_better);
  FoundPlace found{best->pose, probability_of(best->score), true};
  for (const State::Candidate& other : state.matched)
    if (!is_same_place(best->pose, other.pose, 0.5, 0.25) && other.score > best->score - state.options.lead)
      found.unique = false;
  return found;
}

}  // namespace slamicp
