// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>

namespace slamicp {
namespace {

/// The widest gap that one surface can leave between two beams: D_max = r sin(turn) / sin(lambda - turn) + 3 sigma for
/// a turn from one to the next, the first of which read r (Borges, Aldon 2004).
class WidestGap {
 public:
  explicit WidestGap(const ObstacleOptions& options) noexcept
      : lambda_(options.min_incidence_deg * rad_per_deg), noise_(3.0 * options.range_noise) {}

  double operator()(double range, double turn) noexcept {
    if (turn != turn_) {  // most are from a beam to the next
      turn_ = turn;
      share_ = turn < lambda_ ? std::sin(turn) / std::sin(lambda_ - turn) : -1.0;
    }
    return share_ < 0.0 ? 0.0 : range * share_ + noise_;
  }

 private:
  double lambda_;
  double noise_;
  double turn_ = 0.0;
  double share_ = 0.0;
};

}  // namespace

std::string Obstacle::brief() const {
  char text[128];
  std::snprintf(text, sizeof text, "%.2f m x %.2f m at %.2f m, %.2f m, %zu points", box.width, box.depth,
                box.centre.x(), box.centre.y(), points.size());
  return text;
}

std::string ObstacleOptions::problem() const {
  if (min_points < 1) return "min_points must be at least 1";
  if (!(range_noise >= 0.0)) return "range_noise must be at least 0 m";
  if (!(min_incidence_deg > 0.0 && min_incidence_deg < 90.0))
    return "min_incidence_deg must lie between 0 and 90 degrees; 10 is the default";
  return {};
}

std::vector<Obstacle> find_obstacles(const Fix& fix, const LaserScan& scan, const ObstacleOptions& options) {
  ObstacleFinder finder(options);
  const std::span<const Obstacle> found = finder.find(fix, scan);
  return {found.begin(), found.end()};
}

ObstacleFinder::ObstacleFinder(const ObstacleOptions& options) : options_(options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "ObstacleOptions");
}

void ObstacleFinder::reserve(std::size_t obstacles, std::size_t points) {
  if (obstacles_.size() < obstacles) obstacles_.resize(obstacles);
  for (Obstacle& obstacle : obstacles_) obstacle.points.reserve(points);
  in_map_.reserve(points);
  boxes_.reserve(points);
}

std::span<const Obstacle> ObstacleFinder::find(const Fix& fix, const LaserScan& scan) {
  const std::span<const int> outliers = fix.outliers();
  const Point2 laser = scan.T_robot_laser.translation();
  const double increment = std::abs(scan.angle_increment);
  WidestGap widest_gap(options_);
  const auto belong_together = [&](int a, int b) {
    const auto before = static_cast<std::size_t>(a);
    const auto here = static_cast<std::size_t>(b);
    if (!fix.scan.scans.empty() && fix.scan.scans[before] != fix.scan.scans[here]) return false;
    const Point2& last = fix.scan.in_robot[before];
    const double turn = increment * (fix.scan.beams[here] - fix.scan.beams[before]);
    return (fix.scan.in_robot[here] - last).norm() <= widest_gap((last - laser).norm(), turn);
  };
  found_ = 0;
  std::size_t first = 0;
  for (std::size_t k = 0; k < outliers.size(); ++k)
    if (k + 1 == outliers.size() || !belong_together(outliers[k], outliers[k + 1])) {
      add(fix, laser, outliers.subspan(first, k + 1 - first));
      first = k + 1;
    }
  const auto found = std::span(obstacles_).first(found_);
  std::sort(found.begin(), found.end(), [](const Obstacle& a, const Obstacle& b) { return a.distance < b.distance; });
  return found;
}

/// A group of outliers, if there are enough of them.
void ObstacleFinder::add(const Fix& fix, const Point2& laser, std::span<const int> points) {
  if (points.size() < static_cast<std::size_t>(options_.min_points)) return;
  if (found_ == obstacles_.size()) obstacles_.emplace_back();
  Obstacle& obstacle = obstacles_[found_++];
  obstacle.points.assign(points.begin(), points.end());
  const Matrix<2, 2> rotation = fix.pose.rotation();
  double nearest2 = std::numeric_limits<double>::infinity();
  in_map_.clear();
  for (const int i : points) {
    const Point2& in_robot = fix.scan.in_robot[static_cast<std::size_t>(i)];
    nearest2 = std::min(nearest2, (in_robot - laser).squaredNorm());
    in_map_.push_back(rotation * in_robot + fix.pose.translation());
  }
  obstacle.distance = std::sqrt(nearest2);
  obstacle.box = boxes_.smallest(in_map_);
}

}  // namespace slamicp
