// SPDX-License-Identifier: Apache-2.0
// The passes for machines with NEON.
#include "registration/pass/passes-inl.hpp"

namespace slamicp::pass {
const Passes* neon_passes() noexcept { return &HWY_NAMESPACE::all_passes; }
}  // namespace slamicp::pass
