// SPDX-License-Identifier: Apache-2.0
#include <slamicp.h>

const char* slamicp_status_name(slamicp_status status) {
  switch (status) {
    case SLAMICP_OK:
      return "ok";
    case SLAMICP_NULL_POINTER:
      return "null_pointer";
    case SLAMICP_BAD_SIZE:
      return "bad_size";
    case SLAMICP_BAD_OPTIONS:
      return "bad_options";
    case SLAMICP_BAD_POINTS:
      return "bad_points";
    case SLAMICP_BAD_POSE:
      return "bad_pose";
    case SLAMICP_BAD_SCAN:
      return "bad_scan";
    case SLAMICP_BAD_STATE:
      return "bad_state";
    case SLAMICP_OUT_OF_MEMORY:
      return "out_of_memory";
    case SLAMICP_INTERNAL:
      return "internal";
  }
  return "unknown";
}
