// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slamicp {

/// What a match in the plane is computed with. All judge every point's distance exactly, at the pose they find. From
/// point to line, where the view holds the pose, all but `scalar` find the same one to within about 1e-5 m and 1e-5
/// rad, and `scalar` mostly does: to within 2e-4, as it tells apart neighbours that are as near as 0.05 mm. From point
/// to point a match stops where its neighbours no longer change, which may be a place next to the other's.
enum class InstructionSet {
  best,      ///< the fastest that this machine and this build have
  scalar,    ///< one point at a time, in double: the reference
  portable,  ///< what every machine of the kind has
  sse4,      ///< x86 since 2008
  avx2,      ///< x86 since 2013, with FMA
  avx512,    ///< x86 with AVX-512 F, BW, CD, DQ and VL
  neon,      ///< 64-bit ARM
};

/// "avx512", ...
const char* to_string(InstructionSet set) noexcept;

/// True if this machine and this build have it.
bool is_available(InstructionSet set) noexcept;

/// What `best` stands for here.
InstructionSet best_instruction_set() noexcept;

}  // namespace slamicp
