// SPDX-License-Identifier: Apache-2.0
#include "localization/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <slamicp/map/ray_checker.hpp>

namespace slamicp {
namespace {

constexpr int sectors = 12;

/// Rays that ended in one direction.
struct Sector {
  int rays = 0;
  int explained = 0;
};

int sector_of(const Vector<2>& direction) noexcept {
  const double turns = std::atan2(direction.y(), direction.x()) / (2.0 * std::numbers::pi) + 0.5;
  return std::clamp(static_cast<int>(turns * sectors), 0, sectors - 1);
}

double share_of_explained(const std::array<Sector, sectors>& all) noexcept {
  const auto seen = std::count_if(all.begin(), all.end(), [](const Sector& sector) { return sector.rays > 0; });
  const auto explained = std::count_if(all.begin(), all.end(), [](const Sector& sector) {
    return sector.rays > 0 && 2 * sector.explained >= sector.rays;
  });
  return seen > 0 ? static_cast<double>(explained) / static_cast<double>(seen) : 0.0;
}

}  // namespace

Evidence look(const IndexedPoints<2>& map, const PlacedScan& scan, int rays, double match_distance,
              double noise) noexcept {
  Evidence evidence;
  const std::size_t size = scan.points.in_robot.size();
  const std::size_t count = std::min(size, static_cast<std::size_t>(std::max(rays, 0)));
  const RayChecker checker(map, match_distance, noise);
  const RigidTransform<2> T_map_robot(scan.T_map_robot);
  std::array<Sector, sectors> directions{};
  int explained = 0, beside = 0, violations = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = evenly_chosen(k, count, size);
    const std::size_t laser = scan.points.scans.empty() ? 0 : static_cast<std::size_t>(scan.points.scans[i]);
    const Point2& from = scan.origins[laser];
    const Point2& to = scan.points.in_robot[i];
    if (!is_finite<2>(to)) continue;
    const Point2 in_map = T_map_robot * to;
    const RayEnd end = checker.end_of(in_map);
    const bool is_explained = end == RayEnd::explained;
    explained += is_explained;
    beside += end == RayEnd::beside;
    violations += !is_explained && checker.passes_wall(T_map_robot * from, in_map);
    Sector& sector = directions[static_cast<std::size_t>(sector_of(to - from))];
    ++sector.rays;
    sector.explained += is_explained;
    ++evidence.rays;
  }
  if (evidence.rays == 0) return evidence;
  evidence.explained = static_cast<double>(explained) / evidence.rays;
  evidence.beside = static_cast<double>(beside) / evidence.rays;
  evidence.violations = static_cast<double>(violations) / evidence.rays;
  evidence.spread = share_of_explained(directions);
  return evidence;
}

double log_odds(const Evidence& evidence) noexcept {
  const double near = evidence.explained + evidence.beside;
  const double fit = near > 0.0 ? evidence.explained / near : 0.0;
  return -6.91 + 6.35 * fit - 14.9 * std::sqrt(evidence.violations) + 5.48 * evidence.spread;
}

double probability_of(double log_odds) noexcept { return 1.0 / (1.0 + std::exp(-log_odds)); }

void Judge::forget() noexcept {
  log_odds_ = at_first;
  record_ = 0.0;
  awareness_ = 1.0;
  scans_ = 0;
  doubtful_ = 0;
}

Quality Judge::update(const Evidence& evidence, bool matched, bool held, double surprise) noexcept {
  constexpr double unmatched = -4.0;
  constexpr double surest = 7.0;
  const double by_scan = matched && evidence.rays > 0 ? std::clamp(log_odds(evidence), -surest, surest) : unmatched;
  log_odds_ += (by_scan - log_odds_) / options_.memory;
  record_ *= 1.0 - surprise;
  ++scans_;
  const double memory = std::min(static_cast<double>(scans_), options_.awareness_memory);
  awareness_ += (evidence.explained - awareness_) / memory;

  Quality quality;
  quality.state = next_state(held);
  quality.probability = probability();
  quality.scan_probability = probability_of(by_scan);
  quality.awareness = awareness_;
  quality.evidence = evidence;
  return quality;
}

TrackingState Judge::next_state(bool held) noexcept {
  const double enough = doubtful_ > 0 ? options_.trusted_above : options_.suspect_below;
  doubtful_ = probability() < enough ? doubtful_ + 1 : 0;
  if (doubtful_ == 0) record_ = std::min(record_ + best_record / scans_of_a_record, best_record);
  if (doubtful_ > options_.lost_after) return TrackingState::lost;
  if (doubtful_ > 0) return TrackingState::suspect;
  return held ? TrackingState::tracking : TrackingState::degenerate;
}

}  // namespace slamicp
