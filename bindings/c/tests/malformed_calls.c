// SPDX-License-Identifier: Apache-2.0
#include "malformed_calls.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <slamicp.h>
#include <stdio.h>
#include <string.h>

static malformed_calls calls;

// Each is to be refused with this status and with words of its own.
static void expect(slamicp_status expected, slamicp_status status, const char* what, int line) {
  ++calls.made;
  const char* words = slamicp_last_error();
  if (status == expected && words[0] != '\0' && strlen(words) < 500) return;
  if (calls.wrong++ == 0)
    snprintf(calls.first_wrong, sizeof calls.first_wrong, "line %d: %.120s: %s, not %s: %.60s", line, what,
             slamicp_status_name(status), slamicp_status_name(expected), words);
}
#define EXPECT(expected, call) expect(expected, call, #call, __LINE__)

enum { points_in_map = 400, beams = 90, lengths = 5 };
static double square[points_in_map][2];
static float ranges[beams];
static const double bad_lengths[lengths] = {NAN, INFINITY, -INFINITY, -1.0, 0.0};
static const int bad_sizes = 4;

static size_t bad_size(int k, size_t good) {
  const size_t sizes[] = {0, 1, good - 1, (size_t)1 << 40};
  return sizes[k];
}

static void make_scene(void) {
  for (int k = 0; k < points_in_map / 4; ++k) {
    const double along = 4.0 * k / (points_in_map / 4) - 2.0;
    const double side[4][2] = {{along, -2.0}, {along, 2.0}, {-2.0, along}, {2.0, along}};
    memcpy(square[4 * k], side, sizeof side);
  }
  for (int k = 0; k < beams; ++k) {
    const double angle = 2.0 * 3.14159265358979 * k / beams;
    ranges[k] = (float)(2.0 / fmax(fabs(cos(angle)), fabs(sin(angle))));
  }
}

static void malformed_structs(void) {
  slamicp_map_options map_options;
  slamicp_icp_options icp_options;
  slamicp_localizer_options localizer_options;
  slamicp_obstacle_options obstacle_options;
  slamicp_scan scan;
  slamicp_fix fix;
  slamicp_result result;
  slamicp_obstacle obstacle;
  EXPECT(SLAMICP_NULL_POINTER, slamicp_map_options_init(NULL, sizeof map_options));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_options_init(NULL, sizeof icp_options));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_options_init(NULL, sizeof localizer_options));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_obstacle_options_init(NULL, sizeof obstacle_options));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_scan_init(NULL, sizeof scan));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_fix_init(NULL, sizeof fix));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_result_init(NULL, sizeof result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_obstacle_init(NULL, sizeof obstacle));
  for (int k = 0; k < bad_sizes; ++k) {
    EXPECT(SLAMICP_BAD_SIZE, slamicp_map_options_init(&map_options, bad_size(k, sizeof map_options)));
    EXPECT(SLAMICP_BAD_SIZE, slamicp_icp_options_init(&icp_options, bad_size(k, sizeof icp_options)));
    EXPECT(SLAMICP_BAD_SIZE, slamicp_localizer_options_init(&localizer_options, bad_size(k, sizeof localizer_options)));
    EXPECT(SLAMICP_BAD_SIZE, slamicp_obstacle_options_init(&obstacle_options, bad_size(k, sizeof obstacle_options)));
    EXPECT(SLAMICP_BAD_SIZE, slamicp_scan_init(&scan, bad_size(k, sizeof scan)));
    EXPECT(SLAMICP_BAD_SIZE, slamicp_fix_init(&fix, bad_size(k, sizeof fix)));
    EXPECT(SLAMICP_BAD_SIZE, slamicp_result_init(&result, bad_size(k, sizeof result)));
    EXPECT(SLAMICP_BAD_SIZE, slamicp_obstacle_init(&obstacle, bad_size(k, sizeof obstacle)));
  }
}

