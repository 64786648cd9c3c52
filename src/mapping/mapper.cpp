// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numeric>
#include <vector>

#include <slamicp/error.hpp>
#include <slamicp/mapping/mapper.hpp>

#include "mapping/map_refinement.hpp"

namespace slamicp {
namespace {

LocalizerOptions localizer_options(const MapperOptions& options) {
  if (const std::string problem = options.problem(); !problem.empty()) throw Error(problem, "MapperOptions");
  LocalizerOptions localizer;
  localizer.max_correspondence_distance = options.max_correspondence_distance;
  localizer.outlier_distance = options.insertion_distance;
  localizer.method = options.method;
  localizer.max_iterations = options.max_iterations;
  localizer.final_gate = std::min(options.final_gate, options.max_correspondence_distance);
  localizer.guess_share = options.guess_share;
  localizer.ranges = options.ranges;
  localizer.use_odometry = options.use_odometry;
  localizer.deskew = options.deskew;
  localizer.outputs = {.mean_inlier_distance = true,
                       .outlier_indices = options.update == MapUpdate::outliers,
                       .outliers_in_map = true,
                       .transformed_scan = options.update == MapUpdate::all_points,
                       .matches = options.update == MapUpdate::outliers};
  localizer.quality.rays = 0;
  return localizer;
}

PointCloud2 in_map(const Fix& fix) {
  PointCloud2 points;
  points.reserve(fix.scan.in_robot.size());
  for (const Point2& point : fix.scan.in_robot) points.push_back(fix.pose * point);
  return points;
}

std::vector<int> all_points_of(const Fix& fix) {
  std::vector<int> all(fix.scan.in_robot.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

std::string MapperOptions::problem() const {
  if (!(insertion_distance > 0.0)) return "insertion_distance must be a length above 0 m; 0.05 m is the default";
  if (!(keyframe_distance > 0.0)) return "keyframe_distance must be a length above 0 m; 0.3 m is the default";
  if (!(keyframe_turn > 0.0)) return "keyframe_turn must be an angle above 0 rad; 0.17 is the default";
  if (!(final_gate > 0.0)) return "final_gate must be a length above 0 m; 0.15 m is the default";
  if (!(ranges.max_range > ranges.min_range) || !(ranges.min_range >= 0.0))
    return "ranges must have 0 <= min_range < max_range";
  if (!(forget_distance >= 0.0)) return "forget_distance must be a length above 0 m, or 0 to forget nothing";
  if (!initial_pose.is_finite()) return "initial_pose must be finite";
  IcpOptions icp;
  icp.max_correspondence_distance = max_correspondence_distance;
  icp.max_iterations = max_iterations;
  icp.guess_share = guess_share;
  return icp.problem();
}

Mapper::Mapper(const MapperOptions& options)
    : options_(options),
      localizer_(localizer_options(options)),
      refinement_(std::make_unique<MapRefinement>(options.insertion_distance)) {
  localizer_.set_pose(options.initial_pose);
}

Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

PointMap2::Pointer Mapper::refined_map() const {
  if (!map() || options_.update == MapUpdate::all_points || options_.forget_distance > 0.0) return map();
  SurfaceOptions finished = options_.surfaces;
  finished.scatter = SurfaceOptions{}.scatter;  // now the map is dense where the robot has been
  return PointMap2::create(refinement_->refined(*map()), finished);
}

const Fix& Mapper::add(const LaserScan& scan) {
  const Fix& fix = localizer_.update(scan);
  trajectory_.push_back({scan.stamp, fix.pose});
  const bool unmatched = fix.stop() == Stop::no_overlap || fix.stop() == Stop::too_few_points;
  if (keyframes_ == 0) {
    if (fix.scan.in_robot.empty()) return fix;
    refinement_->expect(0, fix, all_points_of(fix));
    localizer_.set_map(PointMap2::create(in_map(fix), options_.surfaces));
    last_keyframe_ = fix.pose;
    keyframes_ = 1;
    return fix;
  }
  if (unmatched) ++unmatched_;
  if (moved_on(fix.pose)) grow(fix);
  return fix;
}

bool Mapper::moved_on(const Pose2& pose) const noexcept {
  const PoseDistance moved = distance(last_keyframe_, pose);
  return moved.translation > options_.keyframe_distance || moved.rotation > options_.keyframe_turn;
}

void Mapper::grow(const Fix& fix) {
  last_keyframe_ = fix.pose;
  ++keyframes_;
  if (fix.stop() == Stop::no_overlap) {
    // Nothing known is in sight: the map goes on where the prediction says.
    refinement_->expect(map()->size(), fix, all_points_of(fix));
    localizer_.set_map(map()->with_added(in_map(fix)));
  } else if (options_.update == MapUpdate::all_points) {
    localizer_.set_map(update_with_all_points<2>(map(), fix.match));
  } else {
    if (!(options_.forget_distance > 0.0)) {
      refinement_->count(fix);
      refinement_->expect(map()->size(), fix, fix.outliers());
    }
    localizer_.set_map(update_with_outliers<2>(map(), fix.match));
  }
  if (options_.forget_distance > 0.0) forget_far_points();
}

/// In one go, once they are a tenth of all. Removed points keep their numbers: where most are gone the rest starts
/// anew.
void Mapper::forget_far_points() {
  const Point2 here = localizer_.fix().pose.translation();
  const double farthest2 = options_.forget_distance * options_.forget_distance;
  std::vector<int> far;
  PointCloud2 near;
  const PointView<2> points = map()->points();
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!is_finite<2>(points[k])) continue;
    if ((points[k] - here).squaredNorm() > farthest2)
      far.push_back(static_cast<int>(k));
    else
      near.push_back(points[k]);
  }
  if (10 * far.size() <= points.size() || near.empty()) return;
  if (2 * near.size() > points.size())
    localizer_.set_map(map()->with_removed(far));
  else
    localizer_.set_map(PointMap2::create(std::move(near), options_.surfaces));
}

}  // namespace slamicp
