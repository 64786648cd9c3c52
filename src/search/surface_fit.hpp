// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include <slamicp/search/neighbour.hpp>
#include <slamicp/search/surface.hpp>

namespace slamicp {

inline constexpr std::size_t max_surface_neighbours = 64;

/// Throws Error where an option is absurd.
void check(const SurfaceOptions& options);

/// A surface, and how far its points are from it.
template <int D>
struct SurfaceFit {
  Surface<D> surface;
  double scatter = 0.0;  // mean square [m^2]
};

/// The line (plane) through the centroid of `found`, square to the direction of least spread.
/// @param point  one of them: sums are relative to it, so that no digits are lost far from the map's origin
/// @param place  gives the coordinates of a number
template <int D, typename Place>
SurfaceFit<D> fit_surface(const Point<D>& point, std::span<const Neighbour> found, const SurfaceOptions& options,
                          const Place& place) noexcept {
  if (found.size() < static_cast<std::size_t>(std::max(options.min_neighbours, D + 1))) return {};
  Vector<D> mean = Vector<D>::Zero();
  Matrix<D, D> scatter = Matrix<D, D>::Zero();
  for (const Neighbour& one : found) {
    const Vector<D> offset = place(one.index) - point;
    mean += offset;
    scatter += offset * offset.transpose();
  }
  const auto count = static_cast<double>(found.size());
  mean /= count;
  scatter = scatter / count - mean * mean.transpose();

  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> eigen;
  if constexpr (D == 2)
    eigen.computeDirect(scatter);
  else
    eigen.compute(scatter);
  // Where the two least spreads are alike (duplicates, points on a line in space) there is no surface.
  const double least = std::max(eigen.eigenvalues()[0], 0.0);
  const double next = eigen.eigenvalues()[1];
  if (!(next > 1e-12) || !(least < 0.9 * next)) return {};
  return {{point + mean, eigen.eigenvectors().col(0), 1.0}, least};
}

/// How far the neighbours that made a surface reach [m]; infinite where it could take more. Rounded up.
inline float surface_window(std::span<const Neighbour> found, const SurfaceOptions& options) noexcept {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if (found.size() < static_cast<std::size_t>(options.neighbours)) return infinity;
  return std::nextafter(static_cast<float>(std::sqrt(found.back().squared_distance)), infinity);
}

}  // namespace slamicp
