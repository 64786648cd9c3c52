// SPDX-License-Identifier: Apache-2.0
// slamicp_mex(COMMAND, ...): what SLAMICP, icpMex, slamicp.Map and slamicp.Localizer stand on. Not to be called by
// hand.
#include <string.h>

#include "mex_support.h"

typedef struct command {
  const char* name;
  void (*run)(const mex_call* call);
} command;

static const command commands[] = {
    {"align", command_align},
    {"transform", command_transform},
    {"map_new", command_map_new},
    {"map_add", command_map_add},
    {"map_points", command_map_points},
    {"map_size", command_map_size},
    {"free", command_free},
    {"localizer_new", command_localizer_new},
    {"localizer_pose", command_localizer_pose},
    {"localizer_map", command_localizer_map},
    {"localizer_update", command_localizer_update},
    {"localizer_recover", command_localizer_recover},
    {"localizer_obstacles", command_localizer_obstacles},
};

void mexFunction(int outputs, mxArray* output[], int inputs, const mxArray* input[]) {
  // `clear mex` would take maps away that objects still hold.
  if (!mexIsLocked()) {
    mexLock();
    mexAtExit(let_go_of_all);
  }
  char name[32];
  if (inputs < 1) refuse("bad_call", "slamicp_mex needs the name of a command; call SLAMICP instead");
  need_text(input[0], "the command", name, sizeof name);
  for (size_t k = 0; k < sizeof commands / sizeof *commands; ++k) {
    if (strcmp(name, commands[k].name) != 0) continue;
    const mex_call made = {commands[k].name, outputs, output, inputs - 1, input + 1};
    commands[k].run(&made);
    return;
  }
  refuse("bad_call", "slamicp_mex has no command '%s'; call SLAMICP instead", name);
}
