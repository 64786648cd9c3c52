// SPDX-License-Identifier: Apache-2.0
#include "mapping/map_refinement.hpp"

#include <algorithm>
#include <cmath>

#include <slamicp/search/kd_tree.hpp>

namespace slamicp {
namespace {

// Neighbours are those within this many reaches; a point seen less than this share of the most seen one is noise.
constexpr double neighbourhood = 2.0;
constexpr double smallest_share = 0.25;
// A reading that may mix near and far, and that no scan saw again, is a stray if it has fewer other points than this
// within so many reaches; but so many scans must have had the chance to see it.
constexpr std::size_t company = 3;
constexpr double company_within = 4.0;
constexpr int chances = 3;
// Beams that follow each other hit a surface no farther apart than this, in arcs between them: at an incidence of 10
// deg (Borges, Aldon 2004).
constexpr double flattest = 3.0;
constexpr std::size_t beside = 2;  // beams to either side: those beside an edge may both be mixed

/// @param doubtful  one for each point: a stray if it stands alone
PointCloud2 without_strays(const PointCloud2& points, const std::vector<bool>& doubtful, double radius) {
  const KdTree<2> tree(points);
  std::vector<Neighbour> around(company + 1);  // itself, too
  PointCloud2 kept;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!doubtful[k] || tree.nearest_k(points[k], radius, around) == around.size()) kept.push_back(points[k]);
  return kept;
}

}  // namespace

void MapRefinement::count(const Fix& fix) {
  seen_.resize(std::max(seen_.size(), fix.map->size()));
  ++scans_;
  for (std::size_t i = 0; i < fix.match.matches.size(); ++i) {
    const Match& match = fix.match.matches[i];
    if (match.map_index < 0 || !(match.distance < reach_)) continue;
    Seen& seen = seen_[static_cast<std::size_t>(match.map_index)];
    seen.sum += fix.pose * fix.scan.in_robot[i];
    seen.times += 1.0;
  }
}

void MapRefinement::expect(std::size_t map_size, const Fix& fix, std::span<const int> points) {
  seen_.resize(map_size);
  for (const int i : points) {
    seen_.emplace_back();
    seen_.back().since = scans_;
    seen_.back().may_be_mixed = may_be_mixed(fix, static_cast<std::size_t>(i));
  }
}

/// Whether a scan's point may be a reading that mixes near and far: it is on no surface with the points of the beams
/// before and after it, and lies between theirs in range. A lone reading behind all of them has passed a gap, and one
/// before all of them shows something thin.
bool MapRefinement::may_be_mixed(const Fix& fix, std::size_t i) const noexcept {
  const PointCloud2& points = fix.scan.in_robot;
  const auto on_one_surface = [&](const Point2& a, const Point2& b) {
    const double arc = std::abs(cross(a, b)) / std::max(a.norm(), b.norm());
    return (a - b).norm() <= flattest * arc + reach_;
  };
  bool is_behind = false;
  bool is_before = false;
  for (std::size_t k = i - std::min(i, beside); k <= i + beside && k < points.size(); ++k) {
    if (k == i) continue;
    if (k + 1 >= i && k <= i + 1 && on_one_surface(points[i], points[k])) return false;
    (points[k].squaredNorm() < points[i].squaredNorm() ? is_behind : is_before) = true;
  }
  return is_behind && is_before;
}

bool MapRefinement::is_doubtful(std::size_t k) const noexcept {
  return k < seen_.size() && seen_[k].may_be_mixed && seen_[k].times == 0.0 && scans_ - seen_[k].since >= chances;
}

PointCloud2 MapRefinement::refined(const PointMap2& map) const {
  // A point counts as seen once when it was added.
  const auto times = [this](std::size_t k) { return 1.0 + (k < seen_.size() ? seen_[k].times : 0.0); };
  PointCloud2 points;
  std::vector<bool> doubtful;
  std::vector<int> around;
  for (std::size_t k = 0; k < map.size(); ++k) {
    const Point2& point = map.points()[k];
    around.clear();
    map.indexed().within(point, neighbourhood * reach_, around);
    double most = 0.0;
    for (const int other : around) most = std::max(most, times(static_cast<std::size_t>(other)));
    if (times(k) < smallest_share * most) continue;
    const Point2 sum = k < seen_.size() ? Point2(point + seen_[k].sum) : point;
    points.push_back(sum / times(k));
    doubtful.push_back(is_doubtful(k));
  }
  return without_strays(points, doubtful, company_within * reach_);
}

}  // namespace slamicp
