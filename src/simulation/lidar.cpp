// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/simulation/lidar.hpp>

namespace slamicp {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double endless = std::numeric_limits<double>::infinity();

/// The directions that a thing spans, counter-clockwise from `lower` [rad].
struct Span {
  double lower = 0.0;
  double width = full_turn;
};

/// Both, the second one about where the first is.
Span joined(const Span& a, const Span& b) noexcept {
  const double offset = std::remainder(b.lower - a.lower, full_turn);
  const double lower = std::min(0.0, offset);
  return {a.lower + lower, std::max(a.width, offset + b.width) - lower};
}

// The beams of one sweep, and the nearest thing each has met so far. All in the laser's frame at the first beam.
class Fan {
 public:
  /// @param T_first_last  how the laser moves from the first beam to the last
  Fan(const LidarModel& lidar, const Pose2& T_first_last, std::vector<double>& ranges)
      : angle_min_(lidar.angle_min), angle_increment_(lidar.angle_increment), ranges_(ranges) {
    const auto beams = static_cast<std::size_t>(lidar.beams);
    ranges_.assign(beams, endless);
    directions_.resize(beams);
    origins_.assign(beams, Point2::Zero());
    const double last = std::max(1.0, static_cast<double>(beams) - 1.0);
    const Pose2::Tangent twist = T_first_last.log() / last;
    is_moving_ = !twist.isZero(0.0);
    angle_increment_ += twist[2];
    for (std::size_t i = 0; i < beams; ++i) {
      const double angle = angle_min_ + static_cast<double>(i) * angle_increment_;
      directions_[i] = {std::cos(angle), std::sin(angle)};
      if (is_moving_) origins_[i] = Pose2::exp(static_cast<double>(i) * twist).translation();
    }
    farthest_ = T_first_last.translation().norm();
  }

  void meet(const Segment& wall) noexcept {
    const Point2 along = wall.b - wall.a;
    const auto span_from = [&](const Point2& origin) -> Span {
      const Point2 a = wall.a - origin;
      const Point2 b = wall.b - origin;
      const double angle_a = std::atan2(a.y(), a.x());
      const double sweep = std::atan2(cross(a, b), a.dot(b));
      return {std::min(angle_a, angle_a + sweep), std::abs(sweep)};
    };
    const Span span = is_moving_ ? seen_on_the_way(span_from, distance(wall, origins_.front())) : span_from({0.0, 0.0});
    for_beams(span, [&](std::size_t beam) {
      const Point2& direction = directions_[beam];
      double& range = ranges_[beam];
      const Point2 a = wall.a - origins_[beam];
      const double offset = cross(a, along);
      if (offset == 0.0) return;  // seen edge on: no width, and its neighbours bound it
      const double slope = cross(direction, along);
      const double distance = offset / slope;
      if (!(distance >= 0.0 && distance < range)) return;
      // The beams were chosen by angle, with some slack: the ends decide. Walls that share a corner leave no gap.
      const double share = cross(a, direction) / slope;
      if (share >= -slack && share <= 1.0 + slack) range = distance;
    });
  }

  void meet(const Point2& centre, double radius) noexcept {
    const auto span_from = [&](const Point2& origin) -> Span { return span_of_round(centre - origin, radius); };
    const Span span = is_moving_ ? seen_on_the_way(span_from, centre.norm() - radius) : span_from({0.0, 0.0});
    for_beams(span, [&](std::size_t beam) { meet_round(centre - origins_[beam], radius, beam); });
  }

  /// A round thing that moves with constant velocity.
  /// @param first  its middle at the first beam
  /// @param last   and at the last
  void meet(const Point2& first, const Point2& last, double radius) noexcept {
    const std::size_t last_beam = ranges_.size() - 1;
    const Point2 step = (last - first) / std::max(1.0, static_cast<double>(last_beam));
    const auto seen_from = [&](std::size_t beam) -> Point2 {
      return first + static_cast<double>(beam) * step - origins_[beam];
    };
    Span span;
    if (first.norm() - radius >= 4.0 * (farthest_ + (last - first).norm())) {
      span = span_of_round(seen_from(0), radius);
      span = joined(span, span_of_round(seen_from(last_beam / 2), radius));
      span = widened(joined(span, span_of_round(seen_from(last_beam), radius)));
    }
    for_beams(span, [&](std::size_t beam) { meet_round(seen_from(beam), radius, beam); });
  }

 private:
  static constexpr double slack = 1e-9;

  static Span span_of_round(const Point2& to, double radius) noexcept {
    const double squared_distance = to.squaredNorm();
    const bool inside = squared_distance <= radius * radius;
    const double half_width = inside ? full_turn / 2.0 : std::asin(radius / std::sqrt(squared_distance));
    return {std::atan2(to.y(), to.x()) - half_width, 2.0 * half_width};
  }

