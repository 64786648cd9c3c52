// SPDX-License-Identifier: Apache-2.0
// What the commands of slamicp_mex share: the classic C MEX interface, which MATLAB and Octave have in common, on
// slamicp.h.
#pragma once

#include <mex.h>
#include <slamicp.h>
#include <stdbool.h>
#include <stddef.h>

/// The arguments of a command, its name left out.
typedef struct mex_call {
  const char* command;
  int outputs;  ///< asked for; a function may always hand out one
  mxArray** output;
  int inputs;
  const mxArray** input;
} mex_call;

#ifdef _MSC_VER
#define DOES_NOT_RETURN __declspec(noreturn)
#else
#define DOES_NOT_RETURN _Noreturn
#endif

/// Ends the MEX call with an error "slamicp:KIND". Nothing that must be freed may be held.
DOES_NOT_RETURN void refuse(const char* kind, const char* words, ...);
/// The same where a call of slamicp.h went wrong, with its words.
void check(slamicp_status status);

void need_inputs(const mex_call* call, int least, int most);
void need_outputs(const mex_call* call, int most);

/// A cloud as the paper has it, eq. (4), (5): 2 x K or 3 x K, a point a column; real, full, double.
typedef struct cloud {
  const double* points;
  size_t count;
  int dimension;
} cloud;
cloud need_cloud(const mxArray* given, const char* name);

double need_number(const mxArray* given, const char* name);
int need_whole_number(const mxArray* given, const char* name, int least);
/// Real, full, double, so many numbers.
const double* need_numbers(const mxArray* given, const char* name, size_t count);
void need_text(const mxArray* given, const char* name, char* text, size_t room);
int need_method(const mxArray* given);

/// Options as pairs 'name', value behind the other inputs: doubles and 32-bit integers inside a struct.
typedef struct option {
  const char* name;
  size_t offset;
  bool is_whole;
} option;
void read_options(const mex_call* call, int first, const option* options, size_t count, void* into);

/// rows x columns of doubles.
mxArray* matrix_of(const double* numbers, size_t rows, size_t columns);
/// 1 x count, counted from 1.
mxArray* indices_of(const int32_t* indices, size_t count);

/// Handles that M-files hold as numbers.
typedef enum handle_kind { handle_map, handle_localizer } handle_kind;
double keep_map(slamicp_map* map);
double keep_localizer(slamicp_localizer* localizer);
slamicp_map* need_map(const mxArray* handle);
slamicp_localizer* need_localizer(const mxArray* handle);
/// Of either kind; one that is gone already is no error, as an object may be deleted twice.
void let_go(const mxArray* handle);

/// The matcher for these options; it keeps its memory from call to call.
slamicp_icp* matcher_with(const slamicp_icp_options* options);
void let_go_of_all(void);

void command_align(const mex_call* call);
void command_transform(const mex_call* call);
void command_map_new(const mex_call* call);
void command_map_add(const mex_call* call);
void command_map_points(const mex_call* call);
void command_map_size(const mex_call* call);
void command_free(const mex_call* call);
void command_localizer_new(const mex_call* call);
void command_localizer_pose(const mex_call* call);
void command_localizer_map(const mex_call* call);
void command_localizer_update(const mex_call* call);
void command_localizer_recover(const mex_call* call);
void command_localizer_obstacles(const mex_call* call);
