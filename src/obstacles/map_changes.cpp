// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include <slamicp/error.hpp>
#include <slamicp/map/ray_checker.hpp>
#include <slamicp/obstacles/map_changes.hpp>

namespace slamicp {
namespace {

constexpr double before_the_end = 0.1;  // before its end a ray says nothing [m]: there noise may have it
constexpr std::size_t every_ray = 4;    // every so many rays are followed

constexpr std::int64_t key_offset = std::int64_t{1} << 31;

std::uint64_t packed(std::int64_t column, std::int64_t row) noexcept {
  return (static_cast<std::uint64_t>(column + key_offset) << 32) | static_cast<std::uint64_t>(row + key_offset);
}
std::int64_t column_of(std::uint64_t key) noexcept { return static_cast<std::int64_t>(key >> 32) - key_offset; }
std::int64_t row_of(std::uint64_t key) noexcept { return static_cast<std::int64_t>(key & 0xffffffffU) - key_offset; }

/// The cells within two of one.
template <typename Visit>
void near_cells(std::uint64_t key, const Visit& visit) {
  constexpr std::int64_t reach = 2;
  for (std::int64_t dx = -reach; dx <= reach; ++dx)
    for (std::int64_t dy = -reach; dy <= reach; ++dy) visit(packed(column_of(key) + dx, row_of(key) + dy));
}

/// Everything that hangs together with the first cell; taken out of `cells`.
std::vector<std::uint64_t> take_together(std::set<std::uint64_t>& cells) {
  std::vector<std::uint64_t> group{*cells.begin()};
  cells.erase(cells.begin());
  for (std::size_t next = 0; next < group.size(); ++next)
    near_cells(group[next], [&](std::uint64_t other) {
      if (cells.erase(other) > 0) group.push_back(other);
    });
  std::sort(group.begin(), group.end());
  return group;
}

}  // namespace

const char* to_string(ProposedChange::Kind kind) noexcept {
  return kind == ProposedChange::Kind::add ? "add" : "remove";
}

std::string ProposedChange::brief() const {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
                "%s %.2f m x %.2f m at %.2f m, %.2f m: %d scans, %.1f s, seen from places %.1f m apart, %.0f %% agree",
                to_string(kind), box.width, box.depth, box.centre.x(), box.centre.y(), scans, last_stamp - first_stamp,
                baseline, 100.0 * share);
  return text.data();
}

std::string MapChangeOptions::problem() const {
  if (!(cell > 0.0)) return "cell must be a length above 0 m; 0.05 m is the default";
  if (!(interval >= 0.0)) return "interval must be at least 0 s";
  if (min_scans < 1) return "min_scans must be at least 1";
  if (!(min_seconds >= 0.0)) return "min_seconds must be at least 0 s";
  if (!(min_baseline >= 0.0)) return "min_baseline must be at least 0 m";
  if (!(min_share > 0.5 && min_share <= 1.0)) return "min_share must be in (0.5, 1]";
  if (!(min_size >= 0.0)) return "min_size must be at least 0 m";
  return {};
}

MapChanges::MapChanges(const MapChangeOptions& options) : options_(options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "MapChangeOptions");
}

std::uint64_t MapChanges::key_of(const Point2& place) const noexcept {
  return packed(std::llround(place.x() / options_.cell), std::llround(place.y() / options_.cell));
}

void MapChanges::speak_for(Cells& cells, const Point2& place, const Point2& laser, double stamp) {
  Evidence& evidence = cells[key_of(place)];
  if (evidence.rays == 0) evidence.first_stamp = stamp;
  ++evidence.rays;
  evidence.sum += place;
  evidence.last_stamp = stamp;
  evidence.lasers.include(laser);
  if (evidence.last == scans_) return;
  evidence.last = scans_;
  ++evidence.scans;
}

/// A ray goes where something stood before.
void MapChanges::pass_along(const Point2& from, const Vector<2>& direction, double until) {
  for (double at = 0.0; at < until; at += options_.cell) {
    const auto found = new_.find(key_of(from + at * direction));
    if (found != new_.end()) ++found->second.against;
  }
}