static void malformed_map_options(void) {
  slamicp_map* map = NULL;
  slamicp_map_options good, bad;
  slamicp_map_options_init(&good, sizeof good);
#define BAD_MAP_OPTION(field, value) \
  bad = good, bad.field = value;     \
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_map_create(2, square[0], points_in_map, &bad, &map));
  BAD_MAP_OPTION(neighbours, -1)
  BAD_MAP_OPTION(neighbours, 65)
  BAD_MAP_OPTION(neighbours, INT_MAX)
  BAD_MAP_OPTION(min_neighbours, 2)
  BAD_MAP_OPTION(min_neighbours, 13)
  for (int k = 0; k < lengths; ++k) {
    BAD_MAP_OPTION(radius, bad_lengths[k])
    BAD_MAP_OPTION(cell, bad_lengths[k])
    BAD_MAP_OPTION(reach, bad_lengths[k])
  }
  BAD_MAP_OPTION(scatter, 0.0)
  BAD_MAP_OPTION(scatter, NAN)
  BAD_MAP_OPTION(cell, 1.0)
  BAD_MAP_OPTION(reach, 10.0)
  for (int k = 0; k < bad_sizes; ++k) {
    bad = good, bad.size = bad_size(k, sizeof good);
    EXPECT(SLAMICP_BAD_SIZE, slamicp_map_create(2, square[0], points_in_map, &bad, &map));
  }
  // From a newer header, and asking for something new.
  struct {
    slamicp_map_options known;
    double more;
  } newer = {good, 1.0};
  newer.known.size = sizeof newer;
  EXPECT(SLAMICP_BAD_SIZE, slamicp_map_create(2, square[0], points_in_map, &newer.known, &map));
  if (map != NULL) ++calls.wrong;
}

static void malformed_maps(const slamicp_map* good) {
  slamicp_map* map = NULL;
  const int dimensions[] = {0, 1, 4, -2, INT_MAX};
  for (int k = 0; k < 5; ++k)
    EXPECT(SLAMICP_BAD_POINTS, slamicp_map_create(dimensions[k], square[0], points_in_map, NULL, &map));
  for (int dimension = 2; dimension <= 3; ++dimension) {
    double numbers[6] = {NAN, NAN, INFINITY, NAN, -INFINITY, NAN};
    EXPECT(SLAMICP_NULL_POINTER, slamicp_map_create(dimension, NULL, points_in_map, NULL, &map));
    EXPECT(SLAMICP_NULL_POINTER, slamicp_map_create(dimension, square[0], points_in_map, NULL, NULL));
    EXPECT(SLAMICP_BAD_POINTS, slamicp_map_create(dimension, NULL, 0, NULL, &map));
    EXPECT(SLAMICP_BAD_POINTS, slamicp_map_create(dimension, square[0], 0, NULL, &map));
    EXPECT(SLAMICP_BAD_POINTS, slamicp_map_create(dimension, square[0], SIZE_MAX, NULL, &map));
    EXPECT(SLAMICP_BAD_POINTS, slamicp_map_create(dimension, square[0], (size_t)1 << 40, NULL, &map));
    EXPECT(SLAMICP_BAD_POINTS, slamicp_map_create(dimension, numbers, 2, NULL, &map));
    for (int k = 0; k < 6; ++k) numbers[k] = k == 3 ? DBL_MAX : 0.0;
    EXPECT(SLAMICP_BAD_POINTS, slamicp_map_create(dimension, numbers, 2, NULL, &map));
    numbers[3] = -1e7;
    EXPECT(SLAMICP_BAD_POINTS, slamicp_map_create(dimension, numbers, 2, NULL, &map));
  }
  const double far_away[2] = {0.0, 1e300};
  EXPECT(SLAMICP_NULL_POINTER, slamicp_map_with_added(NULL, square[0], 1, &map));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_map_with_added(good, NULL, 1, &map));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_map_with_added(good, square[0], 1, NULL));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_map_with_added(good, square[0], SIZE_MAX, &map));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_map_with_added(good, far_away, 1, &map));
  int32_t index = 17;
  double distance = 17.0;
  EXPECT(SLAMICP_NULL_POINTER, slamicp_map_nearest(NULL, square[0], 1.0, &index, &distance));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_map_nearest(good, NULL, 1.0, &index, &distance));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_map_nearest(good, square[0], 1.0, NULL, &distance));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_map_nearest(good, square[0], 1.0, &index, NULL));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_map_nearest(good, far_away, 1.0, &index, &distance));
  for (int k = 0; k < lengths; ++k)
    EXPECT(SLAMICP_BAD_OPTIONS, slamicp_map_nearest(good, square[0], bad_lengths[k], &index, &distance));
  if (map != NULL || index != 17 || distance != 17.0) ++calls.wrong;
}

