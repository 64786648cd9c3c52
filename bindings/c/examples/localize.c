// SPDX-License-Identifier: Apache-2.0
// A robot stands in a room of 6 m x 4 m that its map knows, beside a box that it does not know.
#include <math.h>
#include <slamicp.h>
#include <stdio.h>

enum { per_wall = 200, beams = 720 };
static const double pi = 3.14159265358979323846;

// How far it is from (x, y) to what a ray in this direction meets first: a wall, or the box at x = 4 m.
static double range_of(double x, double y, double direction) {
  const double dx = cos(direction), dy = sin(direction);
  double range = fmin((dx > 0.0 ? 6.0 - x : -x) / dx, (dy > 0.0 ? 4.0 - y : -y) / dy);
  const double to_box = (4.0 - x) / dx;
  if (dx > 0.0 && fabs(y + to_box * dy - 1.2) < 0.25) range = fmin(range, to_box);
  return range;
}

int main(void) {
  double walls[4 * per_wall][2];
  for (int k = 0; k < per_wall; ++k) {
    const double x = 6.0 * k / per_wall, y = 4.0 * k / per_wall;
    const double points[4][2] = {{x, 0.0}, {6.0, y}, {x, 4.0}, {0.0, y}};
    for (int wall = 0; wall < 4; ++wall)
      for (int axis = 0; axis < 2; ++axis) walls[4 * k + wall][axis] = points[wall][axis];
  }
  float ranges[beams];
  for (int beam = 0; beam < beams; ++beam) ranges[beam] = (float)range_of(2.0, 1.5, 0.3 + 2.0 * pi * beam / beams);

  slamicp_map* map = NULL;
  slamicp_localizer* localizer = NULL;
  slamicp_scan scan;
  slamicp_fix fix;
  slamicp_obstacle obstacle;
  size_t obstacles = 0;
  slamicp_scan_init(&scan, sizeof scan);
  slamicp_fix_init(&fix, sizeof fix);
  slamicp_obstacle_init(&obstacle, sizeof obstacle);
  scan.ranges = ranges;
  scan.count = beams;
  scan.angle_increment = 2.0 * pi / beams;

  const double start[3] = {2.05, 1.45, 0.25};
  int failed = slamicp_map_create(2, &walls[0][0], 4 * per_wall, NULL, &map) ||
               slamicp_localizer_create(map, NULL, &localizer) || slamicp_localizer_set_pose(localizer, start) ||
               slamicp_localizer_update(localizer, &scan, &fix) ||
               slamicp_localizer_find_obstacles(localizer, NULL, &obstacles);
  if (failed) fprintf(stderr, "%s\n", slamicp_last_error());
  if (!failed)
    printf("%s: x %.3f m, y %.3f m, heading %.4f rad, %zu outliers\n", slamicp_stop_name(fix.stop), fix.pose[0],
           fix.pose[1], fix.pose[2], fix.outliers);
  for (size_t k = 0; k < obstacles && slamicp_localizer_obstacle(localizer, k, &obstacle) == SLAMICP_OK; ++k)
    printf("obstacle: %.2f m wide at %.2f m, %.2f m\n", obstacle.width, obstacle.centre[0], obstacle.centre[1]);
  slamicp_localizer_free(localizer);
  slamicp_map_free(map);
  return failed;
}
