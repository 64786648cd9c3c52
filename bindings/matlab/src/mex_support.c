// SPDX-License-Identifier: Apache-2.0
#include "mex_support.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

DOES_NOT_RETURN void refuse(const char* kind, const char* words, ...) {
  char identifier[64], text[600];
  va_list rest;
  snprintf(identifier, sizeof identifier, "slamicp:%s", kind);
  va_start(rest, words);
  vsnprintf(text, sizeof text, words, rest);
  va_end(rest);
  mexErrMsgIdAndTxt(identifier, "%s", text);
  for (;;) {  // it does not come back, which the compiler cannot know
  }
}

void check(slamicp_status status) {
  if (status != SLAMICP_OK) refuse(slamicp_status_name(status), "%s", slamicp_last_error());
}

void need_inputs(const mex_call* call, int least, int most) {
  if (call->inputs < least || call->inputs > most)
    refuse("bad_call", "%s takes %d to %d inputs, not %d", call->command, least, most, call->inputs);
}

void need_outputs(const mex_call* call, int most) {
  if (call->outputs > most) refuse("bad_call", "%s has %d outputs, not %d", call->command, most, call->outputs);
}

static void need_real_full_double(const mxArray* given, const char* name) {
  if (!mxIsDouble(given)) refuse("bad_type", "%s must be of class double, not %s", name, mxGetClassName(given));
  if (mxIsComplex(given)) refuse("bad_type", "%s must be real, not complex", name);
  if (mxIsSparse(given)) refuse("bad_type", "%s must be full, not sparse: full(%s)", name, name);
}

cloud need_cloud(const mxArray* given, const char* name) {
  need_real_full_double(given, name);
  const size_t rows = (size_t)mxGetM(given), columns = (size_t)mxGetN(given);
  if (mxGetNumberOfDimensions(given) != 2 || (rows != 2 && rows != 3))
    refuse("bad_points", "%s must be 2 x K or 3 x K, a point a column", name);
  if (columns == 0) refuse("bad_points", "%s has no points", name);
  const cloud made = {mxGetPr(given), columns, (int)rows};
  for (size_t k = 0; k < columns; ++k) {
    bool finite = true;
    for (size_t axis = 0; axis < rows; ++axis) finite = finite && isfinite(made.points[k * rows + axis]);
    if (finite) return made;
  }
  refuse("bad_points", "%s has no point with finite coordinates", name);
}

double need_number(const mxArray* given, const char* name) { return need_numbers(given, name, 1)[0]; }

int need_whole_number(const mxArray* given, const char* name, int least) {
  const double number = need_number(given, name);
  if (!(number >= least && number <= 1e9) || number != floor(number))
    refuse("bad_options", "%s must be a whole number from %d to 10^9", name, least);
  return (int)number;
}

const double* need_numbers(const mxArray* given, const char* name, size_t count) {
  need_real_full_double(given, name);
  if ((size_t)mxGetNumberOfElements(given) != count)
    refuse("bad_size", "%s must be %s%zu number%s", name, count == 1 ? "" : "a vector of ", count,
           count == 1 ? "" : "s");
  return mxGetPr(given);
}

void need_text(const mxArray* given, const char* name, char* text, size_t room) {
  if (!mxIsChar(given) || mxGetNumberOfDimensions(given) != 2 || mxGetM(given) != 1)
    refuse("bad_type", "%s must be text, a row of characters", name);
  if ((size_t)mxGetN(given) >= room || mxGetString(given, text, (mwSize)room) != 0)
    refuse("bad_options", "%s is not one that is known: it is too long", name);
}

int need_method(const mxArray* given) {
  char method[32];
  need_text(given, "method", method, sizeof method);
  if (strcmp(method, "point_to_point") == 0) return SLAMICP_POINT_TO_POINT;
  if (strcmp(method, "point_to_plane") == 0 || strcmp(method, "point_to_line") == 0) return SLAMICP_POINT_TO_PLANE;
  refuse("bad_options", "there is no method '%s'; give 'point_to_point' or 'point_to_plane'", method);
}

void read_options(const mex_call* call, int first, const option* options, size_t count, void* into) {
  for (int k = first; k < call->inputs; k += 2) {
    char name[40];
    need_text(call->input[k], "the name of an option", name, sizeof name);
    if (k + 1 == call->inputs) refuse("bad_call", "there is no value behind the option '%s'", name);
    const mxArray* const value = call->input[k + 1];
    size_t which = 0;
    while (which < count && strcmp(options[which].name, name) != 0) ++which;
    if (which == count) refuse("bad_options", "there is no option '%s'", name);
    char* const place = (char*)into + options[which].offset;
    if (strcmp(name, "method") == 0) {
      const int32_t method = need_method(value);
      memcpy(place, &method, sizeof method);
    } else if (options[which].is_whole) {
      const int32_t number = need_whole_number(value, name, 0);
      memcpy(place, &number, sizeof number);
    } else {
      const double number = need_number(value, name);
      memcpy(place, &number, sizeof number);
    }
  }
}

mxArray* matrix_of(const double* numbers, size_t rows, size_t columns) {
  mxArray* const made = mxCreateDoubleMatrix((mwSize)rows, (mwSize)columns, mxREAL);
  if (rows * columns > 0 && numbers != NULL) memcpy(mxGetPr(made), numbers, rows * columns * sizeof *numbers);
  return made;
}

mxArray* indices_of(const int32_t* indices, size_t count) {
  mxArray* const made = mxCreateDoubleMatrix(1, (mwSize)count, mxREAL);
  double* const numbers = mxGetPr(made);
  for (size_t k = 0; k < count; ++k) numbers[k] = indices[k] + 1.0;
  return made;
}
