// SPDX-License-Identifier: Apache-2.0
#include <stddef.h>
#include <string.h>

#include "mex_support.h"

#define LOCALIZER_OPTION(field, is_whole) \
  { #field, offsetof(slamicp_localizer_options, field), is_whole }
static const option localizer_options[] = {LOCALIZER_OPTION(method, true),
                                           LOCALIZER_OPTION(max_iterations, true),
                                           LOCALIZER_OPTION(outlier_distance, false),
                                           LOCALIZER_OPTION(obstacle_distance, false),
                                           LOCALIZER_OPTION(max_correspondence_distance, false),
                                           LOCALIZER_OPTION(final_gate, false),
                                           LOCALIZER_OPTION(guess_share, false),
                                           LOCALIZER_OPTION(min_range, false),
                                           LOCALIZER_OPTION(max_range, false),
                                           LOCALIZER_OPTION(use_odometry, true),
                                           LOCALIZER_OPTION(deskew, true)};

/// handle = localizer_new(map, 'name', value, ...); map 0: none, scan to scan
void command_localizer_new(const mex_call* call) {
  need_inputs(call, 1, 1 + 2 * 11);
  need_outputs(call, 1);
  const slamicp_map* const map = need_number(call->input[0], "the handle") == 0.0 ? NULL : need_map(call->input[0]);
  slamicp_localizer_options options;
  check(slamicp_localizer_options_init(&options, sizeof options));
  read_options(call, 1, localizer_options, sizeof localizer_options / sizeof *localizer_options, &options);
  slamicp_localizer* localizer = NULL;
  check(slamicp_localizer_create(map, &options, &localizer));
  call->output[0] = mxCreateDoubleScalar(keep_localizer(localizer));
}

/// localizer_pose(handle, P)
void command_localizer_pose(const mex_call* call) {
  need_inputs(call, 2, 2);
  need_outputs(call, 0);
  slamicp_localizer* const localizer = need_localizer(call->input[0]);
  check(slamicp_localizer_set_pose(localizer, need_numbers(call->input[1], "P", 3)));
}

/// localizer_map(handle, map)
void command_localizer_map(const mex_call* call) {
  need_inputs(call, 2, 2);
  need_outputs(call, 0);
  slamicp_localizer* const localizer = need_localizer(call->input[0]);
  check(slamicp_localizer_set_map(localizer, need_map(call->input[1])));
}

// Ranges may be doubles, which MATLAB makes of everything, or singles, as lidars have them.
static const float* need_ranges(const mxArray* given, size_t* count) {
  *count = (size_t)mxGetNumberOfElements(given);
  if (mxIsComplex(given) || mxIsSparse(given)) refuse("bad_type", "ranges must be real and full");
  if (!mxIsSingle(given) && !mxIsDouble(given))
    refuse("bad_type", "ranges must be of class double or single, not %s", mxGetClassName(given));
  if (*count == 0 || mxGetNumberOfDimensions(given) != 2 || (mxGetM(given) != 1 && mxGetN(given) != 1))
    refuse("bad_scan", "ranges must be a vector, a range a beam [m]");
  if (mxIsSingle(given)) return mxGetData(given);
  float* const ranges = mxMalloc(*count * sizeof *ranges);  // freed when the MEX call ends
  const double* const doubles = mxGetPr(given);
  for (size_t k = 0; k < *count; ++k) ranges[k] = (float)doubles[k];
  return ranges;
}

static void set_field(mxArray* made, mwIndex index, const char* name, mxArray* value) {
  mxSetField(made, index, name, value);
}

static mxArray* struct_of(const slamicp_fix* fix) {
  static const char* names[] = {"stamp",       "pose",      "predicted", "covariance",
                                "stop",        "usable",    "state",     "iterations",
                                "probability", "awareness", "inliers",   "mean_inlier_distance",
                                "points",      "beams",     "outliers",  "outliers_in_map"};
  mxArray* const made = mxCreateStructMatrix(1, 1, (int)(sizeof names / sizeof *names), names);
  set_field(made, 0, "stamp", mxCreateDoubleScalar(fix->stamp));
  set_field(made, 0, "pose", matrix_of(fix->pose, 1, 3));
  set_field(made, 0, "predicted", matrix_of(fix->predicted, 1, 3));
  set_field(made, 0, "covariance", matrix_of(fix->covariance, 3, 3));  // symmetric: rows or columns first is the same
  set_field(made, 0, "stop", mxCreateString(slamicp_stop_name(fix->stop)));
  set_field(made, 0, "usable", mxCreateLogicalScalar(fix->usable != 0));
  set_field(made, 0, "state", mxCreateString(slamicp_state_name(fix->state)));
  set_field(made, 0, "iterations", mxCreateDoubleScalar(fix->iterations));
  set_field(made, 0, "probability", mxCreateDoubleScalar(fix->probability));
  set_field(made, 0, "awareness", mxCreateDoubleScalar(fix->awareness));
  set_field(made, 0, "inliers", mxCreateDoubleScalar((double)fix->inliers));
  set_field(made, 0, "mean_inlier_distance", mxCreateDoubleScalar(fix->mean_inlier_distance));
  set_field(made, 0, "points", matrix_of(fix->points_in_robot, 2, fix->points));
  set_field(made, 0, "beams", indices_of(fix->beams, fix->points));
  set_field(made, 0, "outliers", indices_of(fix->outlier_indices, fix->outliers));
  set_field(made, 0, "outliers_in_map", matrix_of(fix->outliers_in_map, 2, fix->outliers));
  return made;
}

#define SCAN_OPTION(field) \
  { #field, offsetof(slamicp_scan, field), false }
static const option scan_options[] = {SCAN_OPTION(stamp), SCAN_OPTION(time_increment), SCAN_OPTION(range_min),
                                      SCAN_OPTION(range_max)};

/// fix = localizer_update(handle, ranges, angle_min, angle_increment, laser_pose, odometry, 'name', value, ...); an
/// empty pose is none
void command_localizer_update(const mex_call* call) {
  need_inputs(call, 6, 6 + 2 * 4);
  need_outputs(call, 1);
  slamicp_localizer* const localizer = need_localizer(call->input[0]);
  slamicp_scan scan;
  check(slamicp_scan_init(&scan, sizeof scan));
  scan.ranges = need_ranges(call->input[1], &scan.count);
  scan.angle_min = need_number(call->input[2], "angle_min");
  scan.angle_increment = need_number(call->input[3], "angle_increment");
  if (!mxIsEmpty(call->input[4]))
    memcpy(scan.T_robot_laser, need_numbers(call->input[4], "laser_pose", 3), sizeof scan.T_robot_laser);
  if (!mxIsEmpty(call->input[5])) {
    memcpy(scan.T_odom_robot, need_numbers(call->input[5], "odometry", 3), sizeof scan.T_odom_robot);
    scan.has_odometry = 1;
  }
  read_options(call, 6, scan_options, sizeof scan_options / sizeof *scan_options, &scan);
  slamicp_fix fix;
  check(slamicp_fix_init(&fix, sizeof fix));
  check(slamicp_localizer_update(localizer, &scan, &fix));
  call->output[0] = struct_of(&fix);
}

/// found = localizer_recover(handle, budget)
void command_localizer_recover(const mex_call* call) {
  need_inputs(call, 2, 2);
  need_outputs(call, 1);
  slamicp_localizer* const localizer = need_localizer(call->input[0]);
  int32_t found = 0;
  check(slamicp_localizer_recover(localizer, need_whole_number(call->input[1], "budget", 1), &found));
  call->output[0] = mxCreateLogicalScalar(found != 0);
}

/// obstacles = localizer_obstacles(handle)
void command_localizer_obstacles(const mex_call* call) {
  static const char* names[] = {
      "centre",       "width",       "depth",       "heading",       "distance", "nearest",    "ray_class",  "shape",
      "shape_centre", "shape_width", "shape_depth", "shape_heading", "radius",   "width_seen", "depth_seen", "points"};
  need_inputs(call, 1, 1);
  need_outputs(call, 1);
  slamicp_localizer* const localizer = need_localizer(call->input[0]);
  size_t count = 0;
  check(slamicp_localizer_find_obstacles(localizer, NULL, &count));
  mxArray* const made = mxCreateStructMatrix(1, (mwSize)count, (int)(sizeof names / sizeof *names), names);
  slamicp_obstacle obstacle;
  check(slamicp_obstacle_init(&obstacle, sizeof obstacle));
  for (size_t k = 0; k < count; ++k) {
    check(slamicp_localizer_obstacle(localizer, k, &obstacle));
    const mwIndex at = (mwIndex)k;
    set_field(made, at, "centre", matrix_of(obstacle.centre, 2, 1));
    set_field(made, at, "width", mxCreateDoubleScalar(obstacle.width));
    set_field(made, at, "depth", mxCreateDoubleScalar(obstacle.depth));
    set_field(made, at, "heading", mxCreateDoubleScalar(obstacle.heading));
    set_field(made, at, "distance", mxCreateDoubleScalar(obstacle.distance));
    set_field(made, at, "nearest", matrix_of(obstacle.nearest, 2, 1));
    set_field(made, at, "ray_class", mxCreateString(slamicp_ray_class_name(obstacle.ray_class)));
    set_field(made, at, "shape", mxCreateString(slamicp_shape_name(obstacle.shape)));
    set_field(made, at, "shape_centre", matrix_of(obstacle.shape_centre, 2, 1));
    set_field(made, at, "shape_width", mxCreateDoubleScalar(obstacle.shape_width));
    set_field(made, at, "shape_depth", mxCreateDoubleScalar(obstacle.shape_depth));
    set_field(made, at, "shape_heading", mxCreateDoubleScalar(obstacle.shape_heading));
    set_field(made, at, "radius", mxCreateDoubleScalar(obstacle.radius));
    set_field(made, at, "width_seen", mxCreateLogicalScalar(obstacle.width_seen != 0));
    set_field(made, at, "depth_seen", mxCreateLogicalScalar(obstacle.depth_seen != 0));
    set_field(made, at, "points", indices_of(obstacle.point_indices, obstacle.points));
  }
  call->output[0] = made;
}
