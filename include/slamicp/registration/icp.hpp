// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <slamicp/registration/icp_options.hpp>
#include <slamicp/registration/icp_result.hpp>
#include <slamicp/search/indexed_points.hpp>

namespace slamicp {

/// Registers scans to a map by the iterative closest point method (Besl, McKay 1992; Chen, Medioni 1992).
///
/// Keeps its memory from one scan to the next: after the first scan of a size nothing is allocated, but for
/// `updated_map` where the map has grown. An Icp belongs to one thread; the map may be shared.
template <int D>
class Icp {
 public:
  /// Throws Error with options.problem().
  explicit Icp(const IcpOptions& options = {});
  ~Icp();
  Icp(Icp&&) noexcept;
  Icp& operator=(Icp&&) noexcept;

  /// @param map     M, with surfaces where the method is point_to_line
  /// @param scan    T, in the robot's frame; points that are not finite take no part
  /// @param guess   where the robot should be: the paper's P_(i-1)
  /// @param wanted  what to compute besides the pose
  /// @param prior   what is known before, in the plane: from point to line it takes part by its information, as the
  ///                pairs do by theirs
  /// @returns the result, valid until the next call. Complexity: iterations x L searches.
  /// Throws Error if the guess is not finite or the map lacks the surfaces that the method needs.
  const IcpResult<D>& align(const IndexedPoints<D>& map, PointView<D> scan, const Pose<D>& guess,
                            const Outputs& wanted = {}, const PosePrior& prior = {});

  /// How the rays of the scans to come lie, for the covariance and a prior's weight.
  void set_rays(const Rays& rays) noexcept;

  /// Makes room for scans of up to so many points, so that a later scan with more returns or more outliers than the
  /// first allocates nothing either.
  void reserve(std::size_t points);

  const IcpResult<D>& result() const noexcept;
  const IcpOptions& options() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One scan against one cloud, index and surfaces included: for a single match. Whoever matches many scans against
/// one map keeps an IndexedPoints and an Icp.
/// @returns T_target_source and what was asked for
template <int D>
IcpResult<D> align(const PointCloud<D>& source, const PointCloud<D>& target, const Pose<D>& guess = {},
                   const IcpOptions& options = {}, const Outputs& wanted = Outputs::all());

extern template class Icp<2>;
extern template class Icp<3>;

}  // namespace slamicp
