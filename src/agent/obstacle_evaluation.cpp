// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <slamicp/agent/obstacle_evaluation.hpp>
#include <slamicp/error.hpp>

namespace slamicp {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a point is beside the way ahead.
struct Place {
  double ahead;        // along the way, of the nearest place on it, from its start [m]
  double cross_track;  // positive to the left [m]
  double aside;        // from that place; at the ends of the way it need not be abreast [m]
};

}  // namespace

/// A stretch of a path's polyline: a scan's points are many, and each is held against all of it.
class ObstacleEvaluation::WayAhead {
 public:
  WayAhead(const SplinePath& path, double from, double to) noexcept : from_(std::clamp(from, 0.0, path.length())) {
    const PointView<2> all = path.places();
    first_ = std::min(static_cast<std::size_t>(from_ / SplinePath::place_spacing), all.size() - 2);
    const auto last = static_cast<std::size_t>(std::ceil(std::max(from_, to) / SplinePath::place_spacing));
    places_ = all.subspan(first_, std::clamp(last, first_ + 1, all.size() - 1) - first_ + 1);
  }

  Place nearest(const Point2& point) const noexcept {
    std::size_t corner = 0;
    double least = infinity;
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (const double here = (point - places_[k]).squaredNorm(); here < least) {
        corner = k;
        least = here;
      }
    Place best{0.0, 0.0, infinity};
    for (std::size_t k = std::max<std::size_t>(corner, 1); k <= corner + 1 && k < places_.size(); ++k)
      if (const Place here = beside(k, point); here.aside < best.aside) best = here;
    return best;
  }

 private:
  /// Beside the chord from place k - 1 to place k, of the first one what is ahead.
  Place beside(std::size_t k, const Point2& point) const noexcept {
    const Point2 chord = places_[k] - places_[k - 1];
    const Point2 off = point - places_[k - 1];
    const double length = chord.norm();
    const double start = static_cast<double>(first_ + k - 1) * SplinePath::place_spacing;
    if (!(length > 0.0)) return {start - from_, 0.0, off.norm()};
    const double along = std::clamp(chord.dot(off) / length, std::clamp(from_ - start, 0.0, length), length);
    return {start + along - from_, cross(chord, off) / length, (off - along / length * chord).norm()};
  }

  double from_;
  std::size_t first_;
  PointView<2> places_;
};

const char* to_string(Decision decision) noexcept {
  switch (decision) {
    case Decision::ignore:
      return "ignore";
    case Decision::slow:
      return "slow";
    case Decision::stop:
      return "stop";
  }
  return "unknown";
}

std::string ObstacleEvaluationOptions::problem() const {
  if (!(corridor_half_width > 0.0)) return "corridor_half_width must be above 0 m: half of the robot and a margin";
  if (!(stop_distance > 0.0)) return "stop_distance must be above 0 m";
  if (!(slow_distance > stop_distance)) return "slow_distance must be above stop_distance";
  if (!(braking > 0.0)) return "braking must be above 0 m/s^2";
  if (confirmations < 1 || releases < 1) return "confirmations and releases must be at least 1";
  if (!(stop_time > 0.0)) return "stop_time must be above 0 s";
  if (!(slow_time > stop_time)) return "slow_time must be above stop_time";
  if (!(latest > 0.0)) return "latest must be above 0 s";
  for (const ExclusionZone& zone : exclusion_zones)
    if (std::string problem = zone.problem(); !problem.empty()) return problem;
  return {};
}

ObstacleEvaluation::ObstacleEvaluation(const ObstacleEvaluationOptions& options)
    : options_(options), speed_limit_(infinity), stamp_(-infinity) {
  if (const std::string problem = options.problem(); !problem.empty())
    throw Error(problem, "ObstacleEvaluationOptions");
}

void ObstacleEvaluation::reserve(std::size_t obstacles, std::size_t points) {
  if (evaluated_.size() < obstacles) evaluated_.resize(obstacles);
  for (EvaluatedObstacle& it : evaluated_) it.obstacle.points.reserve(points);
}

void ObstacleEvaluation::judge(const WayAhead& way, const Fix& fix, EvaluatedObstacle& it) const {
  it.ahead = infinity;
  it.cross_track = infinity;
  it.decision = Decision::ignore;
  // Far from all of the way ahead: nothing to work out.
  const OrientedBox& box = it.obstacle.box;
  const Point2 robot = fix.pose.translation();
  if ((box.centre - robot).norm() - 0.5 * std::hypot(box.width, box.depth) > reach() + options_.corridor_half_width)
    return;
  const RigidTransform<2> T_map_robot(fix.pose);
  double least_aside = infinity;
  // A point this near to the last one looked at is neither in the corridor nor nearer to the way than another one.
  double spare = 0.0;
  Point2 looked_at = robot;
  for (const int point : it.obstacle.points) {
    const Point2 in_map = T_map_robot * fix.scan.in_robot[static_cast<std::size_t>(point)];
    if (!options_.exclusion_zones.empty() && is_excluded(in_map, fix)) continue;
    if (spare > 0.0 && (in_map - looked_at).squaredNorm() < spare * spare) continue;
    const Place place = way.nearest(in_map);
    if (place.aside < options_.corridor_half_width) it.ahead = std::min(it.ahead, place.ahead);
    if (place.aside < least_aside) {
      least_aside = place.aside;
      it.cross_track = place.cross_track;
    }
    spare = place.aside - std::max(least_aside, options_.corridor_half_width);
    looked_at = in_map;
  }
  if (it.ahead < options_.stop_distance)
    it.decision = Decision::stop;
  else if (it.ahead < options_.slow_distance)
    it.decision = Decision::slow;
}