void MapChanges::add(const Fix& fix, const LaserScan& scan, std::span<const Obstacle> obstacles) {
  if (fix.stamp < next_ || !fix.map || !fix.usable() || fix.quality.state != TrackingState::tracking) return;
  next_ = fix.stamp + options_.interval;
  map_ = fix.map;
  ++scans_;
  const auto laser_of = [&](std::size_t i) { return fix.pose * ray_origin(fix, scan, i); };
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.ray_class != RayClass::obstacle) continue;
    for (const int point : obstacle.points) {
      const auto i = static_cast<std::size_t>(point);
      speak_for(new_, fix.pose * fix.scan.in_robot[i], laser_of(i), fix.stamp);
    }
  }
  const IndexedPoints<2>& map = fix.map->indexed();
  const double noise = std::hypot(fix.match.uncertainty.range_noise, map.line_noise().across);
  const RayChecker checker(map, RayChecker::usual_distance, std::max(noise, 0.005));
  for (std::size_t i = 0; i < fix.scan.in_robot.size(); i += every_ray) {
    const Point2 from = laser_of(i);
    const Point2 to = fix.pose * fix.scan.in_robot[i];
    const double length = (to - from).norm();
    if (!(length > before_the_end) || !std::isfinite(length)) continue;
    const Vector<2> direction = (to - from) / length;
    pass_along(from, direction, length - before_the_end);
    for (double start = 0.0;;) {
      const WallMet wall = checker.first_wall(from, direction, start, length - before_the_end);
      if (!wall.met) break;
      if (wall.sure() && wall.distance < length - before_the_end)
        speak_for(gone_, from + wall.distance * direction, from, fix.stamp);
      start = std::max(start, wall.distance) + before_the_end;
    }
    // What a ray ends at is there.
    if (checker.end_of(to) == RayEnd::explained) ++gone_[key_of(to)].against;
  }
}

bool MapChanges::is_sure(const Evidence& evidence) const noexcept {
  const double all = evidence.rays + evidence.against;
  return evidence.scans >= options_.min_scans && evidence.rays >= options_.min_share * all &&
         evidence.last_stamp - evidence.first_stamp >= options_.min_seconds &&
         (evidence.lasers.upper - evidence.lasers.lower).norm() >= options_.min_baseline;
}

/// Sure cells that hang together, each group one change.
std::vector<ProposedChange> MapChanges::grouped(const Cells& cells, ProposedChange::Kind kind) const {
  std::set<std::uint64_t> sure;
  for (const auto& [key, evidence] : cells)
    if (is_sure(evidence)) sure.insert(key);
  std::vector<ProposedChange> changes;
  while (!sure.empty()) {
    const std::vector<std::uint64_t> group = take_together(sure);
    ProposedChange change;
    change.kind = kind;
    change.first_stamp = std::numeric_limits<double>::infinity();
    change.last_stamp = -change.first_stamp;
    Bounds<2> lasers;
    int rays = 0, against = 0;
    for (const std::uint64_t key : group) {
      const Evidence& evidence = cells.at(key);
      change.points.push_back(evidence.sum / static_cast<double>(evidence.rays));
      change.scans = std::max(change.scans, evidence.scans);
      change.first_stamp = std::min(change.first_stamp, evidence.first_stamp);
      change.last_stamp = std::max(change.last_stamp, evidence.last_stamp);
      lasers.include(evidence.lasers.lower);
      lasers.include(evidence.lasers.upper);
      rays += evidence.rays;
      against += evidence.against;
    }
    change.share = static_cast<double>(rays) / static_cast<double>(rays + against);
    change.baseline = (lasers.upper - lasers.lower).norm();
    change.box = smallest_box(change.points);
    // A thing has cells all along; the two ends of a pilaster, which rays brush, are none.
    const double long_enough = std::max(options_.min_size, 0.6 * change.box.width);
    const bool is_dense = static_cast<double>(group.size()) * options_.cell > long_enough - 1e-9;
    if (change.box.width >= options_.min_size && is_dense) changes.push_back(std::move(change));
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const ProposedChange& a, const ProposedChange& b) { return a.box.width > b.box.width; });
  return changes;
}

std::vector<ProposedChange> MapChanges::proposals() const {
  std::vector<ProposedChange> all = grouped(new_, ProposedChange::Kind::add);
  std::vector<ProposedChange> gone = grouped(gone_, ProposedChange::Kind::remove);
  if (gone.empty()) return all;
  // The map's points in the cells that rays went through, and beside them where nothing says that they are there.
  std::map<std::uint64_t, std::size_t> change_of;
  for (std::size_t k = 0; k < gone.size(); ++k)
    for (const Point2& place : gone[k].points)
      near_cells(key_of(place), [&](std::uint64_t key) {
        const auto found = gone_.find(key);
        if (found == gone_.end() || found->second.rays >= found->second.against) change_of.emplace(key, k);
      });
  for (ProposedChange& change : gone) change.points.clear();
  for (std::size_t i = 0; i < map_->size(); ++i) {
    const Point2& point = map_->points()[i];
    if (!is_finite<2>(point)) continue;
    const auto found = change_of.find(key_of(point));
    if (found == change_of.end()) continue;
    gone[found->second].points.push_back(point);
    gone[found->second].map_index.push_back(static_cast<int>(i));
  }
  for (ProposedChange& change : gone) {
    if (change.points.empty()) continue;
    change.box = smallest_box(change.points);
    all.push_back(std::move(change));
  }
  return all;
}

}  // namespace slamicp
