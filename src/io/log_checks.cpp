// SPDX-License-Identifier: Apache-2.0
#include "io/log_checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <slamicp/error.hpp>

#include "io/text.hpp"

namespace slamicp {
namespace {

using Histogram = std::map<float, std::size_t>;

/// How often each reading of the upper tenth occurs.
struct FarReadings {
  Histogram counts;
  std::size_t readings = 0;  ///< of all, near and far
};

FarReadings far_readings(const std::vector<LaserScan>& scans) {
  float largest = 0.0F;
  FarReadings far;
  for (const LaserScan& scan : scans)
    for (const float range : scan.ranges)
      if (is_return(scan, range)) {
        largest = std::max(largest, range);
        ++far.readings;
      }
  for (const LaserScan& scan : scans)
    for (const float range : scan.ranges)
      if (range >= 0.9F * largest && is_return(scan, range)) ++far.counts[range];
  return far;
}

bool largest_is_constant(const FarReadings& far) {
  constexpr std::size_t fewest = 20;
  const std::size_t count = far.counts.rbegin()->second;
  constexpr float nearest = 3.5F;
  if (far.counts.rbegin()->first < nearest || count < fewest || count * 1000 < far.readings) return false;
  if (count == far.readings) return false;  // a round room without noise, not a sky
  std::size_t other = 0;
  for (auto reading = std::next(far.counts.rbegin()); reading != far.counts.rend(); ++reading)
    other = std::max(other, reading->second);
  return count >= 10 * other;
}

}  // namespace

void require_valid(const ScanLogOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "ScanLogOptions");
}

void warn_of_backward_stamps(ScanLog& log) {
  std::size_t count = 0;
  double farthest = 0.0;
  for (std::size_t i = 1; i < log.size(); ++i) {
    const double back = log[i - 1].stamp - log[i].stamp;
    if (back <= 0.0) continue;
    ++count;
    farthest = std::max(farthest, back);
  }
  if (count == 0) return;
  std::string warning = text::count_of(count, "stamp runs", "stamps run") + " backwards, by up to ";
  text::append_fixed(warning, farthest, 3);
  log.warnings.push_back(warning + " s: scans are kept in the order of the file");
}

void drop_no_return_constant(ScanLog& log) {
  constexpr float sick_lowest = 81.825F;
  constexpr float sick_highest = 81.925F;
  constexpr double just_below = 0.005;  // half of the centimetre that such lidars count in
  const FarReadings far = far_readings(log.scans);
  if (far.counts.empty()) return;
  const float largest = far.counts.rbegin()->first;
  double range_max = 0.0;
  if (largest >= sick_lowest && largest <= sick_highest)
    range_max = static_cast<double>(sick_lowest);
  else if (largest_is_constant(far))
    range_max = static_cast<double>(largest) - just_below;
  else
    return;
  for (LaserScan& scan : log.scans) scan.range_max = std::min(scan.range_max, range_max);

  std::size_t dropped = 0;
  std::size_t most = 0;
  float constant = largest;
  for (auto at = far.counts.lower_bound(static_cast<float>(range_max)); at != far.counts.end(); ++at) {
    dropped += at->second;
    if (at->second > most) constant = at->first;
    most = std::max(most, at->second);
  }
  std::string warning = text::count_of(dropped, "reading is", "readings are") + " a constant, ";
  text::append_general(warning, static_cast<double>(constant), 6);
  log.warnings.push_back(warning + " m, that says no return: dropped");
}

}  // namespace slamicp
