// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/registration/instruction_set.hpp>

#include "registration/pass/pass.hpp"

namespace slamicp {

/// The passes for an instruction set; null for `scalar`, and where the machine or the build has none.
const pass::Passes* passes_of(InstructionSet set) noexcept;

}  // namespace slamicp
