// SPDX-License-Identifier: Apache-2.0
// Built at -O3, and so that a minimum may be taken lane by lane, see cmake/bench.cmake.
#include "brute_force.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SLAMICP_BENCH_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define SLAMICP_BENCH_WIDE
#endif

namespace slamicp::bench {

SLAMICP_BENCH_WIDE float squared_distance_vectorized(const Coordinates<float>& map, float x, float y) {
  float nearest = 3e38F;
  for (std::size_t k = 0; k < map.size; ++k) {
    const float dx = map.x[k] - x;
    const float dy = map.y[k] - y;
    const float distance = dx * dx + dy * dy;
    nearest = distance < nearest ? distance : nearest;
  }
  return nearest;
}

}  // namespace slamicp::bench
