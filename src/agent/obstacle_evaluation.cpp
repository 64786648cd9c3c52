// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <slamicp/agent/obstacle_evaluation.hpp>
#include <slamicp/error.hpp>

namespace slamicp {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double path_step = 0.05;  // of the way ahead that points are held against [m]

/// Where a point is beside the way ahead.
struct Place {
  double ahead;        // along the way, of the nearest place on it, from its start [m]
  double cross_track;  // positive to the left [m]
  double aside;        // from that place; at the ends of the way it need not be abreast [m]
};

}  // namespace

/// A stretch of a path as a polyline: a scan's points are many, and each is held against all of it. In the sharpest
/// curve that a robot takes, its chords are a millimetre off.
class ObstacleEvaluation::WayAhead {
 public:
  WayAhead(const SplinePath& path, double from, double to) {
    const double end = std::min(to, path.length());
    for (double distance = from; distance < end; distance += path_step)
      places_.push_back(path.at(distance).translation());
    places_.push_back(path.at(end).translation());
    if (places_.size() == 1) places_.insert(places_.begin(), path.at(end - path_step).translation());
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
  /// Beside the chord from place k - 1 to place k.
  Place beside(std::size_t k, const Point2& point) const noexcept {
    const Point2 chord = places_[k] - places_[k - 1];
    const Point2 off = point - places_[k - 1];
    const double length = chord.norm();
    if (!(length > 0.0)) return {static_cast<double>(k - 1) * path_step, 0.0, off.norm()};
    const double along = std::clamp(chord.dot(off) / length, 0.0, length);
    return {static_cast<double>(k - 1) * path_step + along, (chord.x() * off.y() - chord.y() * off.x()) / length,
            (off - along / length * chord).norm()};
  }

  PointCloud2 places_;
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
  return {};
}

ObstacleEvaluation::ObstacleEvaluation(const ObstacleEvaluationOptions& options)
    : options_(options), speed_limit_(infinity) {
  if (const std::string problem = options.problem(); !problem.empty())
    throw Error(problem, "ObstacleEvaluationOptions");
}

EvaluatedObstacle ObstacleEvaluation::judged(const WayAhead& way, const Fix& fix, const Obstacle& obstacle) const {
  EvaluatedObstacle result{obstacle, infinity, infinity, Decision::ignore};
  // Far from all of the way ahead: nothing to work out.
  const Point2 robot = fix.pose.translation();
  const double size = std::hypot(obstacle.box.width, obstacle.box.depth);
  if ((obstacle.box.centre - robot).norm() - 0.5 * size > reach() + options_.corridor_half_width) return result;
  for (const int point : obstacle.points) {
    const Place place = way.nearest(fix.pose * fix.scan.in_robot[static_cast<std::size_t>(point)]);
    if (std::abs(place.cross_track) < std::abs(result.cross_track)) result.cross_track = place.cross_track;
    if (place.aside < options_.corridor_half_width) result.ahead = std::min(result.ahead, place.ahead);
  }
  if (result.ahead < options_.stop_distance)
    result.decision = Decision::stop;
  else if (result.ahead < options_.slow_distance)
    result.decision = Decision::slow;
  return result;
}

void ObstacleEvaluation::update(const SplinePath& path, double travelled, const Fix& fix,
                                std::span<const Obstacle> obstacles) {
  evaluated_.clear();
  const WayAhead way(path, travelled, obstacles.empty() ? travelled : travelled + reach());
  Decision worst = Decision::ignore;
  double nearest = infinity;
  for (const Obstacle& obstacle : obstacles) {
    evaluated_.push_back(judged(way, fix, obstacle));
    worst = std::max(worst, evaluated_.back().decision);
    nearest = std::min(nearest, evaluated_.back().ahead);
  }
  in_a_row_ = worst == Decision::ignore ? 0 : in_a_row_ + 1;
  clear_ = worst == Decision::ignore ? clear_ + 1 : 0;
  if (in_a_row_ >= options_.confirmations) {
    decision_ = worst;
    // So slow that braking ends before the distance to keep.
    speed_limit_ = std::sqrt(2.0 * options_.braking * std::max(0.0, nearest - options_.stop_distance));
  } else if (clear_ >= options_.releases) {
    decision_ = Decision::ignore;
    speed_limit_ = infinity;
  }
}

}  // namespace slamicp