static void malformed_icp_options(void) {
  slamicp_icp* icp = NULL;
  slamicp_icp_options good, bad;
  slamicp_icp_options_init(&good, sizeof good);
#define BAD_ICP_OPTION(field, value) \
  bad = good, bad.field = value;     \
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_icp_create(&bad, &icp));
  BAD_ICP_OPTION(method, -1)
  BAD_ICP_OPTION(method, 2)
  BAD_ICP_OPTION(method, INT_MAX)
  BAD_ICP_OPTION(max_iterations, 0)
  BAD_ICP_OPTION(max_iterations, INT_MIN)
  BAD_ICP_OPTION(kernel, -1)
  BAD_ICP_OPTION(kernel, 5)
  BAD_ICP_OPTION(guess_share, NAN)
  BAD_ICP_OPTION(guess_share, -0.1)
  BAD_ICP_OPTION(guess_share, 1.1)
  BAD_ICP_OPTION(final_gate, NAN)
  BAD_ICP_OPTION(final_gate, -1.0)
  BAD_ICP_OPTION(final_gate, 1.0)
  for (int k = 0; k < lengths; ++k) {
    BAD_ICP_OPTION(max_correspondence_distance, bad_lengths[k])
    BAD_ICP_OPTION(kernel_scale, bad_lengths[k])
    BAD_ICP_OPTION(translation_tolerance, bad_lengths[k])
    BAD_ICP_OPTION(rotation_tolerance, bad_lengths[k])
    if (bad_lengths[k] == 0.0) continue;  // which stands for the default
    BAD_ICP_OPTION(outlier_distance, bad_lengths[k])
  }
  for (int k = 0; k < bad_sizes; ++k) {
    bad = good, bad.size = bad_size(k, sizeof good);
    EXPECT(SLAMICP_BAD_SIZE, slamicp_icp_create(&bad, &icp));
  }
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_create(&good, NULL));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_create(NULL, NULL));
  if (icp != NULL) ++calls.wrong;
}

static void malformed_matches(slamicp_icp* icp, const slamicp_map* map, const slamicp_map* without_lines) {
  slamicp_result result, untouched;
  slamicp_result_init(&result, sizeof result);
  result.iterations = 17;
  untouched = result;
  const double guess[3] = {0.0, 0.0, 0.0};
  const double* scan = square[0];
  const double far_away[2] = {-1e300, 0.0};
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align(NULL, map, scan, 9, guess, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align(icp, NULL, scan, 9, guess, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align(icp, map, NULL, 9, guess, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align(icp, map, scan, 9, NULL, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align(icp, map, scan, 9, guess, 0, NULL));
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_icp_align(icp, map, scan, 9, guess, 256, &result));
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_icp_align(icp, map, scan, 9, guess, UINT32_MAX, &result));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_icp_align(icp, map, scan, SIZE_MAX, guess, 0, &result));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_icp_align(icp, map, far_away, 1, guess, 0, &result));
  EXPECT(SLAMICP_BAD_STATE, slamicp_icp_align(icp, without_lines, scan, 9, guess, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align_points(NULL, 2, scan, 99, scan, 9, guess, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align_points(icp, 2, NULL, 99, scan, 9, guess, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align_points(icp, 2, scan, 99, NULL, 9, guess, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align_points(icp, 2, scan, 99, scan, 9, NULL, 0, &result));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_icp_align_points(icp, 2, scan, 99, scan, 9, guess, 0, NULL));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_icp_align_points(icp, 2, scan, 0, scan, 9, guess, 0, &result));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_icp_align_points(icp, 2, scan, SIZE_MAX, scan, 9, guess, 0, &result));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_icp_align_points(icp, 2, scan, 99, scan, SIZE_MAX, guess, 0, &result));
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_icp_align_points(icp, 2, scan, 99, scan, 9, guess, 1 << 30, &result));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_icp_align_points(icp, 1, scan, 99, scan, 9, guess, 0, &result));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_icp_align_points(icp, -3, scan, 99, scan, 9, guess, 0, &result));
  for (int k = 0; k < 6; ++k) {
    double bad[6] = {0.0};
    bad[k] = k % 2 == 0 ? NAN : INFINITY;
    EXPECT(SLAMICP_BAD_POSE, slamicp_icp_align_points(icp, 3, scan, 99, scan, 9, bad, 0, &result));
    if (k < 3) EXPECT(SLAMICP_BAD_POSE, slamicp_icp_align(icp, map, scan, 9, bad, 0, &result));
    bad[k] = 1e300;
    EXPECT(SLAMICP_BAD_POSE, slamicp_icp_align_points(icp, 3, scan, 99, scan, 9, bad, 0, &result));
    if (k < 3) EXPECT(SLAMICP_BAD_POSE, slamicp_icp_align(icp, map, scan, 9, bad, 0, &result));
  }
  if (memcmp(&result, &untouched, sizeof result) != 0) ++calls.wrong;
  for (int k = 0; k < bad_sizes; ++k) {
    result.size = bad_size(k, sizeof result);
    EXPECT(SLAMICP_BAD_SIZE, slamicp_icp_align(icp, map, scan, 9, guess, 0, &result));
  }
}

