// SPDX-License-Identifier: Apache-2.0
// Built at -O2 without vectorization, see cmake/bench.cmake.
#include <limits>

#include "brute_force.hpp"

namespace slamicp::bench {
namespace {

double squared_distance(const Coordinates<double>& map, std::size_t k, double x, double y) {
  const double dx = map.x[k] - x;
  const double dy = map.y[k] - y;
  return dx * dx + dy * dy;
}

}  // namespace

double squared_distance_scalar(const Coordinates<double>& map, double x, double y) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < map.size; ++k) {
    const double distance = squared_distance(map, k, x, y);
    if (distance < nearest) nearest = distance;
  }
  return nearest;
}

bool any_closer(const Coordinates<double>& map, double x, double y, double squared_limit) {
  for (std::size_t k = 0; k < map.size; ++k)
    if (squared_distance(map, k, x, y) < squared_limit) return true;
  return false;
}

}  // namespace slamicp::bench
