// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace slamicp::bench {

/// The program's own options, and the callback that runs when no verb is given.
void add_localization(CLI::App& program);
/// `slamicp-bench sweep NAME`.
void add_sweep(CLI::App& program);

}  // namespace slamicp::bench
