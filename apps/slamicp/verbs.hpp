// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace slamicp::command {

// One file a verb. Each adds its options to the program and runs as the callback of its subcommand.
void add_demo(CLI::App& program);
void add_info(CLI::App& program);
void add_convert(CLI::App& program);
void add_simulate(CLI::App& program);
void add_map(CLI::App& program);
void add_localize(CLI::App& program);
void add_align(CLI::App& program);
void add_odometry(CLI::App& program);
void add_evaluate(CLI::App& program);
void add_experiment(CLI::App& program);

}  // namespace slamicp::command
