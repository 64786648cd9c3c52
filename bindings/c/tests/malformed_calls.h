// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/// How many malformed calls were made, and how many of them were not refused as they should be.
typedef struct malformed_calls {
  int made;
  int wrong;
  char first_wrong[256];  ///< which call, and what came of it
} malformed_calls;

/// Makes every one, from C.
malformed_calls make_malformed_calls(void);

#ifdef __cplusplus
}
#endif
