// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "conversion.hpp"
#include "handles.hpp"
#include "sized.hpp"

namespace slamicp::c {
namespace {

slamicp_icp_options default_icp_options() noexcept {
  const IcpOptions options;
  slamicp_icp_options made = {};
  made.size = sizeof made;
  made.method = SLAMICP_POINT_TO_LINE;
  made.max_iterations = options.max_iterations;
  made.max_correspondence_distance = options.max_correspondence_distance;
  made.final_gate = options.final_gate;
  made.guess_share = options.guess_share;
  made.coarse_to_fine = options.coarse_to_fine ? 1 : 0;
  made.kernel_scale = options.kernel_scale;
  made.translation_tolerance = options.translation_tolerance;
  made.rotation_tolerance = options.rotation_tolerance;
  return made;
}

template <int D>
Icp<D>& solver_of(slamicp_icp& icp) noexcept {
  if constexpr (D == 2)
    return icp.plane;
  else
    return icp.space;
}

template <int D>
slamicp_result told(const IcpResult<D>& from, std::size_t points, std::vector<slamicp_match>& matches) {
  slamicp_result result = {};
  result.dimension = D;
  result.stop = static_cast<int32_t>(from.stop);
  result.usable = from.usable() ? 1 : 0;
  result.iterations = from.iterations;
  write_pose(from.pose, result.pose);
  write_transform<D>(from.pose, result.transform);
  write_covariance(from.uncertainty.covariance, result.covariance);
  result.mean_inlier_distance = from.mean_inlier_distance;
  result.inliers = from.inliers;
  result.points = points;
  result.outliers = std::max(from.outlier_indices.size(), from.outliers_in_map.size());
  result.updated_map_points = from.updated_map.size();
  result.outlier_indices = pointer_or_null(from.outlier_indices);
  result.outliers_in_map = numbers_or_null<D>(from.outliers_in_map);
  result.transformed_scan = numbers_or_null<D>(from.transformed_scan);
  result.updated_map = numbers_or_null<D>(from.updated_map);
  copy_matches(from.matches, matches);
  result.matches = pointer_or_null(matches);
  return result;
}

template <int D>
slamicp_result align_in(slamicp_icp& icp, const IndexedPoints<D>& map, const double* scan, std::size_t count,
                        const double* guess, uint32_t outputs) {
  const PointView<D> points = view_of<D>(scan, count, "scan");
  const Pose<D> start = pose_from<D>(guess, "guess");
  Icp<D>& solver = solver_of<D>(icp);
  if (solver.options().method != Method::point_to_point && !map.has_surfaces())
    throw Refusal(SLAMICP_BAD_STATE,
                  "the map was made without lines, with neighbours = 0: good for point to point only");
  return told<D>(solver.align(map, points, start, outputs_from(outputs)), count, icp.matches);
}

/// As the library's align() does: an index for one match only.
template <int D>
IndexedPoints<D> index_once(const double* target, std::size_t count, Method method) {
  SurfaceOptions surfaces = SurfaceOptions::sparse();
  if (method == Method::point_to_point) surfaces.neighbours = 0;
  PointCloud<D> points = to_cloud<D>(view_of_some<D>(target, count, "target"));
  if constexpr (D == 2)
    return IndexedPoints<D>(std::move(points), surfaces, {.eager = false});
  else
    return IndexedPoints<D>(std::move(points), surfaces);
}

template <int D>
slamicp_result align_once(slamicp_icp& icp, const double* target, std::size_t target_count, const double* scan,
                          std::size_t count, const double* guess, uint32_t outputs) {
  outputs_from(outputs);  // what is wrong is told before the work
  view_of<D>(scan, count, "scan");
  pose_from<D>(guess, "guess");
  return align_in<D>(icp, index_once<D>(target, target_count, solver_of<D>(icp).options().method), scan, count, guess,
                     outputs);
}

}  // namespace
}  // namespace slamicp::c

using namespace slamicp;
using namespace slamicp::c;

slamicp_status slamicp_icp_options_init(slamicp_icp_options* options, size_t size) {
  return initialize(options, size, default_icp_options(), "options");
}

slamicp_status slamicp_result_init(slamicp_result* result, size_t size) {
  return initialize(result, size, {}, "result");
}

slamicp_status slamicp_icp_create(const slamicp_icp_options* options, slamicp_icp** icp) {
  return guarded(SLAMICP_BAD_OPTIONS, [&] {
    need(icp, "icp");
    const IcpOptions chosen = icp_options_from(read_or(options, default_icp_options(), "options"));
    *icp = std::make_unique<slamicp_icp>(chosen).release();
  });
}

void slamicp_icp_free(slamicp_icp* icp) { delete icp; }

slamicp_status slamicp_icp_align(slamicp_icp* icp, const slamicp_map* map, const double* scan, size_t count,
                                 const double* guess, uint32_t outputs, slamicp_result* result) {
  return guarded(SLAMICP_BAD_STATE, [&] {
    need(icp, "icp");
    need(map, "map");
    check_size(result, "result");
    write(result, map->plane ? align_in<2>(*icp, map->plane->indexed(), scan, count, guess, outputs)
                             : align_in<3>(*icp, map->space->indexed(), scan, count, guess, outputs));
  });
}

slamicp_status slamicp_icp_align_points(slamicp_icp* icp, int32_t dimension, const double* target, size_t target_count,
                                        const double* scan, size_t count, const double* guess, uint32_t outputs,
                                        slamicp_result* result) {
  return guarded(SLAMICP_BAD_STATE, [&] {
    need(icp, "icp");
    check_size(result, "result");
    if (dimension == 2)
      write(result, align_once<2>(*icp, target, target_count, scan, count, guess, outputs));
    else if (dimension == 3)
      write(result, align_once<3>(*icp, target, target_count, scan, count, guess, outputs));
    else
      throw Refusal(SLAMICP_BAD_POINTS, "the dimension must be 2 or 3");
  });
}
