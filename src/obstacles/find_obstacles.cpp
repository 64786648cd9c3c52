// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/geometry/angle.hpp>
#include <slamicp/obstacles/find_obstacles.hpp>

namespace slamicp {
namespace {

/// How far off the map a point is.
enum class OffMap : unsigned char {
  near,     // at least the share of the obstacle distance
  far,      // at least the obstacle distance
  outlier,  // the same, and of the fix
};

/// How far from the map's surface a place is whose nearest map point that is [m]: from its line as far as points go on
/// along it.
double off_surface(const IndexedPoints<2>& map, const Point2& place, const Neighbour& nearest) noexcept {
  const auto number = static_cast<std::size_t>(nearest.index);
  const Surface2 surface = map.surface(number);
  if (!surface.valid()) return std::sqrt(nearest.squared_distance);
  const double across = surface.normal.dot(place - surface.centroid);
  const double along = std::abs(cross(surface.normal, place - map.points()[number]));
  return std::hypot(across, std::max(0.0, along - map.spacing()));
}

/// True where the scan is of one laser that sees all around.
bool is_full_turn(const Fix& fix, const LaserScan& scan) noexcept {
  const double increment = std::abs(scan.angle_increment);
  return fix.scan.scans.empty() &&
         increment * static_cast<double>(scan.ranges.size()) > 2.0 * std::numbers::pi - 0.5 * increment;
}

}  // namespace

std::string Obstacle::brief() const {
  char text[128];
  std::snprintf(text, sizeof text, "%.2f m x %.2f m at %.2f m, %.2f m, %zu points", box.width, box.depth,
                box.centre.x(), box.centre.y(), points.size());
  return text;
}

std::string ObstacleOptions::problem() const {
  if (min_points < 1) return "min_points must be at least 1";
  if (min_far_points < 1) return "min_far_points must be at least 1";
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

/// One fix, looked at by its scan's rays.
struct ObstacleFinder::Look {
  Look(const Fix& of, const LaserScan& by, const ObstacleOptions& options)
      : fix(of),
        scan(by),
        T_map_robot(of.pose),
        increment(std::abs(by.angle_increment)),
        noise(of.match.uncertainty.known ? of.match.uncertainty.range_noise : options.range_noise),
        three_sigma(3.0 * options.range_noise),
        flattest(options.min_incidence_deg * rad_per_deg),
        share_of_one(gap_share(increment)) {}

  std::size_t size() const noexcept { return fix.scan.in_robot.size(); }
  bool same_laser(std::size_t a, std::size_t b) const noexcept {
    return fix.scan.scans.empty() || fix.scan.scans[a] == fix.scan.scans[b];
  }
  Point2 origin(std::size_t i) const noexcept { return ray_origin(fix, scan, i); }
  double range(std::size_t i) const noexcept { return (fix.scan.in_robot[i] - origin(i)).norm(); }
  Point2 in_map(const Point2& in_robot) const noexcept { return T_map_robot * in_robot; }

  /// The widest gap that one surface can leave between two beams, as a share of what the first one read: sin(turn) /
  /// sin(lambda - turn) for a turn from one to the next (Borges, Aldon 2004). Below 0: no surface goes so far.
  double gap_share(double turn) const noexcept {
    return turn < flattest ? std::sin(turn) / std::sin(flattest - turn) : -1.0;
  }
  /// True if two points of a laser, so many beams apart, can be of one surface.
  bool hang_together(std::size_t a, std::size_t b, int beams) const noexcept {
    const Point2& here = fix.scan.in_robot[a];
    const double share = beams == 1 ? share_of_one : gap_share(increment * beams);
    const double widest = (here - origin(a)).norm() * share + three_sigma;
    return share >= 0.0 && (fix.scan.in_robot[b] - here).squaredNorm() <= widest * widest;
  }
  /// The same for points in beam order, with those between them.
  bool belong_together(int a, int b) const noexcept {
    constexpr int most_between = 2;  // that noise has brought to the map's surface
    const auto from = static_cast<std::size_t>(a);
    const auto to = static_cast<std::size_t>(b);
    if (b - a - 1 > most_between || !same_laser(from, to)) return false;
    for (std::size_t i = from; i < to; ++i)
      if (!hang_together(i, i + 1, fix.scan.beams[i + 1] - fix.scan.beams[i])) return false;
    return true;
  }
  /// The last point of a full turn and the first one.
  bool belong_across_seam(int last, int first) const noexcept {
    const auto from = static_cast<std::size_t>(last);
    const auto to = static_cast<std::size_t>(first);
    const int beams = static_cast<int>(std::lround(2.0 * std::numbers::pi / increment));
    return first == 0 && from + 1 == size() &&
           hang_together(from, to, fix.scan.beams[to] + beams - fix.scan.beams[from]);
  }
  /// True if a thing's end can be seen at its point i, its rays going on to neighbour j: that one ends farther off, or
  /// there is none and nothing came back.
  bool ends_before(std::size_t i, std::ptrdiff_t j, int step) const noexcept;

  const Fix& fix;
  const LaserScan& scan;
  RigidTransform<2> T_map_robot;
  double increment;
  double noise;         // of a range [m]
  double three_sigma;   // of the noise that may tear a surface [m]
  double flattest;      // incidence at which a surface holds together [rad]
  double share_of_one;  // gap_share from a beam to the next: most are
};

bool ObstacleFinder::Look::ends_before(std::size_t i, std::ptrdiff_t j, int step) const noexcept {
  const int beam = fix.scan.beams[i] + step;
  const bool is_turn = is_full_turn(fix, scan);
  const auto beams = static_cast<int>(scan.ranges.size());
  if (!is_turn && (beam < 0 || beam >= beams)) return false;  // the laser sees no farther
  const auto count = static_cast<std::ptrdiff_t>(size());
  if (is_turn) j = (j + count) % count;
  const bool has_neighbour = j >= 0 && j < count && same_laser(i, static_cast<std::size_t>(j)) &&
                             fix.scan.beams[static_cast<std::size_t>(j)] == (beam + beams) % beams;
  if (!has_neighbour) return true;
  const auto other = static_cast<std::size_t>(j);
  return range(other) > range(i) && !hang_together(i, other, 1);
}

void ObstacleFinder::reserve(std::size_t obstacles, std::size_t points) {
  if (obstacles_.size() < obstacles) obstacles_.resize(obstacles);
  for (Obstacle& obstacle : obstacles_) obstacle.points.reserve(points);
  candidates_.reserve(2 * points);
  state_.reserve(2 * points);
  in_map_.reserve(points);
  boxes_.reserve(points);
  shapes_.reserve(points);
}

/// What obstacles can be made of.
void ObstacleFinder::choose_points(const Fix& fix) {
  candidates_.clear();
  state_.clear();
  if (!(fix.match.obstacle_distance > 0.0) || !fix.map) {
    candidates_.assign(fix.outliers().begin(), fix.outliers().end());
    state_.assign(candidates_.size(), static_cast<unsigned char>(OffMap::outlier));
    return;
  }
  const IndexedPoints<2>& map = fix.map->indexed();
  const double far = fix.match.obstacle_distance;
  const double near = IcpResult2::stray_share * far;
  const double reach = std::max(2.0 * far, map.cells().cell_options().reach);
  const RigidTransform<2> T_map_robot(fix.pose);
  auto next_outlier = fix.outliers().begin();
  for (const int i : fix.match.stray_indices) {
    while (next_outlier != fix.outliers().end() && *next_outlier < i) ++next_outlier;
    const bool is_outlier = next_outlier != fix.outliers().end() && *next_outlier == i;
    const Point2 place = T_map_robot * fix.scan.in_robot[static_cast<std::size_t>(i)];
    const Neighbour nearest = map.nearest(place, reach);
    const double off = nearest.found() ? off_surface(map, place, nearest) : reach;
    if (off < near) continue;
    const OffMap how_far = off < far ? OffMap::near : is_outlier ? OffMap::outlier : OffMap::far;
    candidates_.push_back(i);
    state_.push_back(static_cast<unsigned char>(how_far));
  }
}

std::span<const Obstacle> ObstacleFinder::find(const Fix& fix, const LaserScan& scan) {
  const Look look(fix, scan, options_);
  choose_points(fix);
  found_ = 0;
  const std::size_t count = candidates_.size();
  std::size_t first = 0;
  std::size_t end = count;
  // What stands across the seam of a full turn begins with the last points.
  if (count > 1 && is_full_turn(fix, scan) && look.belong_across_seam(candidates_.back(), candidates_.front())) {
    while (first + 1 < count && look.belong_together(candidates_[first], candidates_[first + 1])) ++first;
    ++first;
    for (std::size_t k = 0; k < first && first < count; ++k) {
      candidates_.push_back(candidates_[k]);
      state_.push_back(state_[k]);
    }
    if (first == count) first = 0;
    end = candidates_.size();
  }
  for (std::size_t k = first; k < end; ++k) {
    const bool goes_on = k + 1 < end && (k + 1 == count || look.belong_together(candidates_[k], candidates_[k + 1]));
    if (goes_on) continue;
    add(look, first, k + 1);
    first = k + 1;
  }
  const auto found = std::span(obstacles_).first(found_);
  std::sort(found.begin(), found.end(), [](const Obstacle& a, const Obstacle& b) { return a.distance < b.distance; });
  return found;
}

/// What most rays of a group say, by a few of them: the group is one thing.
RayClass ObstacleFinder::class_of(const Look& look, std::span<const int> points) const {
  if (!look.fix.map) return RayClass::unknown;
  constexpr std::size_t most = 5;
  const double tolerance = look.fix.match.obstacle_distance > 0.0 ? 0.5 * look.fix.match.obstacle_distance : 0.03;
  const RayClassifier classify(look.fix.map->indexed(), tolerance);
  std::array<int, 4> votes{};
  const std::size_t count = std::min(most, points.size());
  for (std::size_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(points[evenly_chosen(k, count, points.size())]);
    const RayClass said = classify(look.in_map(look.origin(i)), look.in_map(look.fix.scan.in_robot[i]));
    ++votes[static_cast<std::size_t>(said)];
    if (2 * static_cast<std::size_t>(votes[static_cast<std::size_t>(said)]) > count) return said;
  }
  return static_cast<RayClass>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

/// Candidates `from` to `to`, if they make an obstacle.
void ObstacleFinder::add(const Look& look, std::size_t from, std::size_t to) {
  const auto points = std::span<const int>(candidates_).subspan(from, to - from);
  const auto states = std::span<const unsigned char>(state_).subspan(from, to - from);
  if (points.size() < static_cast<std::size_t>(options_.min_points)) return;
  const auto near_ones = std::count(states.begin(), states.end(), static_cast<unsigned char>(OffMap::near));
  const auto far_ones = static_cast<std::ptrdiff_t>(points.size()) - near_ones;
  if (far_ones < std::min<std::ptrdiff_t>(options_.min_far_points, static_cast<std::ptrdiff_t>(points.size()))) return;
  const RayClass ray_class = class_of(look, points);
  const bool has_outlier =
      std::find(states.begin(), states.end(), static_cast<unsigned char>(OffMap::outlier)) != states.end();
  if (!has_outlier && ray_class != RayClass::obstacle) return;

  if (found_ == obstacles_.size()) obstacles_.emplace_back();
  Obstacle& obstacle = obstacles_[found_++];
  obstacle.points.assign(points.begin(), points.end());
  obstacle.ray_class = ray_class;
  double nearest2 = std::numeric_limits<double>::infinity();
  in_map_.clear();
  for (const int point : points) {
    const auto i = static_cast<std::size_t>(point);
    in_map_.push_back(look.in_map(look.fix.scan.in_robot[i]));
    const double range2 = (look.fix.scan.in_robot[i] - look.origin(i)).squaredNorm();
    if (range2 >= nearest2) continue;
    nearest2 = range2;
    obstacle.nearest = in_map_.back();
  }
  obstacle.distance = std::sqrt(nearest2);
  obstacle.box = boxes_.smallest(in_map_);
  const auto front = static_cast<std::size_t>(points.front());
  const auto back = static_cast<std::size_t>(points.back());
  obstacle.first_end_seen = look.ends_before(front, points.front() - 1, -1);
  obstacle.last_end_seen = look.ends_before(back, points.back() + 1, 1);
  obstacle.shape = {};
  if (!options_.shapes) return;
  obstacle.shape = shapes_.find({in_map_, look.in_map(look.origin(front)), look.increment, std::max(look.noise, 0.002),
                                 obstacle.first_end_seen, obstacle.last_end_seen});
}

}  // namespace slamicp