  void meet_round(const Point2& to, double radius, std::size_t beam) noexcept {
    const double miss = cross(directions_[beam], to);
    const double squared_half_chord = radius * radius - miss * miss;
    if (squared_half_chord < 0.0) return;
    const double half_chord = std::sqrt(squared_half_chord);
    const bool inside = to.squaredNorm() <= radius * radius;
    const double distance = directions_[beam].dot(to) + (inside ? half_chord : -half_chord);
    if (distance >= 0.0 && distance < ranges_[beam]) ranges_[beam] = distance;
  }

  /// By what looks at the first, the middle and the last beam may miss.
  static Span widened(const Span& span) noexcept {
    constexpr double between = 0.02;  // [rad]
    return {span.lower - between, span.width + 2.0 * between};
  }

  /// What a thing spans as the laser goes by.
  /// @param distance  from the laser at the first beam [m]; negative inside
  template <typename SpanFrom>
  Span seen_on_the_way(const SpanFrom& span_from, double distance) const noexcept {
    if (distance < 4.0 * farthest_) return {};
    Span span = span_from(origins_.front());
    span = joined(span, span_from(origins_[origins_.size() / 2]));
    return widened(joined(span, span_from(origins_.back())));
  }

  // Calls visit(beam) for the beams within the span, which the seam of the turn may cut in two.
  template <typename Visit>
  void for_beams(const Span& span, const Visit& visit) noexcept {
    const double lower_beam = positive_remainder(span.lower - angle_min_) / angle_increment_;
    const double width_in_beams = std::min(span.width, full_turn) / angle_increment_;
    const double turn_in_beams = full_turn / angle_increment_;
    const double last_beam = static_cast<double>(ranges_.size()) - 1.0;
    for (double start = lower_beam - turn_in_beams; start <= last_beam; start += turn_in_beams) {
      const double first = std::max(0.0, std::ceil(start - 1e-6));
      const double last = std::min(last_beam, std::floor(start + width_in_beams + 1e-6));
      if (last < first) continue;
      const auto end = static_cast<std::size_t>(last) + 1;
      for (auto i = static_cast<std::size_t>(first); i < end; ++i) visit(i);
    }
  }

  static double positive_remainder(double angle) noexcept { return angle - full_turn * std::floor(angle / full_turn); }

  double angle_min_;
  double angle_increment_;  // from beam to beam, as the laser turns with the robot
  bool is_moving_ = false;
  double farthest_ = 0.0;  // that it gets [m]
  std::vector<Point2> directions_;
  std::vector<Point2> origins_;
  std::vector<double>& ranges_;
};

}  // namespace

std::string LidarModel::problem() const {
  if (beams < 1) return "beams is " + std::to_string(beams) + ": give at least 1";
  if (!std::isfinite(angle_min)) return "angle_min is not a finite number: give radians";
  if (!(angle_increment > 0.0)) return "angle_increment must be above 0 rad: count beams counter-clockwise";
  if (!(angle_increment * (beams - 1) < full_turn * (1.0 + 1e-9)))
    return "the beams span more than one turn: give fewer";
  if (!(range_min >= 0.0 && range_max > range_min)) return "ranges must be 0 <= range_min < range_max [m]";
  if (!(rate > 0.0)) return "rate must be above 0 Hz";
  if (!(sweep_time >= 0.0 && std::isfinite(sweep_time))) return "sweep_time must be 0 s or more";
  if (!(range_noise >= 0.0 && std::isfinite(range_noise))) return "range_noise must be 0 m or more";
  if (!(noise_per_metre >= 0.0 && std::isfinite(noise_per_metre))) return "noise_per_metre must be 0 or more";
  if (!(bias >= 0.0 && std::isfinite(bias))) return "bias must be 0 m or more";
  if (!(bias_period > 0.0)) return "bias_period must be above 0 m";
  if (!(dropouts >= 0.0 && dropouts <= 1.0)) return "dropouts is a share: give 0 to 1";
  if (!(mixed_pixels >= 0.0 && mixed_pixels <= 1.0)) return "mixed_pixels is a share: give 0 to 1";
  if (!T_robot_laser.is_finite()) return "T_robot_laser is not finite: give metres and radians";
  return {};
}

LidarModel hokuyo_utm30lx(double range_noise) {
  LidarModel lidar;
  lidar.beams = 1081;
  lidar.angle_min = -0.75 * std::numbers::pi;
  lidar.angle_increment = std::numbers::pi / 720.0;
  lidar.range_min = 0.1;
  lidar.range_max = 30.0;
  lidar.rate = 40.0;
  lidar.range_noise = range_noise;
  return lidar;
}