static void malformed_localizer_options(const slamicp_map* map, const slamicp_map* in_space) {
  slamicp_localizer* localizer = NULL;
  slamicp_localizer_options good, bad;
  slamicp_localizer_options_init(&good, sizeof good);
#define BAD_LOCALIZER_OPTION(field, value) \
  bad = good, bad.field = value;           \
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_localizer_create(map, &bad, &localizer));
  BAD_LOCALIZER_OPTION(method, 3)
  BAD_LOCALIZER_OPTION(max_iterations, -5)
  BAD_LOCALIZER_OPTION(kernel, 77)
  BAD_LOCALIZER_OPTION(outputs, 1U << 20)
  BAD_LOCALIZER_OPTION(guess_share, 2.0)
  BAD_LOCALIZER_OPTION(final_gate, INFINITY)
  BAD_LOCALIZER_OPTION(min_range, -1.0)
  BAD_LOCALIZER_OPTION(min_range, NAN)
  BAD_LOCALIZER_OPTION(max_range, 0.0)
  BAD_LOCALIZER_OPTION(max_range, NAN)
  BAD_LOCALIZER_OPTION(obstacle_distance, -0.1)
  BAD_LOCALIZER_OPTION(obstacle_distance, NAN)
  for (int k = 0; k < lengths; ++k) {
    BAD_LOCALIZER_OPTION(max_correspondence_distance, bad_lengths[k])
    BAD_LOCALIZER_OPTION(kernel_scale, bad_lengths[k])
  }
  for (int k = 0; k < bad_sizes; ++k) {
    bad = good, bad.size = bad_size(k, sizeof good);
    EXPECT(SLAMICP_BAD_SIZE, slamicp_localizer_create(map, &bad, &localizer));
  }
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_create(map, NULL, NULL));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_localizer_create(in_space, NULL, &localizer));
  if (localizer != NULL) ++calls.wrong;
}

static void malformed_scans(slamicp_localizer* localizer) {
  slamicp_scan good, bad;
  slamicp_fix fix;
  slamicp_scan_init(&good, sizeof good);
  slamicp_fix_init(&fix, sizeof fix);
  good.ranges = ranges;
  good.count = beams;
  good.angle_increment = 2.0 * 3.14159265358979 / beams;
#define BAD_SCAN(status, field, value) \
  bad = good, bad.field = value;       \
  EXPECT(status, slamicp_localizer_update(localizer, &bad, &fix));
  const double not_finite[] = {NAN, INFINITY, -INFINITY};
  for (int k = 0; k < 3; ++k) {
    BAD_SCAN(SLAMICP_BAD_SCAN, stamp, not_finite[k])
    BAD_SCAN(SLAMICP_BAD_SCAN, time_increment, not_finite[k])
    BAD_SCAN(SLAMICP_BAD_SCAN, angle_min, not_finite[k])
    BAD_SCAN(SLAMICP_BAD_SCAN, angle_increment, not_finite[k])
    BAD_SCAN(SLAMICP_BAD_POSE, T_robot_laser[k], not_finite[k])
    bad = good, bad.has_odometry = 1, bad.T_odom_robot[k] = not_finite[k];
    EXPECT(SLAMICP_BAD_POSE, slamicp_localizer_update(localizer, &bad, &fix));
    bad = good, bad.has_sweep_motion = 1, bad.T_first_last[k] = 1e300;
    EXPECT(SLAMICP_BAD_POSE, slamicp_localizer_update(localizer, &bad, &fix));
  }
  BAD_SCAN(SLAMICP_BAD_SCAN, range_min, NAN)
  BAD_SCAN(SLAMICP_BAD_SCAN, range_max, NAN)
  BAD_SCAN(SLAMICP_BAD_SCAN, count, SIZE_MAX)
  BAD_SCAN(SLAMICP_BAD_SCAN, count, 10000001)
  BAD_SCAN(SLAMICP_NULL_POINTER, ranges, NULL)
  for (int k = 0; k < bad_sizes; ++k) {
    BAD_SCAN(SLAMICP_BAD_SIZE, size, bad_size(k, sizeof good))
    slamicp_fix bad_fix = fix;
    bad_fix.size = bad_size(k, sizeof fix);
    EXPECT(SLAMICP_BAD_SIZE, slamicp_localizer_update(localizer, &good, &bad_fix));
    EXPECT(SLAMICP_BAD_SIZE, slamicp_localizer_fix(localizer, &bad_fix));
  }
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_update(NULL, &good, &fix));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_update(localizer, NULL, &fix));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_fix(NULL, &fix));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_fix(localizer, NULL));
}

