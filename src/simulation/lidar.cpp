// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/simulation/lidar.hpp>

namespace slamicp {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

double cross(const Point2& a, const Point2& b) noexcept { return a.x() * b.y() - a.y() * b.x(); }

// The beams of one sweep, and the nearest thing each has met so far. All in the laser's frame.
class Fan {
 public:
  Fan(const LidarModel& lidar, std::vector<double>& ranges)
      : angle_min_(lidar.angle_min), angle_increment_(lidar.angle_increment), ranges_(ranges) {
    const auto beams = static_cast<std::size_t>(lidar.beams);
    ranges_.assign(beams, infinity);
    directions_.resize(beams);
    for (std::size_t i = 0; i < beams; ++i) {
      const double angle = angle_min_ + static_cast<double>(i) * angle_increment_;
      directions_[i] = {std::cos(angle), std::sin(angle)};
    }
  }

  void meet(const Segment& wall) noexcept {
    const Point2 along = wall.b - wall.a;
    const double offset = cross(wall.a, along);
    if (offset == 0.0) return;  // seen edge on: no width, and its neighbours bound it
    const double angle_a = std::atan2(wall.a.y(), wall.a.x());
    const double sweep = std::atan2(cross(wall.a, wall.b), wall.a.dot(wall.b));
    for_beams(std::min(angle_a, angle_a + sweep), std::abs(sweep), [&](const Point2& direction, double& range) {
      const double slope = cross(direction, along);
      const double distance = offset / slope;
      if (!(distance >= 0.0 && distance < range)) return;
      // The beams were chosen by angle, with some slack: the ends decide. Walls that share a corner leave no gap.
      const double share = cross(wall.a, direction) / slope;
      if (share >= -slack && share <= 1.0 + slack) range = distance;
    });
  }

  void meet(const Point2& centre, double radius) noexcept {
    const double squared_distance = centre.squaredNorm();
    const bool inside = squared_distance <= radius * radius;
    const double half_width = inside ? turn / 2.0 : std::asin(radius / std::sqrt(squared_distance));
    const double middle = std::atan2(centre.y(), centre.x());
    for_beams(middle - half_width, 2.0 * half_width, [&](const Point2& direction, double& range) {
      const double miss = cross(direction, centre);
      const double squared_half_chord = radius * radius - miss * miss;
      if (squared_half_chord < 0.0) return;
      const double half_chord = std::sqrt(squared_half_chord);
      const double distance = direction.dot(centre) + (inside ? half_chord : -half_chord);
      if (distance >= 0.0 && distance < range) range = distance;
    });
  }

 private:
  static constexpr double slack = 1e-9;

  // Calls visit for the beams from angle `lower` on, `width` wide: at most a turn, which the seam may cut in two.
  template <typename Visit>
  void for_beams(double lower, double width, const Visit& visit) noexcept {
    const double lower_beam = positive_remainder(lower - angle_min_) / angle_increment_;
    const double width_in_beams = width / angle_increment_;
    const double turn_in_beams = turn / angle_increment_;
    for (const double start : {lower_beam - turn_in_beams, lower_beam}) {
      const double first = std::max(0.0, std::ceil(start - 1e-6));
      const double last =
          std::min(static_cast<double>(ranges_.size()) - 1.0, std::floor(start + width_in_beams + 1e-6));
      if (last < first) continue;
      const auto end = static_cast<std::size_t>(last) + 1;
      for (auto i = static_cast<std::size_t>(first); i < end; ++i) visit(directions_[i], ranges_[i]);
    }
  }

  static double positive_remainder(double angle) noexcept { return angle - turn * std::floor(angle / turn); }

  double angle_min_;
  double angle_increment_;
  std::vector<Point2> directions_;
  std::vector<double>& ranges_;
};

}  // namespace

std::string LidarModel::problem() const {
  if (beams < 1) return "beams is " + std::to_string(beams) + ": give at least 1";
  if (!std::isfinite(angle_min)) return "angle_min is not a finite number: give radians";
  if (!(angle_increment > 0.0)) return "angle_increment must be above 0 rad: count beams counter-clockwise";
  if (!(angle_increment * (beams - 1) < turn * (1.0 + 1e-9))) return "the beams span more than one turn: give fewer";
  if (!(range_min >= 0.0 && range_max > range_min)) return "ranges must be 0 <= range_min < range_max [m]";
  if (!(rate > 0.0)) return "rate must be above 0 Hz";
  if (!(range_noise >= 0.0 && std::isfinite(range_noise))) return "range_noise must be 0 m or more";
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

void true_ranges(const World& world, const Pose2& T_map_laser, const LidarModel& lidar, std::vector<double>& ranges) {
  if (const std::string problem = lidar.problem(); !problem.empty()) throw Error(problem, "LidarModel");
  Fan fan(lidar, ranges);
  const Pose2 T_laser_map = T_map_laser.inverse();
  const Matrix<2, 2> rotation = T_laser_map.rotation();
  const Point2 translation = T_laser_map.translation();
  const auto in_laser = [&](const Point2& point) -> Point2 { return rotation * point + translation; };
  const auto meet_segment = [&](const Segment& wall) { fan.meet({in_laser(wall.a), in_laser(wall.b)}); };

  for (const Segment& wall : world.walls) meet_segment(wall);
  for (const Circle& pillar : world.pillars) fan.meet(in_laser(pillar.centre), pillar.radius);
  for (const PlacedObstacle& obstacle : world.obstacles) {
    for (const Box& box : obstacle.boxes)
      for (const Segment& side : sides(box)) meet_segment(side);
    for (const Cylinder& cylinder : obstacle.cylinders) fan.meet(in_laser(cylinder.centre), cylinder.radius);
  }
}

LaserScan scan(const World& world, const Pose2& T_map_robot, const LidarModel& lidar, Random& random) {
  std::vector<double> ranges;
  true_ranges(world, T_map_robot * lidar.T_robot_laser, lidar, ranges);

  LaserScan result;
  result.angle_min = lidar.angle_min;
  result.angle_increment = lidar.angle_increment;
  result.range_min = lidar.range_min;
  result.range_max = lidar.range_max;
  result.T_robot_laser = lidar.T_robot_laser;
  result.ranges.reserve(ranges.size());
  for (const double range : ranges) {
    const double reading = range + lidar.range_noise * random.normal();
    const auto stored = static_cast<float>(reading);
    const bool seen = range >= lidar.range_min && range < lidar.range_max && is_return(result, stored);
    result.ranges.push_back(seen ? stored : 0.0F);
  }
  return result;
}

}  // namespace slamicp