bool ObstacleEvaluation::is_excluded(const Point2& in_map, const Fix& fix) const noexcept {
  return std::any_of(options_.exclusion_zones.begin(), options_.exclusion_zones.end(),
                     [&](const ExclusionZone& zone) { return zone.contains(in_map, fix.pose); });
}

/// Until a track that goes on as it does meets the robot that follows its path, or that has stopped where it is.
double ObstacleEvaluation::seconds_to(const Track& track, const SplinePath& path, double travelled, const Fix& fix,
                                      double speed) const noexcept {
  constexpr double step = 0.1;  // [s]
  const double reach = options_.corridor_half_width + 0.5 * track.width;
  for (double seconds = 0.0; seconds <= options_.slow_time; seconds += step) {
    const Point2 there = track.position + seconds * track.velocity;
    const Point2 on_the_way = path.at(std::min(travelled + seconds * speed, path.length())).translation();
    if ((there - on_the_way).norm() < reach || (there - fix.pose.translation()).norm() < reach) return seconds;
  }
  return infinity;
}

/// @param nearest  along the path, of what the robot would meet [m]
Decision ObstacleEvaluation::judge_tracks(const SplinePath& path, double travelled, const Fix& fix,
                                          std::span<const Track> tracks, double speed, double& nearest) {
  Decision worst = Decision::ignore;
  for (const Track& track : tracks) {
    const bool moves = track.motion == TrackMotion::moving && track.state != TrackState::tentative;
    const double seconds =
        moves && !is_excluded(track.position, fix) ? seconds_to(track, path, travelled, fix, speed) : infinity;
    const Decision decision = seconds < options_.stop_time ? Decision::stop
                              : seconds < infinity         ? Decision::slow
                                                           : Decision::ignore;
    for (const int seen_as : track.obstacles) {
      if (seen_as < 0 || static_cast<std::size_t>(seen_as) >= count_) continue;
      EvaluatedObstacle& it = evaluated_[static_cast<std::size_t>(seen_as)];
      it.track = track.id;
      it.seconds = seconds;
      it.decision = std::max(it.decision, decision);
    }
    worst = std::max(worst, decision);
    if (decision == Decision::stop) nearest = 0.0;
    if (decision == Decision::slow)  // the later, the faster the robot may go until then
      nearest = std::min(nearest, options_.stop_distance + speed * (seconds - options_.stop_time));
  }
  return worst;
}

void ObstacleEvaluation::update(const SplinePath& path, double travelled, const Fix& fix,
                                std::span<const Obstacle> obstacles, std::span<const Track> tracks, double speed) {
  const WayAhead way(path, travelled, travelled + reach());
  Decision worst = Decision::ignore;
  double nearest = infinity;
  if (evaluated_.size() < obstacles.size()) evaluated_.resize(obstacles.size());
  count_ = obstacles.size();
  for (std::size_t k = 0; k < count_; ++k) {
    evaluated_[k].obstacle = obstacles[k];
    evaluated_[k].track = 0;
    evaluated_[k].seconds = infinity;
    judge(way, fix, evaluated_[k]);
    worst = std::max(worst, evaluated_[k].decision);
    nearest = std::min(nearest, evaluated_[k].ahead);
  }
  const Decision of_tracks = judge_tracks(path, travelled, fix, tracks, speed, nearest);
  worst = std::max(worst, of_tracks);
  const bool is_nowhere = fix.nowhere();
  if (is_nowhere) {
    worst = Decision::stop;
    nearest = 0.0;
  }
  stamp_ = fix.stamp;
  in_a_row_ = worst == Decision::ignore ? 0 : in_a_row_ + 1;
  clear_ = worst == Decision::ignore ? clear_ + 1 : 0;
  if (in_a_row_ >= options_.confirmations || of_tracks != Decision::ignore || is_nowhere) {
    decision_ = worst;
    // So slow that braking ends before the distance to keep.
    speed_limit_ = std::sqrt(2.0 * options_.braking * std::max(0.0, nearest - options_.stop_distance));
  } else if (clear_ >= options_.releases) {
    decision_ = Decision::ignore;
    speed_limit_ = infinity;
  }
}

Decision ObstacleEvaluation::decision_at(double now) const noexcept {
  return now - stamp_ <= options_.latest ? decision_ : Decision::stop;
}

}  // namespace slamicp
