// SPDX-License-Identifier: Apache-2.0
#include <slamicp.h>
#include <stdio.h>

int main(void) {
  const double points[8] = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0};
  slamicp_map* map = NULL;
  if (slamicp_map_create(2, points, 4, NULL, &map) != SLAMICP_OK) {
    fprintf(stderr, "%s\n", slamicp_last_error());
    return 1;
  }
  printf("slamicp %s, a map of %zu points\n", slamicp_version(), slamicp_map_size(map));
  slamicp_map_free(map);
  return 0;
}
