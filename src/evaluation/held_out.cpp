// SPDX-License-Identifier: Apache-2.0
#include <Eigen/LU>
#include <cmath>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/held_out.hpp>
#include <slamicp/evaluation/jump_trial.hpp>
#include <slamicp/localization/localizer.hpp>
#include <slamicp/mapping/mapper.hpp>
#include <slamicp/registration/icp.hpp>

namespace slamicp {
namespace {

bool has_moved_on(const Pose2& from, const Pose2& to, double metres, double radians) noexcept {
  const PoseDistance moved = distance(from, to);
  return moved.translation > metres || moved.rotation > radians;
}

/// The scan's points that no map point is near.
PointCloud2 news_of(const PlacedRecord& scan, const PointMap2* map, double resolution) {
  PointCloud2 news;
  for (const Point2& point : scan.in_robot) {
    const Point2 in_map = scan.pose * point;
    if (map == nullptr || map->indexed().nearest(in_map, resolution).index < 0) news.push_back(in_map);
  }
  return news;
}

/// Where the scans saw each point, on average.
PointCloud2 seen_twice(std::span<const PlacedRecord* const> scans, const PointMap2& map, double resolution) {
  PointCloud2 sums(map.size(), Point2::Zero());
  std::vector<int> counts(map.size(), 0);
  for (const PlacedRecord* scan : scans)
    for (const Point2& point : scan->in_robot) {
      const Point2 in_map = scan->pose * point;
      const int nearest = map.indexed().nearest(in_map, resolution).index;
      if (nearest < 0) continue;
      sums[static_cast<std::size_t>(nearest)] += in_map;
      ++counts[static_cast<std::size_t>(nearest)];
    }
  PointCloud2 means;
  for (std::size_t k = 0; k < sums.size(); ++k)
    if (counts[k] >= 2) means.emplace_back(sums[k] / static_cast<double>(counts[k]));
  return means;
}

/// A run through a map, and single matches beside it.
class HeldOutLocalizer {
 public:
  HeldOutLocalizer(const PointMap2::Pointer& map, const Pose2& start) : localizer_(map) { localizer_.set_pose(start); }

  /// @returns false where it had lost its way, and was put back
  bool update(const LaserScan& scan, const Pose2& reference) {
    const Fix& fix = localizer_.update(scan);
    const bool on_track = is_right(fix.pose, reference);
    if (!on_track) localizer_.set_pose(reference);
    icp_.set_rays({scan.T_robot_laser.translation(), std::abs(scan.angle_increment)});
    icp_.align(fix.map->indexed(), fix.scan.in_robot, fix.predicted, {.covariance = true});
    return on_track;
  }

  const Fix& fix() const noexcept { return localizer_.fix(); }
  const IcpResult2& match() const noexcept { return icp_.result(); }

 private:
  Localizer localizer_;
  Icp<2> icp_;
};

/// Of two estimates of one pose.
IndependentPair difference_of(const Pose2& here, const Matrix<3, 3>& of_here, const Pose2& there,
                              const Matrix<3, 3>& of_there) {
  IndependentPair pair;
  pair.difference = (there.inverse() * here).log();
  pair.covariance = of_here + of_there;
  return pair;
}

}  // namespace

std::vector<PlacedRecord> place_scans(std::span<const LaserScan> log) {
  Mapper mapper;
  std::vector<PlacedRecord> placed;
  placed.reserve(log.size());
  for (const LaserScan& scan : log) {
    const Fix& fix = mapper.add(scan);
    placed.push_back({scan, fix.scan.in_robot, fix.pose});
  }
  return placed;
}

PointMap2::Pointer map_of(std::span<const PlacedRecord* const> scans, double resolution) {
  PointMap2::Pointer map;
  const PlacedRecord* last = nullptr;
  for (const PlacedRecord* scan : scans) {
    if (last != nullptr && !has_moved_on(last->pose, scan->pose, 0.3, 0.17)) continue;
    PointCloud2 news = news_of(*scan, map.get(), resolution);
    last = scan;
    if (news.empty()) continue;
    map = map ? map->with_added(news) : PointMap2::create(std::move(news));
  }
  if (!map) throw Error("no scan has points", "map_of", "give more scans");
  return PointMap2::create(seen_twice(scans, *map, resolution));
}

HeldOutLog take_apart(std::span<const PlacedRecord> log) {
  std::vector<const PlacedRecord*> of_map, of_other;
  HeldOutLog parts;
  for (std::size_t k = 0; k < log.size(); ++k) {
    std::vector<const PlacedRecord*>& part = k % 2 == 1 ? parts.run : k % 4 == 0 ? of_map : of_other;
    part.push_back(&log[k]);
  }
  parts.map = map_of(of_map);
  parts.other_map = map_of(of_other);
  return parts;
}

LaserScan half_of_beams(const LaserScan& scan, std::size_t first) {
  LaserScan half = scan;
  half.ranges.clear();
  for (std::size_t i = first; i < scan.ranges.size(); i += 2) half.ranges.push_back(scan.ranges[i]);
  half.stamp += static_cast<double>(first) * scan.time_increment;
  half.time_increment *= 2.0;
  half.angle_min += static_cast<double>(first) * scan.angle_increment;
  half.angle_increment *= 2.0;
  return half;
}

double IndependentPair::nees() const noexcept {
  return difference.dot(Eigen::Matrix3d(covariance).inverse() * difference);
}

HeldOutPairs compare(const HeldOutLog& log) {
  HeldOutPairs pairs;
  if (log.run.empty()) return pairs;
  Pose2 last = log.run.front()->pose;
  HeldOutLocalizer here(log.map, last), there(log.other_map, last);
  for (const PlacedRecord* record : log.run) {
    const bool is_here = here.update(half_of_beams(record->scan, 0), record->pose);
    const bool is_there = there.update(half_of_beams(record->scan, 1), record->pose);
    pairs.lost_tracks += !is_here + !is_there;
    if (!is_here || !is_there) continue;
    if (!has_moved_on(last, record->pose, 0.1, 0.1)) continue;
    last = record->pose;
    const Fix& a = here.fix();
    const Fix& b = there.fix();
    IndependentPair fixes = difference_of(a.pose, a.covariance, b.pose, b.covariance);
    fixes.usable = a.usable() && b.usable();
    fixes.blind = !a.blind_direction.isZero() || !b.blind_direction.isZero();
    pairs.fixes.push_back(fixes);
    const Uncertainty& told_a = here.match().uncertainty;
    const Uncertainty& told_b = there.match().uncertainty;
    IndependentPair matches =
        difference_of(here.match().pose, told_a.covariance, there.match().pose, told_b.covariance);
    matches.usable = told_a.known && told_b.known && here.match().usable() && there.match().usable();
    matches.blind = told_a.blind || told_b.blind;
    pairs.matches.push_back(matches);
  }
  return pairs;
}

}  // namespace slamicp
