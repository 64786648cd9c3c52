// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace slamicp {

/// A seeded stream of random numbers: xoshiro256** (Blackman and Vigna 2021, "Scrambled linear pseudorandom number
/// generators"), its state filled by SplitMix64 (Steele, Lea, Flood 2014), as its authors advise.
///
/// A plain value: a copy goes on with the same numbers. The same seed gives the same numbers with every compiler,
/// which the distributions of <random> do not promise.
class Random {
 public:
  using State = std::array<std::uint64_t, 4>;

  explicit Random(std::uint64_t seed) noexcept;
  /// @param state  anything but four zeros
  explicit Random(const State& state) noexcept : state_(state) {}

  /// An independent stream for one purpose (a sensor, a person), so that drawing more from one leaves the others alone.
  Random stream(std::uint64_t number) const noexcept;

  /// 64 random bits.
  std::uint64_t bits() noexcept;

  /// In [0, 1), a multiple of 2^-53.
  double uniform() noexcept;

  /// In [lower, upper).
  double uniform(double lower, double upper) noexcept { return lower + (upper - lower) * uniform(); }

  /// Mean 0, standard deviation 1: a ratio of uniforms with the bounds of Leva 1992, "A fast normal random number
  /// generator", ACM TOMS 18(4). One logarithm in about 70 draws, and only to decide, so that a last-bit difference
  /// between mathematics libraries does not show in the numbers.
  double normal() noexcept;

  friend bool operator==(const Random&, const Random&) = default;

 private:
  State state_;
};

}  // namespace slamicp
