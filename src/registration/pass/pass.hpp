// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include <slamicp/registration/robust_kernel.hpp>
#include <slamicp/search/cell_table.hpp>

// What the vector code takes and gives: plain numbers, so that a file compiled for one instruction set shares no
// function with files compiled for another.
namespace slamicp::pass {

/// Scan points side by side in the robot's frame [m], with room for a whole vector behind the last. A point that is
/// no number has x = absent.
struct ScanColumns {
  const float* x;
  const float* y;
  std::uint32_t count;
};
inline constexpr float absent = 1e30F;
inline constexpr float far_away = 1e28F;      // x of a point beyond what any map reaches
inline constexpr std::uint32_t padding = 64;  // floats behind the last point

/// The tables around the robot, row by row, and behind them one for what lies outside.
struct Window {
  const CellTable* const* tables;
  std::int32_t width;
  std::int32_t column, row;  // of the tile that coordinates are relative to
  float cells_per_metre;
  float tile;             // side [m]
  float units_per_metre;  // of CellPlace
};

/// A distance in units of CellPlace, squared, with what rounding can do: less than `sure` is nearer, more than `beyond`
/// is farther, and what lies between is decided in double.
struct Limit {
  std::uint32_t sure, beyond;
};

/// T_map_robot, relative to the lower corner of the tile the robot is in.
struct Place {
  float cosine, sine, x, y;
};

struct Request {
  ScanColumns scan;
  std::uint32_t stride;  // every so many-th point, beginning in the middle of the first stride
  Window window;
  Place place;
  Limit gate;
  bool looks_farther;  // than the tables reach: what they do not find is undecided
  RobustKernel kernel;
  float kernel_scale;
  const double* map_points;   // x, y by number [m], for `points`
  double corner_x, corner_y;  // what Place is relative to [m]
  std::uint32_t* undecided;   // room for every point: gets those that are to be looked at in double
  bool noise;                 // for `lines`: sum LineSums::noise too
  float ray_x, ray_y;         // where the rays start, in the map's axes from the robot [m]
  float sharing;              // how many rays meet one line, a metre away and head on [m]
};

/// A symmetric matrix of the unknowns (x, y, turn).
struct Square {
  double xx, xy, yy, xt, yt, tt;
};

/// What the covariance needs, sums over the pairs with j the derivative of a pair's residual: see NoiseSums.
struct LineNoiseSums {
  Square by_range;                                     // w^2 cos^2(incidence) j j^T
  Square by_map;                                       // w^2 sharing j j^T
  Square together;                                     // of neighbouring pairs' w residual j, Bartlett's weights
  double weights, x, y, squared_ranges;                // w, w p, w p^2: p from the robot, in the map's axes
  double squared_residuals, squared_cosines, sharing;  // w r^2, w cos^2, w^2 sharing
};

/// Normal equations of the distances to lines, in the map's axes: unknowns (x, y, turn about the robot).
struct LineSums {
  double xx, xy, yy, xt, yt, tt;  // information
  double x, y, t;                 // gradient
  double squared_ranges;          // of the pairs [m^2]
  std::uint32_t pairs;
  std::uint32_t undecided;
  LineNoiseSums noise;  // where asked for
};

/// What the closed form needs, sums over the pairs with their weights: p in the robot's frame, m in the map's axes,
/// relative to the same corner as Place.
struct PointSums {
  double weight, px, py, mx, my;
  double mx_px, mx_py, my_px, my_py;
  double squared_ranges;
  std::uint32_t pairs;
  std::uint32_t undecided;
};

/// In OutlierRequest::found: the point has to be looked at in double.
inline constexpr std::uint32_t unsure = 1U << 31U;

struct OutlierRequest {
  ScanColumns scan;
  Window window;
  Place place;
  Limit threshold;
  bool looks_farther;          // than the tables reach
  std::uint32_t sure_inside;   // a cell whose bound from above is at most this is inside the threshold
  std::uint32_t sure_outside;  // a cell whose bound from below is at least this is outside
  std::uint32_t* found;        // room for every point
};

/// In MatchRequest::numbers.
inline constexpr std::int32_t no_match = -1;
inline constexpr std::int32_t ask = -2;

struct MatchRequest {
  ScanColumns scan;
  Window window;
  Place place;
  Limit reach;            // of the tables
  float margin;           // in units of CellPlace: two points as alike as this in distance are told apart in double
  const double* scan_xy;  // the same points in double
  double cosine, sine, translation_x, translation_y;  // T_map_robot
  const double* map_points;                           // x, y by number [m]
  std::int32_t* numbers;                              // of the nearest points within the tables' reach
  double* squared_distances;                          // to them [m^2]
  double* distances;                                  // [m]
};

/// The passes, compiled for one instruction set.
struct Passes {
  /// Doubles (x, y) to columns. Returns how many points are numbers; `farthest` becomes their largest coordinate, but
  /// for those beyond 10 km, which count as `far_ones`.
  std::uint32_t (*to_columns)(const double* xy, std::uint32_t count, float* x, float* y, float* farthest,
                              std::uint32_t* far_ones) noexcept;
  void (*lines)(const Request&, LineSums*) noexcept;
  void (*points)(const Request&, PointSums*) noexcept;
  /// The points at least the threshold from every map point, rising, some with `unsure`. Returns how many.
  std::uint32_t (*outliers)(const OutlierRequest&) noexcept;
  void (*matches)(const MatchRequest&) noexcept;
};

// Null where the library was built without.
const Passes* avx512_passes() noexcept;
const Passes* avx2_passes() noexcept;
const Passes* sse4_passes() noexcept;
const Passes* neon_passes() noexcept;
const Passes* portable_passes() noexcept;

}  // namespace slamicp::pass
