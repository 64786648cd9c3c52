// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <slamicp/registration/instruction_set.hpp>
#include <slamicp/registration/robust_kernel.hpp>
#include <slamicp/registration/uncertainty.hpp>

namespace slamicp {

/// What a match makes small.
enum class Method {
  point_to_point,                  ///< distance to the nearest map point, eq. (3); solved in closed form
  point_to_line,                   ///< distance to the map's line (2D) or plane (3D) there; Gauss-Newton
  point_to_plane = point_to_line,  ///< the same in 3D
};

/// The inputs of the paper's SLAMICP call, eq. (10), and what steers the solver.
struct IcpOptions {
  Method method = Method::point_to_line;

  /// The paper's *indist* [m]: a point closer than this to the map is an inlier; the solver never uses a pair farther
  /// apart, unless a prior says that the guess may be farther off. Too small loses the robot when it is pushed, too
  /// large pairs obstacles with walls. Above 0.
  double max_correspondence_distance = 0.3;

  /// The paper's *O_t* [m]: a point at least this far from every map point is an outlier. Default: the distance above.
  /// 0.3 m, the paper's value, hides small things near walls. Above 0.
  std::optional<double> outlier_distance{};

  /// What makes an obstacle [m]: a point farther from the map than three quarters of this is a stray. Default: from the
  /// noise of ranges and map, four sigma, 5 cm at least and the outlier distance at most. Too small makes strays of the
  /// map's own errors, too large hides small things near walls. Above 0.
  std::optional<double> obstacle_distance{};

  /// Steps at most. A step costs a search a point. At least 1.
  int max_iterations = 50;

  /// Doubts large residuals, on top of the gate. `none` suits scans whose gate shrinks.
  RobustKernel kernel = RobustKernel::none;
  /// Where the kernel begins to doubt [m]. Above 0.
  double kernel_scale = 0.05;

  /// The solver's gate starts at max_correspondence_distance and shrinks to this [m]: what stands beside a wall then
  /// stops pulling the pose. 0: from the map's spacing, 5 cm at least. Below the thickness of the map's walls it throws
  /// away good pairs. Equal to max_correspondence_distance: the gate stays (the paper's way).
  double final_gate = 0.0;

  /// How much the guess itself counts, as a share of the pairs: point to line then solves as if so many pairs held the
  /// guess in every direction. It keeps a direction that the pairs hardly hold (along a corridor) where the guess has
  /// it, and costs that share of the correction elsewhere. 0: not at all. In [0, 1].
  double guess_share = 0.0;

  /// The match has converged when what is left to move is predicted to be below these. Smaller costs iterations.
  double translation_tolerance = 1e-4;  ///< [m], above 0
  double rotation_tolerance = 1e-4;     ///< [rad], above 0

  /// In the plane the first steps look at every eighth point, then at every fourth, and at all of them as soon as a
  /// step is small: a scan's neighbouring points say much the same. Scans of fewer than 200 points are always looked at
  /// in full. False: every step looks at all points.
  bool coarse_to_fine = true;

  /// How noisy ranges and map are, for the covariance.
  PointNoise noise{};

  /// What matches in the plane are computed with; in space it is always `scalar`. For comparisons.
  InstructionSet instruction_set = InstructionSet::best;

  /// O_t as used.
  double outlier_threshold() const noexcept { return outlier_distance.value_or(max_correspondence_distance); }

  /// The first rule broken, in words a user can act on; empty if none.
  std::string problem() const;
};

/// What to hand out. The pose, the stop reason and the iterations are always there; everything else is computed
/// only when asked for, as in the paper (section 3.3).
struct Outputs {
  bool mean_inlier_distance = false;  ///< the paper's m_d, and how many inliers there are
  bool outlier_indices = false;       ///< the paper's O_indx
  bool outliers_in_map = false;       ///< the paper's O_coords
  bool transformed_scan = false;      ///< the paper's tT, eq. (7)
  bool updated_map = false;           ///< the paper's uM: the map's points, then the outliers
  bool matches = false;               ///< per scan point: map index, distance, class
  bool covariance = false;            ///< how well the pose is held; in the plane, point to line
  bool strays = false;                ///< what obstacles are looked for in, see IcpResult

  static Outputs all() noexcept { return {true, true, true, true, true, true, true, true}; }
};

}  // namespace slamicp