LidarModel real_hokuyo_utm30lx() {
  LidarModel lidar = hokuyo_utm30lx(0.01);
  lidar.sweep_time = 0.025;
  lidar.noise_per_metre = 0.0005;
  lidar.bias = 0.01;
  lidar.dropouts = 0.002;
  lidar.mixed_pixels = 0.3;
  return lidar;
}

void true_ranges(const World& world, const Pose2& T_map_laser, const LidarModel& lidar, std::vector<double>& ranges,
                 double stamp) {
  true_ranges(world, T_map_laser, {}, lidar, ranges, stamp);
}

void true_ranges(const World& world, const Pose2& T_map_laser, const Pose2& T_first_last, const LidarModel& lidar,
                 std::vector<double>& ranges, double stamp) {
  if (const std::string problem = lidar.problem(); !problem.empty()) throw Error(problem, "LidarModel");
  if (!(T_first_last.log().norm() < 1.0) || std::abs(T_first_last.theta) > 0.5 * lidar.angle_increment * lidar.beams)
    throw Error("the laser moves by " + to_string(T_first_last) + " during a sweep", "true_ranges",
                "a sweep of a slower robot, or of a faster laser: less than 1 m, 1 rad and half of what it sweeps");
  Fan fan(lidar, T_first_last, ranges);
  const RigidTransform<2> T_laser_map(T_map_laser.inverse());
  const auto meet_segment = [&](const Segment& wall) { fan.meet({T_laser_map * wall.a, T_laser_map * wall.b}); };

  for (const Segment& wall : world.walls) meet_segment(wall);
  for (const Circle& pillar : world.pillars) fan.meet(T_laser_map * pillar.centre, pillar.radius);
  for (const PlacedObstacle& obstacle : world.obstacles) {
    for (const Box& box : obstacle.boxes)
      for (const Segment& side : sides(box)) meet_segment(side);
    for (const Cylinder& cylinder : obstacle.cylinders) fan.meet(T_laser_map * cylinder.centre, cylinder.radius);
  }
  for (const Door& door : world.doors)
    for (const Segment& side : sides(leaf(door, door.opening))) meet_segment(side);
  for (const Person& person : world.people) {
    const PersonOutline first = outline_at(person, stamp);
    const PersonOutline last = outline_at(person, stamp + lidar.sweep_time);
    for (std::size_t k = 0; k < first.count; ++k)
      fan.meet(T_laser_map * first.centres[k], T_laser_map * last.centres[k], first.radius);
  }
}

namespace {

/// A beam that hits an edge sees some of both sides.
void mix_pixels(const LidarModel& lidar, Random& random, std::vector<double>& ranges) {
  if (!(lidar.mixed_pixels > 0.0)) return;
  constexpr double edge = 0.1;  // [m]
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const bool mixed = random.uniform() < lidar.mixed_pixels;
    const double share = random.uniform();
    if (!mixed || i + 1 == ranges.size()) continue;
    const double step = std::min(ranges[i + 1], lidar.range_max) - std::min(ranges[i], lidar.range_max);
    if (std::abs(step) > edge) ranges[i] = std::min(ranges[i], lidar.range_max) + share * step;
  }
}

}  // namespace

LaserScan scan(const World& world, const Pose2& T_map_robot, const LidarModel& lidar, Random& random, double stamp) {
  return scan(world, T_map_robot, {}, lidar, random, stamp);
}

LaserScan scan(const World& world, const Pose2& T_map_robot, const Pose2& sweep_motion, const LidarModel& lidar,
               Random& random, double stamp) {
  std::vector<double> ranges;
  const Pose2 of_laser = lidar.T_robot_laser.inverse() * sweep_motion * lidar.T_robot_laser;
  true_ranges(world, T_map_robot * lidar.T_robot_laser, of_laser, lidar, ranges, stamp);

  LaserScan result;
  result.stamp = stamp;
  result.time_increment = lidar.beams > 1 ? lidar.sweep_time / (lidar.beams - 1) : 0.0;
  result.angle_min = lidar.angle_min;
  result.angle_increment = lidar.angle_increment;
  result.range_min = lidar.range_min;
  result.range_max = lidar.range_max;
  result.T_robot_laser = lidar.T_robot_laser;
  result.ranges.reserve(ranges.size());
  mix_pixels(lidar, random, ranges);
  for (const double range : ranges) {
    const double sigma = lidar.range_noise + lidar.noise_per_metre * std::min(range, lidar.range_max);
    double reading = range + sigma * random.normal();
    if (lidar.bias > 0.0) reading += lidar.bias * std::sin(full_turn * range / lidar.bias_period);
    const bool lost = lidar.dropouts > 0.0 && random.uniform() < lidar.dropouts;
    const auto stored = static_cast<float>(reading);
    const bool seen = !lost && range >= lidar.range_min && range < lidar.range_max && is_return(result, stored);
    result.ranges.push_back(seen ? stored : 0.0F);
  }
  return result;
}

}  // namespace slamicp
