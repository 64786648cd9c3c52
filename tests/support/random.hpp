// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

#include <slamicp/geometry/pose.hpp>

namespace slamicp::test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double pi = std::numbers::pi;

/// Of many rounds or seeds one in so many is tried: not all where each takes ten times as long, as under a sanitizer.
#ifdef SLAMICP_FEWER_SEEDS
constexpr int one_in = 8;
#else
constexpr int one_in = 1;
#endif

/// How many seeds to try a property with.
constexpr std::uint64_t seeds(std::uint64_t all) noexcept { return (all + one_in - 1) / one_in; }

/// Seeded numbers for a test: the seed goes into SCOPED_TRACE, so that a failure can be repeated.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double lower, double upper) { return std::uniform_real_distribution<>(lower, upper)(engine_); }
  double normal(double sigma) { return sigma * std::normal_distribution<>()(engine_); }
  /// In [lower, upper], both included.
  int integer(int lower, int upper) { return std::uniform_int_distribution<>(lower, upper)(engine_); }
  bool chance(double share) { return uniform(0.0, 1.0) < share; }

  template <int D>
  Point<D> point(double half_width) {
    Point<D> point;
    for (int axis = 0; axis < D; ++axis) point[axis] = uniform(-half_width, half_width);
    return point;
  }

  /// A motion of at most so many metres along each axis and radians about each.
  template <int D>
  Pose<D> pose(double metres, double radians) {
    typename Pose<D>::Tangent tangent;
    for (int k = 0; k < Pose<D>::degrees_of_freedom; ++k)
      tangent[k] = k < D ? uniform(-metres, metres) : uniform(-radians, radians);
    return Pose<D>::exp(tangent);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace slamicp::test
