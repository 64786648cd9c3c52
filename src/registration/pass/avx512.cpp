// SPDX-License-Identifier: Apache-2.0
// The passes for machines with AVX512.
#include "registration/pass/passes-inl.hpp"

namespace slamicp::pass {
const Passes* avx512_passes() noexcept { return &HWY_NAMESPACE::all_passes; }
}  // namespace slamicp::pass
