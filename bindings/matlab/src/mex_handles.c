// SPDX-License-Identifier: Apache-2.0
#include <stdlib.h>
#include <string.h>

#include "mex_support.h"

// Numbers are given once: a handle that is gone is never mistaken for a later one.
typedef struct entry {
  double number;
  handle_kind kind;
  void* object;
} entry;

static entry* entries = NULL;
static size_t used = 0, reserved = 0;
static double last_number = 0.0;

static slamicp_icp* matcher = NULL;
static slamicp_icp_options matcher_options;

static double keep(handle_kind kind, void* object) {
  if (used == reserved) {
    const size_t more = reserved == 0 ? 16 : 2 * reserved;
    entry* const grown = realloc(entries, more * sizeof *entries);
    if (grown == NULL) return 0.0;
    entries = grown;
    reserved = more;
  }
  last_number += 1.0;
  entries[used++] = (entry){last_number, kind, object};
  return last_number;
}

double keep_map(slamicp_map* map) {
  const double number = keep(handle_map, map);
  if (number > 0.0) return number;
  slamicp_map_free(map);
  refuse("out_of_memory", "there is not enough memory");
}

double keep_localizer(slamicp_localizer* localizer) {
  const double number = keep(handle_localizer, localizer);
  if (number > 0.0) return number;
  slamicp_localizer_free(localizer);
  refuse("out_of_memory", "there is not enough memory");
}

static entry* find(double number) {
  for (size_t k = 0; k < used; ++k)
    if (entries[k].number == number) return &entries[k];
  return NULL;
}

static void* need_object(const mxArray* handle, handle_kind kind, const char* name) {
  const entry* const found = find(need_number(handle, "the handle"));
  if (found == NULL || found->kind != kind) refuse("bad_handle", "this is no %s, or it has been deleted", name);
  return found->object;
}

slamicp_map* need_map(const mxArray* handle) { return need_object(handle, handle_map, "slamicp.Map"); }

slamicp_localizer* need_localizer(const mxArray* handle) {
  return need_object(handle, handle_localizer, "slamicp.Localizer");
}

static void free_object(const entry* one) {
  if (one->kind == handle_map)
    slamicp_map_free(one->object);
  else
    slamicp_localizer_free(one->object);
}

void let_go(const mxArray* handle) {
  entry* const found = find(need_number(handle, "the handle"));
  if (found == NULL) return;
  free_object(found);
  *found = entries[--used];
}

slamicp_icp* matcher_with(const slamicp_icp_options* options) {
  if (matcher != NULL && memcmp(options, &matcher_options, sizeof *options) == 0) return matcher;
  slamicp_icp* made = NULL;
  check(slamicp_icp_create(options, &made));
  slamicp_icp_free(matcher);
  matcher = made;
  matcher_options = *options;
  return matcher;
}

void let_go_of_all(void) {
  while (used > 0) free_object(&entries[--used]);
  free(entries);
  entries = NULL;
  reserved = 0;
  slamicp_icp_free(matcher);
  matcher = NULL;
}
