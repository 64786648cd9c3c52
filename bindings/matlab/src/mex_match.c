// SPDX-License-Identifier: Apache-2.0
#include <math.h>
#include <stddef.h>

#include "mex_support.h"

// Only what is asked for is computed: the paper, section 3.3.
static uint32_t outputs_for(int count) {
  static const uint32_t each[7] = {0,
                                   0,
                                   SLAMICP_MEAN_INLIER_DISTANCE,
                                   SLAMICP_OUTLIER_INDICES,
                                   SLAMICP_OUTLIERS_IN_MAP,
                                   SLAMICP_TRANSFORMED_SCAN,
                                   SLAMICP_UPDATED_MAP};
  uint32_t outputs = 0;
  for (int k = 0; k < count && k < 7; ++k) outputs |= each[k];
  return outputs;
}

static void warn_of(const slamicp_result* result) {
  if (!result->usable)
    mexWarnMsgIdAndTxt("slamicp:not_usable",
                       "the match ended as '%s': the pose is (or keeps, in some direction) the one that was given",
                       slamicp_stop_name(result->stop));
}

// The inputs of eq. (10): whether M is a map's handle, M, T, indist, method, iter, Pprev, Ot.
static slamicp_result match(const mex_call* call, uint32_t outputs) {
  need_inputs(call, 8, 8);
  const bool by_handle = need_number(call->input[0], "by_handle") != 0.0;
  const cloud target = by_handle ? (cloud){NULL, 0, 0} : need_cloud(call->input[1], "M");
  const slamicp_map* const map = by_handle ? need_map(call->input[1]) : NULL;
  const cloud scan = need_cloud(call->input[2], "T");
  const int dimension = by_handle ? slamicp_map_dimension(map) : target.dimension;
  if (scan.dimension != dimension) refuse("bad_points", "M and T must both be 2 x K, or both 3 x K");

  slamicp_icp_options options;
  check(slamicp_icp_options_init(&options, sizeof options));
  options.max_correspondence_distance = need_number(call->input[3], "indist");
  options.method = need_method(call->input[4]);
  options.max_iterations = need_whole_number(call->input[5], "iter", 1);
  options.outlier_distance = need_number(call->input[7], "Ot");
  if (options.outlier_distance == 0.0) refuse("bad_options", "Ot must be a length above 0 m");
  const double* const guess = need_numbers(call->input[6], "Pprev", dimension == 2 ? 3 : 6);

  slamicp_icp* const icp = matcher_with(&options);
  slamicp_result result;
  check(slamicp_result_init(&result, sizeof result));
  check(by_handle ? slamicp_icp_align(icp, map, scan.points, scan.count, guess, outputs, &result)
                  : slamicp_icp_align_points(icp, dimension, target.points, target.count, scan.points, scan.count,
                                             guess, outputs, &result));
  warn_of(&result);
  return result;
}

/// [P, n, md, Oindx, Ocoords, tT, uM] = align(...), eq. (10)
void command_align(const mex_call* call) {
  need_outputs(call, 7);
  const slamicp_result result = match(call, outputs_for(call->outputs));
  const size_t rows = (size_t)result.dimension;
  mxArray** const out = call->output;
  out[0] = matrix_of(result.pose, 1, rows == 2 ? 3 : 6);
  if (call->outputs > 1) out[1] = mxCreateDoubleScalar(result.iterations);
  if (call->outputs > 2) out[2] = mxCreateDoubleScalar(result.mean_inlier_distance);
  if (call->outputs > 3) out[3] = indices_of(result.outlier_indices, result.outliers);
  if (call->outputs > 4) out[4] = matrix_of(result.outliers_in_map, rows, result.outliers);
  if (call->outputs > 5) out[5] = matrix_of(result.transformed_scan, rows, result.points);
  if (call->outputs > 6) out[6] = matrix_of(result.updated_map, rows, result.updated_map_points);
}

/// Tr = transform(...), T_map_robot as a matrix
void command_transform(const mex_call* call) {
  need_outputs(call, 1);
  const slamicp_result result = match(call, 0);
  const size_t size = (size_t)result.dimension + 1;
  call->output[0] = mxCreateDoubleMatrix((mwSize)size, (mwSize)size, mxREAL);
  double* const matrix = mxGetPr(call->output[0]);
  for (size_t row = 0; row < size; ++row)
    for (size_t column = 0; column < size; ++column)
      matrix[column * size + row] = result.transform[row * size + column];
}

#define MAP_OPTION(field, is_whole) \
  { #field, offsetof(slamicp_map_options, field), is_whole }
static const option map_options[] = {MAP_OPTION(neighbours, true), MAP_OPTION(min_neighbours, true),
                                     MAP_OPTION(radius, false),    MAP_OPTION(cell, false),
                                     MAP_OPTION(reach, false),     MAP_OPTION(scatter, false)};

/// handle = map_new(points, 'name', value, ...)
void command_map_new(const mex_call* call) {
  need_inputs(call, 1, 1 + 2 * 6);
  need_outputs(call, 1);
  const cloud points = need_cloud(call->input[0], "points");
  slamicp_map_options options;
  check(slamicp_map_options_init(&options, sizeof options));
  read_options(call, 1, map_options, sizeof map_options / sizeof *map_options, &options);
  slamicp_map* map = NULL;
  check(slamicp_map_create(points.dimension, points.points, points.count, &options, &map));
  call->output[0] = mxCreateDoubleScalar(keep_map(map));
}

/// handle = map_add(handle, points)
void command_map_add(const mex_call* call) {
  need_inputs(call, 2, 2);
  need_outputs(call, 1);
  const slamicp_map* const map = need_map(call->input[0]);
  const cloud points = need_cloud(call->input[1], "points");
  if (points.dimension != slamicp_map_dimension(map))
    refuse("bad_points", "points must be %d x K, as the map's are", slamicp_map_dimension(map));
  slamicp_map* grown = NULL;
  check(slamicp_map_with_added(map, points.points, points.count, &grown));
  call->output[0] = mxCreateDoubleScalar(keep_map(grown));
}

/// points = map_points(handle)
void command_map_points(const mex_call* call) {
  need_inputs(call, 1, 1);
  need_outputs(call, 1);
  const slamicp_map* const map = need_map(call->input[0]);
  call->output[0] = matrix_of(slamicp_map_points(map), (size_t)slamicp_map_dimension(map), slamicp_map_size(map));
}

/// [points, dimension] = map_size(handle)
void command_map_size(const mex_call* call) {
  need_inputs(call, 1, 1);
  need_outputs(call, 2);
  const slamicp_map* const map = need_map(call->input[0]);
  call->output[0] = mxCreateDoubleScalar((double)slamicp_map_size(map));
  if (call->outputs > 1) call->output[1] = mxCreateDoubleScalar(slamicp_map_dimension(map));
}

/// free(handle)
void command_free(const mex_call* call) {
  need_inputs(call, 1, 1);
  need_outputs(call, 0);
  let_go(call->input[0]);
}
