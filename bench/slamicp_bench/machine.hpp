// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "measure/support.hpp"

namespace slamicp::bench {

/// What the times hang on.
struct Machine {
  std::string cpu;
  std::string vectors;  ///< the widest instructions that it has
  unsigned cores = 0;
  std::string compiler;
  std::string flags;  ///< of the library and of this program
  std::string date;   ///< UTC
};
Machine this_machine();

measure::Json to_json(const Machine& machine);
/// One line.
std::string brief(const Machine& machine);

}  // namespace slamicp::bench
