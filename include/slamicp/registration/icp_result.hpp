// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <slamicp/geometry/pose.hpp>
#include <slamicp/registration/uncertainty.hpp>

namespace slamicp {

/// Why a match ended.
enum class Stop {
  converged,       ///< what is left to move is below the tolerances
  max_iterations,  ///< it was still moving
  /// Some direction is not held by any pair, or, where a prior takes part, no better than the noise of the map's
  /// normals pretends. The pose keeps the guess there, or follows the prior.
  degenerate,
  too_few_points,  ///< the scan has too few usable points; the pose is the guess
  no_overlap,      ///< too few pairs within the gate; the pose is the guess
};

/// "converged", "max_iterations", ...
const char* to_string(Stop stop) noexcept;

/// What a scan point is to the map, at the final pose.
enum class PointClass : unsigned char {
  neither,  ///< between the two distances, or not a finite point
  inlier,   ///< closer than max_correspondence_distance
  outlier,  ///< at least outlier_distance from every map point
  both,     ///< where outlier_distance < max_correspondence_distance: closer than the one, beyond the other
};

inline bool is_inlier(PointClass c) noexcept { return c == PointClass::inlier || c == PointClass::both; }
inline bool is_outlier(PointClass c) noexcept { return c == PointClass::outlier || c == PointClass::both; }

/// A scan point's nearest map point, at the final pose.
struct Match {
  int map_index = -1;                                         ///< -1: none closer than the larger of the two distances
  double distance = std::numeric_limits<double>::infinity();  ///< to that point [m]
  PointClass point_class = PointClass::neither;
};

/// The outputs of the paper's SLAMICP call, eq. (10). What was not asked for is empty.
///
/// Inliers and outliers are judged by the Euclidean distance to the nearest map point at the final pose, with the
/// distances as the options give them, for every method.
template <int D>
struct IcpResult {
  Pose<D> pose;                       ///< T_map_robot (T_target_source): the paper's P
  Stop stop = Stop::too_few_points;   ///< why it ended
  int iterations = 0;                 ///< steps made: the paper's n
  std::size_t pairs = 0;              ///< pairs that held the last step
  std::size_t inliers = 0;            ///< with mean_inlier_distance or matches
  double mean_inlier_distance = 0.0;  ///< [m], the paper's m_d; 0 without inliers
  std::vector<int> outlier_indices;   ///< into the scan, rising: the paper's O_indx (counted from 0)
  PointCloud<D> outliers_in_map;      ///< one for each index: the paper's O_coords
  PointCloud<D> transformed_scan;     ///< one for each scan point: the paper's tT
  PointCloud<D> updated_map;          ///< the paper's uM
  std::vector<Match> matches;         ///< one for each scan point
  /// Points farther from every map point than noise explains, rising: at least `stray_share` of the obstacle distance.
  /// Outliers are among them where the outlier distance is no smaller.
  std::vector<int> stray_indices;
  double obstacle_distance = 0.0;              ///< as used, with strays [m]; 0 without
  static constexpr double stray_share = 0.75;  ///< three sigma, where the obstacle distance is four

  /// How well the pairs of the last step hold the pose, in the plane, point to line. A prior has no part in it.
  Uncertainty uncertainty;

  std::size_t searches = 0;              ///< nearest-neighbour searches made for the pose
  std::size_t searches_for_outputs = 0;  ///< made after the pose was final: only where a neighbour may have changed

  /// True if the pose can be used: it was found from enough pairs, every direction held. A match that ran out of
  /// iterations counts; `stop` tells it from one that converged.
  bool usable() const noexcept { return stop == Stop::converged || stop == Stop::max_iterations; }

  /// One line: stop reason, iterations, pose, and what was asked for.
  std::string brief() const;
};

using IcpResult2 = IcpResult<2>;
using IcpResult3 = IcpResult<3>;

}  // namespace slamicp
