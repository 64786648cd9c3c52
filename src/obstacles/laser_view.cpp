// SPDX-License-Identifier: Apache-2.0
#include "obstacles/laser_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slamicp {

LaserView::LaserView(const LaserScan& scan, const Pose2& T_map_robot, double turn_rate) noexcept
    : T_laser_map_((T_map_robot * scan.T_robot_laser).inverse()),
      first_(scan.angle_min),
      increment_(scan.angle_increment + turn_rate * scan.time_increment),
      least_(static_cast<float>(scan.range_min)),
      most_(static_cast<float>(std::min<double>(scan.range_max, std::numeric_limits<float>::max()))),
      ranges_(scan.ranges) {}

LaserView LaserView::with(std::span<const float> ranges) const noexcept {
  LaserView copy = *this;
  copy.ranges_ = ranges;
  return copy;
}

Sight LaserView::look(const Point2& in_map, double margin, double shift, double turn) const noexcept {
  constexpr double round = 2.0 * std::numbers::pi;
  const Point2 place = T_laser_map_ * in_map;
  const double range = place.norm();
  if (ranges_.empty() || increment_ == 0.0 || range <= margin || range + margin >= most_) return Sight::unseen;
  // How many beams on; it may be a turn further round.
  double beam = (std::atan2(place.y(), place.x()) - first_) / increment_;
  const double beams_round = round / std::abs(increment_);
  beam -= std::floor(beam / beams_round) * beams_round;
  const double wide = (turn + shift / range) / std::abs(increment_) + 1.0;
  const auto count = static_cast<double>(ranges_.size());
  if (beam - wide < 0.0 || beam + wide > count - 1.0) return Sight::unseen;
  const auto from = static_cast<std::size_t>(beam - wide);
  const auto to = static_cast<std::size_t>(std::ceil(beam + wide));
  bool beyond = false;
  bool before = false;
  bool silent = false;
  for (std::size_t k = from; k <= to; ++k) {
    const float reading = ranges_[k];
    const bool is_return = reading > 0.0F && reading >= least_ && reading < most_;
    if (!is_return)
      silent = true;
    else if (static_cast<double>(reading) > range + margin)
      beyond = true;
    else if (static_cast<double>(reading) < range - margin)
      before = true;
    else
      return Sight::taken;
  }
  if (before) return beyond || silent ? Sight::taken : Sight::hidden;
  return silent && !beyond ? Sight::silent : Sight::free;
}

}  // namespace slamicp