static void malformed_questions(slamicp_localizer* localizer, const slamicp_map* map, const slamicp_map* in_space,
                                const slamicp_map* without_lines) {
  size_t count = 17;
  int32_t found = 17;
  slamicp_obstacle obstacle;
  slamicp_obstacle_options good, bad;
  slamicp_obstacle_init(&obstacle, sizeof obstacle);
  slamicp_obstacle_options_init(&good, sizeof good);
  EXPECT(SLAMICP_BAD_STATE, slamicp_localizer_find_obstacles(localizer, NULL, &count));  // no scan was good yet
  EXPECT(SLAMICP_BAD_STATE, slamicp_localizer_obstacle(localizer, 0, &obstacle));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_find_obstacles(NULL, NULL, &count));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_find_obstacles(localizer, NULL, NULL));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_obstacle(NULL, 0, &obstacle));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_obstacle(localizer, 0, NULL));
#define BAD_OBSTACLE_OPTION(field, value) \
  bad = good, bad.field = value;          \
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_localizer_find_obstacles(localizer, &bad, &count));
  BAD_OBSTACLE_OPTION(min_points, 0)
  BAD_OBSTACLE_OPTION(min_points, INT_MIN)
  BAD_OBSTACLE_OPTION(min_far_points, 0)
  BAD_OBSTACLE_OPTION(range_noise, -1.0)
  BAD_OBSTACLE_OPTION(range_noise, NAN)
  BAD_OBSTACLE_OPTION(min_incidence_deg, 0.0)
  BAD_OBSTACLE_OPTION(min_incidence_deg, 90.0)
  BAD_OBSTACLE_OPTION(min_incidence_deg, NAN)
  for (int k = 0; k < bad_sizes; ++k) {
    bad = good, bad.size = bad_size(k, sizeof good);
    EXPECT(SLAMICP_BAD_SIZE, slamicp_localizer_find_obstacles(localizer, &bad, &count));
  }
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_recover(NULL, 10, &found));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_recover(localizer, 10, NULL));
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_localizer_recover(localizer, 0, &found));
  EXPECT(SLAMICP_BAD_OPTIONS, slamicp_localizer_recover(localizer, INT_MIN, &found));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_set_map(NULL, map));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_set_map(localizer, NULL));
  EXPECT(SLAMICP_BAD_POINTS, slamicp_localizer_set_map(localizer, in_space));
  EXPECT(SLAMICP_BAD_STATE, slamicp_localizer_set_map(localizer, without_lines));
  const double good_pose[3] = {0.0, 0.0, 0.0};
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_set_pose(NULL, good_pose));
  EXPECT(SLAMICP_NULL_POINTER, slamicp_localizer_set_pose(localizer, NULL));
  for (int k = 0; k < 3; ++k) {
    const double values[] = {NAN, INFINITY, -1e300};
    for (int v = 0; v < 3; ++v) {
      double pose[3] = {0.0};
      pose[k] = values[v];
      EXPECT(SLAMICP_BAD_POSE, slamicp_localizer_set_pose(localizer, pose));
    }
  }
  if (count != 17 || found != 17) ++calls.wrong;
}

malformed_calls make_malformed_calls(void) {
  memset(&calls, 0, sizeof calls);
  make_scene();
  slamicp_map *map = NULL, *in_space = NULL, *without_lines = NULL;
  slamicp_map_options no_lines;
  slamicp_map_options_init(&no_lines, sizeof no_lines);
  no_lines.neighbours = 0;
  slamicp_icp* icp = NULL;
  slamicp_localizer* localizer = NULL;
  if (slamicp_map_create(2, square[0], points_in_map, NULL, &map) ||
      slamicp_map_create(3, square[0], points_in_map / 2, NULL, &in_space) ||
      slamicp_map_create(2, square[0], points_in_map, &no_lines, &without_lines) || slamicp_icp_create(NULL, &icp) ||
      slamicp_localizer_create(map, NULL, &localizer)) {
    calls.wrong = 1;
    snprintf(calls.first_wrong, sizeof calls.first_wrong, "%.200s", slamicp_last_error());
    return calls;
  }
  malformed_structs();
  malformed_map_options();
  malformed_maps(map);
  malformed_icp_options();
  malformed_matches(icp, map, without_lines);
  malformed_localizer_options(map, in_space);
  malformed_scans(localizer);
  malformed_questions(localizer, map, in_space, without_lines);
  slamicp_localizer_free(localizer);
  slamicp_icp_free(icp);
  slamicp_map_free(without_lines);
  slamicp_map_free(in_space);
  slamicp_map_free(map);
  return calls;
}
