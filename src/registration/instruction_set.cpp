// SPDX-License-Identifier: Apache-2.0
#include <slamicp/registration/instruction_set.hpp>

#include "registration/pass/choose.hpp"

namespace slamicp {
namespace {

#if (defined(__x86_64__) || defined(__i386__)) && (defined(__GNUC__) || defined(__clang__))
bool machine_has(InstructionSet set) noexcept {
  __builtin_cpu_init();
  const bool sse4 = __builtin_cpu_supports("sse4.2") != 0 && __builtin_cpu_supports("popcnt") != 0;
  const bool avx2 = sse4 && __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
                    __builtin_cpu_supports("bmi") != 0 && __builtin_cpu_supports("bmi2") != 0;
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
                      __builtin_cpu_supports("avx512cd") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                      __builtin_cpu_supports("avx512vl") != 0;
  return set == InstructionSet::sse4   ? sse4
         : set == InstructionSet::avx2 ? avx2
                                       : set == InstructionSet::avx512 && avx512;
}
#else
// What was built for a kind of machine, all of it have.
[[maybe_unused]] bool machine_has(InstructionSet) noexcept { return true; }
#endif

}  // namespace

const pass::Passes* passes_of(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::best:
      return passes_of(best_instruction_set());
    case InstructionSet::scalar:
      return nullptr;
    case InstructionSet::portable:
#if SLAMICP_PASS_PORTABLE
      return pass::portable_passes();
#else
      return nullptr;
#endif
    case InstructionSet::sse4:
#if SLAMICP_PASS_SSE4
      if (machine_has(set)) return pass::sse4_passes();
#endif
      return nullptr;
    case InstructionSet::avx2:
#if SLAMICP_PASS_AVX2
      if (machine_has(set)) return pass::avx2_passes();
#endif
      return nullptr;
    case InstructionSet::avx512:
#if SLAMICP_PASS_AVX512
      if (machine_has(set)) return pass::avx512_passes();
#endif
      return nullptr;
    case InstructionSet::neon:
#if SLAMICP_PASS_NEON
      return pass::neon_passes();
#else
      return nullptr;
#endif
  }
  return nullptr;
}

const char* to_string(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::best:
      return "best";
    case InstructionSet::scalar:
      return "scalar";
    case InstructionSet::portable:
      return "portable";
    case InstructionSet::sse4:
      return "sse4";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::neon:
      return "neon";
  }
  return "unknown";
}

bool is_available(InstructionSet set) noexcept {
  return set == InstructionSet::best || set == InstructionSet::scalar || passes_of(set) != nullptr;
}

InstructionSet best_instruction_set() noexcept {
  static const InstructionSet best = [] {
    for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::sse4,
                                     InstructionSet::neon, InstructionSet::portable})
      if (passes_of(set) != nullptr) return set;
    return InstructionSet::scalar;
  }();
  return best;
}

}  // namespace slamicp
