// SPDX-License-Identifier: Apache-2.0
#include "scan_queue.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "frames.hpp"

namespace slamicp::node {
namespace {

constexpr std::size_t most_waiting = 100;

}  // namespace

ScanQueue::Taken ScanQueue::judge(Topic& topic, const Scan& message) {
  if (!std::isfinite(message.angle_min) || !std::isfinite(message.angle_increment)) return Taken::broken;
  if (!topic.heard) return Taken::yes;
  const double seconds = 1e-9 * static_cast<double>(message.stamp.nanoseconds - topic.last.nanoseconds);
  if (seconds < -1.0) {
    topic.interval = 0.0;
    return Taken::again;
  }
  if (seconds <= 0.0) return Taken::late;
  topic.interval = topic.interval > 0.0 ? std::min(topic.interval, seconds) : seconds;
  return Taken::yes;
}

void ScanQueue::convert(const Topic& topic, const Scan& message, LaserScan& scan) const {
  constexpr double slack = 1.5;  // stamps jitter
  scan.stamp = message.stamp.seconds();
  scan.angle_min = static_cast<double>(message.angle_min);
  scan.angle_increment = static_cast<double>(message.angle_increment);
  // Drivers leave limits at 0, or give NaN, where they know none.
  const LaserScan unlimited;
  const double least = static_cast<double>(message.range_min), most = static_cast<double>(message.range_max);
  scan.range_min = least > 0.0 && std::isfinite(least) ? least : unlimited.range_min;
  scan.range_max = most > scan.range_min ? most : unlimited.range_max;
  scan.time_increment = static_cast<double>(message.time_increment);
  scan.ranges.assign(message.ranges, message.ranges + message.count);
  scan.T_odom_robot.reset();
  scan.sweep_motion.reset();
  // A sweep cannot take longer than the time to the next one: drivers that say so say it wrong.
  const double told = static_cast<double>(message.scan_time);
  const double longest = slack * (topic.interval > 0.0 ? topic.interval : told);
  const double sweep = std::abs(sweep_time(scan));
  if (!std::isfinite(sweep) || (longest > 0.0 && sweep > longest)) scan.time_increment = 0.0;
}

ScanQueue::Taken ScanQueue::add(int topic_number, const Scan& message, double now) {
  Topic& topic = topics_.at(static_cast<std::size_t>(topic_number));
  const Taken taken = judge(topic, message);
  if (taken == Taken::late || taken == Taken::broken) {
    ++dropped_;
    return taken;
  }
  if (taken == Taken::again) {
    clear();
    for (Topic& other : topics_) other.heard = false;
  }
  if (topic.beams != 0 && (topic.beams != message.count || topic.angle_min != message.angle_min ||
                           topic.angle_increment != message.angle_increment))
    ++changes_;
  if (waiting_.size() >= most_waiting) {
    ++dropped_;
    pop();
  }
  WaitingScan next;
  if (!spare_.empty()) {
    next = std::move(spare_.back());
    spare_.pop_back();
  }
  next.stamp = message.stamp;
  next.frame = without_slash(message.frame);
  next.arrived = now;
  convert(topic, message, next.scan);
  next.scan.laser = topic_number;
  const auto place = std::upper_bound(
      waiting_.begin(), waiting_.end(), next,
      [](const WaitingScan& a, const WaitingScan& b) { return a.stamp.nanoseconds < b.stamp.nanoseconds; });
  waiting_.insert(place, std::move(next));
  ++taken_;
  topic.heard = true;
  topic.last = message.stamp;
  topic.beams = message.count;
  topic.angle_min = message.angle_min;
  topic.angle_increment = message.angle_increment;
  return taken;
}

void ScanQueue::pop() {
  spare_.push_back(std::move(waiting_.front()));
  waiting_.pop_front();
}

void ScanQueue::clear() {
  while (!waiting_.empty()) pop();
}

void ScanQueue::arrive_again(double now) noexcept {
  for (WaitingScan& each : waiting_) each.arrived = now;
}

}  // namespace slamicp::node
