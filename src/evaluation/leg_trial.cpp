// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/leg_trial.hpp>
#include <slamicp/scan/scan_points.hpp>

namespace slamicp {

TrackingSetup setup_for_legs() {
  TrackingSetup setup;
  setup.localization.outlier_distance = 0.15;
  setup.localization.ranges.min_range = 0.76;
  setup.detection.min_points = 3;
  setup.detection.min_incidence_deg = 45.0;
  return setup;
}

namespace {

/// A square of the plane that readings ended in, and what later looks at it showed.
struct BackgroundCell {
  Point2 sum = Point2::Zero();  // of the readings that ended in it [m]
  int readings = 0;
  int taken = 0;  // scans that show something there
  int free = 0;   // scans that look through it

  Point2 place() const noexcept { return sum / readings; }
};

constexpr double cell_side = 0.05;  // [m]

using BackgroundCells = std::map<std::pair<int, int>, BackgroundCell>;

/// What a scan shows of each cell: taken where a ray about it ends there, free where those at it go on. No return is
/// nothing there, as it was something when it was seen first.
void look_at(const LaserScan& scan, const Pose2& T_map_robot, BackgroundCells& cells) {
  const Pose2 T_laser_map = (T_map_robot * scan.T_robot_laser).inverse();
  const auto beams = static_cast<double>(scan.ranges.size());
  for (auto& [where, cell] : cells) {
    const Point2 place = T_laser_map * cell.place();
    const double range = place.norm();
    const double beam = (std::atan2(place.y(), place.x()) - scan.angle_min) / scan.angle_increment;
    const double wide = cell_side / range / scan.angle_increment + 1.0;
    if (!(beam >= wide && beam + wide <= beams - 1.0) || range >= scan.range_max) continue;
    bool is_taken = false;
    bool is_free = true;
    for (auto k = static_cast<std::size_t>(beam - wide); k <= static_cast<std::size_t>(beam + wide); ++k) {
      if (!is_return(scan, scan.ranges[k])) continue;
      const double beyond = static_cast<double>(scan.ranges[k]) - range;
      is_taken |= std::abs(beyond) < 2.0 * cell_side;
      is_free &= beyond > 2.0 * cell_side || std::abs(static_cast<double>(k) - beam) > 1.0;
    }
    cell.taken += is_taken ? 1 : 0;
    cell.free += is_free && !is_taken ? 1 : 0;
  }
}

}  // namespace

PointMap2::Pointer background_of(std::span<const LaserScan> scans, const Trajectory& trajectory) {
  if (scans.size() != trajectory.size())
    throw Error("scans and poses are not as many", "background_of", "give one pose for each scan");
  BackgroundCells cells;
  ScanPoints points;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    to_points(scans[k], {}, points);
    for (const Point2& in_robot : points.in_robot) {
      const Point2 in_map = trajectory[k].pose * in_robot;
      BackgroundCell& cell = cells[{static_cast<int>(std::floor(in_map.x() / cell_side)),
                                    static_cast<int>(std::floor(in_map.y() / cell_side))}];
      cell.sum += in_map;
      ++cell.readings;
    }
  }
  for (std::size_t k = 0; k < scans.size(); ++k) look_at(scans[k], trajectory[k].pose, cells);
  PointCloud2 stays;
  for (const auto& [where, cell] : cells)
    if (2 * cell.taken > cell.free && 15 * static_cast<std::size_t>(cell.taken) >= scans.size())
      stays.push_back(cell.place());
  return PointMap2::create(std::move(stays));
}

void follow_log(std::span<const LaserScan> scans, PointMap2::Pointer map, const Pose2& first,
                const TrackingSetup& setup, const std::function<void(const TrackedScan&)>& each) {
  Localizer localizer(std::move(map), setup.localization);
  localizer.set_pose(first);
  ObstacleFinder finder(setup.detection);
  ObstacleTracker tracker(setup.tracking);
  for (const LaserScan& scan : scans) {
    const Fix& fix = localizer.update(scan);
    const std::span<const Obstacle> obstacles = finder.find(fix, scan);
    each({scan, fix, obstacles, tracker.update(fix, scan, obstacles)});
  }
}

namespace {

/// One leg, or both side by side.
void add_legs_of(const OrientedBox& box, PointCloud2& legs) {
  constexpr double widest_leg = 0.25;  // [m]
  const Point2 along(std::cos(box.heading), std::sin(box.heading));
  const double apart = box.width > widest_leg ? 0.5 * (box.width - 0.5 * widest_leg) : 0.0;
  legs.push_back(box.centre + apart * along);
  if (apart > 0.0) legs.push_back(box.centre - apart * along);
}

}  // namespace

PointCloud2 legs_of(const TrackedScan& tracked) {
  PointCloud2 legs;
  for (const Track& track : tracked.tracks) {
    if (track.kind == TrackKind::thing || track.state != TrackState::confirmed) continue;
    if (track.kind == TrackKind::leg) {
      legs.push_back(track.position);
      continue;
    }
    for (const int obstacle : track.obstacles)
      if (obstacle >= 0) add_legs_of(tracked.obstacles[static_cast<std::size_t>(obstacle)].box, legs);
  }
  return legs;
}

void add_legs(const TrackedScan& tracked, PointView<2> labels, double reach, LegScore& score) {
  const PointCloud2 legs = legs_of(tracked);
  struct LegPair {
    double distance;
    std::size_t label, leg;
  };
  std::vector<LegPair> pairs;
  for (std::size_t label = 0; label < labels.size(); ++label)
    for (std::size_t leg = 0; leg < legs.size(); ++leg)
      if (const double distance = (labels[label] - legs[leg]).norm(); distance < reach)
        pairs.push_back({distance, label, leg});
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const LegPair& a, const LegPair& b) { return a.distance < b.distance; });
  std::vector<char> label_found(labels.size(), 0), leg_taken(legs.size(), 0);
  for (const LegPair& pair : pairs) {
    if (label_found[pair.label] != 0 || leg_taken[pair.leg] != 0) continue;
    label_found[pair.label] = leg_taken[pair.leg] = 1;
    ++score.found;
  }
  ++score.scans;
  score.labels += labels.size();
  score.leg_tracks +=
      static_cast<std::size_t>(std::count_if(tracked.tracks.begin(), tracked.tracks.end(), [](const Track& track) {
        return track.kind != TrackKind::thing && track.state == TrackState::confirmed;
      }));
}

}  // namespace slamicp
