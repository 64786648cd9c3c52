// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>

#include <slamicp/simulation/random.hpp>

namespace slamicp {
namespace {

std::uint64_t split_mix(std::uint64_t& counter) noexcept {
  std::uint64_t mixed = counter += 0x9e3779b97f4a7c15U;
  mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
  return mixed ^ (mixed >> 31U);
}

}  // namespace

Random::Random(std::uint64_t seed) noexcept : state_{} {
  for (std::uint64_t& word : state_) word = split_mix(seed);
}

Random Random::stream(std::uint64_t number) const noexcept {
  Random parent = *this;
  std::uint64_t counter = number;
  return Random(parent.bits() ^ split_mix(counter));
}

std::uint64_t Random::bits() noexcept {
  const std::uint64_t result = std::rotl(state_[1] * 5U, 7) * 9U;
  const std::uint64_t shifted = state_[1] << 17U;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() noexcept { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }

double Random::normal() noexcept {
  while (true) {
    const double u = 1.0 - uniform();  // in (0, 1]: it divides, and its logarithm is taken
    const double v = 1.7156 * (uniform() - 0.5);
    const double x = u - 0.449871;
    const double y = std::abs(v) + 0.386595;
    const double q = x * x + y * (0.19600 * y - 0.25472 * x);
    if (q < 0.27597) return v / u;  // surely inside
    if (q > 0.27846) continue;      // surely outside
    if (v * v <= -4.0 * u * u * std::log(u)) return v / u;
  }
}

}  // namespace slamicp
