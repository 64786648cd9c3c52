// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <slamicp/search/line_noise.hpp>

#include "search/surface_fit.hpp"

namespace slamicp {

/// The spread of a line's points, along and across it.
struct LineSpread {
  double across2 = 0.0, along2 = 0.0;  // mean squares [m^2]
  double points = 0.0;
};

inline LineSpread spread_of(std::span<const Neighbour> found, PointView<2> points) noexcept {
  Point2 mean = Point2::Zero();
  for (const Neighbour& one : found) mean += points[static_cast<std::size_t>(one.index)];
  const auto count = static_cast<double>(found.size());
  mean /= count;
  Matrix<2, 2> scatter = Matrix<2, 2>::Zero();
  for (const Neighbour& one : found) {
    const Vector<2> off = points[static_cast<std::size_t>(one.index)] - mean;
    scatter += off * off.transpose() / count;
  }
  const double middle = 0.5 * scatter.trace();
  const double half = std::hypot(0.5 * (scatter(0, 0) - scatter(1, 1)), scatter(0, 1));
  return {std::max(middle - half, 0.0), middle + half, count};
}

/// Values of which the median is wanted.
struct LineSamples {
  static constexpr std::size_t most = 256;
  std::array<double, most> values{};
  std::size_t count = 0;

  void add(double value) noexcept { values[count++] = value; }
  double median() noexcept {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle;
  }
};

/// @param nearest_k  as an index has it
template <typename NearestK>
LineNoise sample_line_noise(PointView<2> points, const SurfaceOptions& surfaces, const NearestK& nearest_k) noexcept {
  if (surfaces.neighbours == 0) return {};
  LineSamples across, windows, turns, counts;
  std::array<Neighbour, max_surface_neighbours> room;
  const std::size_t step = std::max<std::size_t>(1, points.size() / LineSamples::most);
  for (std::size_t k = 0; k < points.size() && across.count < LineSamples::most; k += step) {
    const std::size_t count =
        nearest_k(points[k], surfaces.radius, std::span(room.data(), static_cast<std::size_t>(surfaces.neighbours)));
    if (count < static_cast<std::size_t>(surfaces.min_neighbours)) continue;
    const LineSpread spread = spread_of(std::span(room.data(), count), points);
    if (!(spread.along2 > 0.0)) continue;
    // Of n points on a line the mean square falls short by the two unknowns of the line.
    const double free = spread.points - 2.0;
    across.add(spread.across2 * spread.points / free);
    turns.add(spread.across2 / spread.along2 / free);
    windows.add(std::sqrt(12.0 * spread.along2));
    counts.add(spread.points);
  }
  if (across.count == 0) return {};
  // The median of a chi-squared variable over its mean (Wilson, Hilferty 1931).
  const double points_of_line = counts.median();
  const double third = 1.0 - 2.0 / (9.0 * (points_of_line - 2.0));
  const double median_over_mean = third * third * third;
  return {std::sqrt(across.median() / median_over_mean), windows.median(), points_of_line,
          turns.median() / median_over_mean};
}

}  // namespace slamicp
