// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <slamicp/scan/scan_points.hpp>

namespace slamicp {
namespace {

/// The robot's poses at the beams, one after the other: T_start_robot.
class RobotAtBeam {
 public:
  RobotAtBeam(const SweepMotion& motion, std::size_t beams) noexcept
      : at_(motion.T_start_first), cosine_(std::cos(at_.theta)), sine_(std::sin(at_.theta)) {
    if (beams < 2) return;
    step_ = interpolate(motion.T_first_last, 1.0 / static_cast<double>(beams - 1));
    step_cosine_ = std::cos(step_.theta);
    step_sine_ = std::sin(step_.theta);
  }

  Point2 operator*(const Point2& in_robot) const noexcept {
    return {at_.x + cosine_ * in_robot.x() - sine_ * in_robot.y(),
            at_.y + sine_ * in_robot.x() + cosine_ * in_robot.y()};
  }

  void next() noexcept {
    at_.x += cosine_ * step_.x - sine_ * step_.y;
    at_.y += sine_ * step_.x + cosine_ * step_.y;
    const double cosine = cosine_ * step_cosine_ - sine_ * step_sine_;
    sine_ = sine_ * step_cosine_ + cosine_ * step_sine_;
    cosine_ = cosine;
  }

 private:
  Pose2 at_;
  double cosine_;
  double sine_;
  Pose2 step_;  // from one beam to the next
  double step_cosine_ = 1.0;
  double step_sine_ = 0.0;
};

}  // namespace

void ScanProjector::aim(const LaserScan& scan) {
  if (directions_.size() == scan.ranges.size() && angle_min_ == scan.angle_min &&
      angle_increment_ == scan.angle_increment)
    return;
  angle_min_ = scan.angle_min;
  angle_increment_ = scan.angle_increment;
  directions_.resize(scan.ranges.size());
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const double angle = angle_min_ + static_cast<double>(i) * angle_increment_;
    directions_[i] = {std::cos(angle), std::sin(angle)};
  }
}

void ScanProjector::append(const LaserScan& scan, const RangeFilter& filter, const SweepMotion& motion,
                           ScanPoints& points) {
  aim(scan);
  const std::size_t most = points.in_robot.size() + scan.ranges.size();
  points.in_robot.reserve(most);
  points.beams.reserve(most);
  const RigidTransform<2> T_robot_laser(scan.T_robot_laser);
  RobotAtBeam robot(motion, scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i, robot.next()) {
    const float reading = scan.ranges[i];
    const double range = static_cast<double>(reading);
    if (!is_return(scan, reading) || range < filter.min_range || range >= filter.max_range) continue;
    points.in_robot.push_back(robot * (T_robot_laser * Point2(range * directions_[i])));
    points.beams.push_back(static_cast<int>(i));
  }
}

void to_points(const LaserScan& scan, const RangeFilter& filter, ScanPoints& points) {
  points.in_robot.clear();
  points.beams.clear();
  points.scans.clear();
  ScanProjector().append(scan, filter, {}, points);
}

ScanPoints to_points(const LaserScan& scan, const RangeFilter& filter) {
  ScanPoints points;
  to_points(scan, filter, points);
  return points;
}

}  // namespace slamicp
